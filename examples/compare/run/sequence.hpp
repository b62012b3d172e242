// The true sequence of events, and how a number type's compares with it.
#pragma once

#include "certified_run.hpp"

#include "../wide.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace compare::run {

// The proved run in numbers of wide_digits bits: who met, whether it may as well be told before the step before, and
// where the balls that took part were then; b is a's place where a plane or wall was met.
template <int N>
struct true_step {
    graze::scene_pair who;
    bool exchangeable;
    graze::vec<N, wide> a, b;
};

// size: the longest side of the smallest box around all these places of balls that move; errors are relative to it.
template <int N>
struct true_sequence {
    std::vector<true_step<N>> steps;
    std::vector<graze::vec<N, wide>> end; // of each ball, if the run got to its end
    double size = 1;
    std::optional<std::size_t> distance_of; // the ball whose distance from the origin is what counts at the end
    graze::vec<N, wide> period{};           // of the scene: places are alike that are whole periods apart
};

template <int N>
[[nodiscard]] true_sequence<N> sequence_of(const certified_result<N>& proved, const exact_scene<N>& scene);

// Where a ball went in the plane: its start, its events and the end; (time, x, y).
using path = std::vector<std::array<double, 3>>;

// How much of the proved sequence a type was run for: all of it; a part, for the user interrupted it; nothing.
enum class comparison { whole, part, none };

[[nodiscard]] const char* to_string(comparison c) noexcept;

// What became of a run in a number type.
struct history {
    std::string type, library;
    comparison compared = comparison::whole;
    std::vector<graze::scene_pair> events;
    std::vector<double> times;
    std::vector<double> digits;       // at each event, while they are the true ones: decimal, of the worse ball's place
    std::optional<double> end_digits; // at the end, if all events are the true ones: of the worst ball's place
    std::optional<double> energy_drift, momentum_drift; // at the end, relative; momentum where nothing takes any
    double events_per_second = 0;
    std::string problem; // what ended it early, if something did
    std::vector<path> paths;
};

// Judges events as they are told. Only a type's TU converts its numbers to wide; the rest is compiled once.
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

// What the first wrong event is. At most one of the three holds: the type has an event that does not happen, or lacks
// one that does, or has two in another order; with neither the two sequences go apart.
enum class mistake { none, missed, invented, out_of_order, other };

[[nodiscard]] const char* to_string(mistake m) noexcept;

struct first_mistake {
    mistake what = mistake::none;
    std::size_t at = 0; // how many events before it are right
    double time = 0;    // about when
    std::string text;   // "ball 3 and wall 0 is missed"
};

// Of what was not run nothing is said, nor of what comes after the last event that is proved.
template <int N>
[[nodiscard]] first_mistake first_mistake_of(const history& found, const certified_result<N>& proved);

} // namespace compare::run
