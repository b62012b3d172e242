// The true sequence of events, and how a number type's sequence compares with it.
#pragma once

#include "certified_run.hpp"

#include "../wide.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace compare::run {

// An event of the proved run in numbers of wide_digits bits: who met, whether it may be exchanged with the event
// before, and where the balls were. b is a's place if a met a plane, a wall or a triangle.
template <int N>
struct true_step {
    graze::scene_pair who;
    bool exchangeable;
    graze::vec<N, wide> a, b;
};

// size: the longest side of the smallest box around all places of moving balls; errors are relative to it.
template <int N>
struct true_sequence {
    std::vector<true_step<N>> steps;
    std::vector<graze::vec<N, wide>> end; // the place of each ball, if the run got to its end
    double size = 1;
    std::optional<std::size_t> distance_of; // the ball whose distance from the origin is judged at the end
    graze::vec<N, wide> period{};           // the scene's: places whole periods apart are the same
};

template <int N>
[[nodiscard]] true_sequence<N> sequence_of(const certified_result<N>& proved, const exact_scene<N>& scene);

// Where a ball went in the plane: its start, its events and the end; (time, x, y).
using path = std::vector<std::array<double, 3>>;

// How much of the proved sequence a type was run for: all; a part, because the user interrupted it; nothing.
enum class comparison { whole, part, none };

[[nodiscard]] const char* to_string(comparison c) noexcept;

// The record of a run in a number type.
struct history {
    std::string type, library;
    comparison compared = comparison::whole;
    std::vector<graze::scene_pair> events;
    std::vector<double> times;
    std::vector<double> digits;       // decimal, of the worse ball's place, at each event until the first wrong one
    std::optional<double> end_digits; // of the worst ball's place at the end, if all events are right
    std::optional<double> energy_drift, momentum_drift; // relative, at the end; momentum only if nothing absorbs it
    double events_per_second = 0;
    std::string problem; // what ended the run early, if something did
    std::vector<path> paths;
};

// Judges events as they come. Only a type's translation unit converts its numbers to wide; the rest is compiled once.
template <int N>
class judge {
  public:
    using place = std::optional<graze::vec<N, wide>>; // empty: not finite
    explicit judge(const true_sequence<N>& truth, history& found) : truth_(truth), found_(found) {}

    void event(graze::scene_pair who, double time, const place& a, const place& b);
    void end(const std::vector<place>& balls);

  private:
    const true_sequence<N>& truth_;
    history& found_;
    std::vector<bool> taken_; // of truth_.steps
    bool right_ = true;
};

// What is wrong about the first wrong event: the type lacks an event that happens, has one that does not, or has two in
// the wrong order. other: none of these, or the run failed there.
enum class mistake { none, missed, invented, out_of_order, other };

[[nodiscard]] const char* to_string(mistake m) noexcept;

struct first_mistake {
    mistake what = mistake::none;
    std::size_t at = 0; // the number of right events before it
    double time = 0;    // its approximate time
    std::string text;   // "ball 3 and wall 0 is missed"
};

// Judges neither what was not run nor what comes after the last proved event.
template <int N>
[[nodiscard]] first_mistake first_mistake_of(const history& found, const certified_result<N>& proved);

} // namespace compare::run
