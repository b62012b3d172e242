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
// event before, and nothing tells which of the two is first. chosen: it shared a ball with another one of the same
// time. a, b: the balls right after it; b is empty for a plane or a wall.
template <int N>
struct certified_event {
    graze::scene_pair who;
    certified time;
    bool tied, either_order, chosen;
    graze::ball<N, certified> a;
    std::optional<graze::ball<N, certified>> b;
};

// A proof: these events, in this order, and no others until the end. Each has passed event_check.
template <int N>
struct certified_result {
    std::vector<certified_event<N>> events;
    graze::ending why = graze::ending::stopped;
    std::vector<graze::participant> jammed; // of a cascade
    std::string problem; // what ended it early, if something did: an open decision, two mirrors that meet
    certified end;       // the time of the end: that asked for, or of the last event
    std::vector<graze::ball<N, certified>> balls; // at the end
    long bits = 0;                                // of the last attempt's intervals
    int attempts = 0;
    double seconds = 0;
    int digits = 0; // that every coordinate has at the end; fewer than wanted only where most_bits do not reach
};

// Runs the scene in intervals, with ever more bits, from the start, until every decision is certain and the digits
// hold. What is known when a decision is open at most_bits, or the user interrupts, is returned. Throws input_error for
// a scene that cannot be run, and refuted_event for an event that event_check refutes.
template <int N>
[[nodiscard]] certified_result<N> certified_run(const exact_scene<N>& scene, const extent& how_far,
                                                const certainty& wanted, const progress_line& line);

// The decimal digits after the point to which intervals around all of these hold, at least; large for rationals alone.
[[nodiscard]] long decimals_of(const certified& x);

// x with so many digits after the point, off by at most one unit of the last one where the interval is as narrow.
[[nodiscard]] std::string decimal_text(const certified& x, long decimals);

} // namespace compare::run
