// The proved run of a scene.
#pragma once

#include "certified_mechanics.hpp"
#include "event_check.hpp"
#include "extent.hpp"

#include "../progress.hpp"

#include <graze/run/outcome.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace compare::run {

// who: by the scene's indices. tied: at exactly the time of the event before. either_order: it shares no ball with the
// event before, and which of the two is first is unknown. chosen: it shared a ball with another event at the same time.
// a, b: the balls right after the event; b is empty for a plane, a wall or a triangle.
template <int N>
struct certified_event {
    graze::scene_pair who;
    certified time;
    bool tied, either_order, chosen;
    graze::ball<N, certified> a;
    std::optional<graze::ball<N, certified>> b;
};

// A proof that these events happen in this order, and no others until `end`. Each has passed event_check.
template <int N>
struct certified_result {
    std::vector<certified_event<N>> events;
    graze::ending why = graze::ending::stopped;
    std::vector<graze::participant> jammed; // of a cascade
    std::string problem; // what ended the run early, if something did: an open decision, two mirrors that meet
    certified end;       // when the run ended: the time asked for, or that of the last event
    std::vector<graze::ball<N, certified>> balls; // at the end
    long bits = 0;                                // the precision of the last attempt's intervals
    int attempts = 0;
    double seconds = 0;
    int digits = 0; // that every coordinate has at the end; fewer than wanted only if most_bits do not suffice
};

// Runs the scene from the start in intervals, with more bits each time, until every decision is certain and the digits
// are reached. If a decision is open at most_bits, or the user interrupts, it returns what is known. Throws input_error
// if the scene cannot be run, and refuted_event if event_check refutes an event.
template <int N>
[[nodiscard]] certified_result<N> certified_run(const exact_scene<N>& scene, const extent& how_far,
                                                const certainty& wanted, const progress_line& line);

// How many decimal digits after the point the interval around x determines, at least; a large number if x is rational.
[[nodiscard]] long decimals_of(const certified& x);

// x with this many digits after the point. If its interval is narrow enough, off by at most one unit of the last.
[[nodiscard]] std::string decimal_text(const certified& x, long decimals);

} // namespace compare::run
