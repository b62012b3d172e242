// A ball of a run, and how a new state of it compares with its present one.
#pragma once

#include <graze/formula/contact.hpp>
#include <graze/scene/body.hpp>
#include <graze/shape/flight.hpp>

#include <algorithm>
#include <cmath>

namespace graze::inline v0_1::detail {

// last: the body that it met last. stopped: it was jammed and no longer takes part.
template <class State>
struct mover {
    State state;
    body last = no_body;
    bool immovable = false;
    bool point = false;
    bool stopped = false;
};

template <int N>
[[nodiscard]] constexpr bool is_same_flight(const flight<N, double>& f, const flight<N, double>& g) {
    return f.since == g.since && f.state.position == g.state.position && f.state.velocity == g.state.velocity;
}

// Whether g starts where f is at that time, but for rounding to floats.
template <int N>
[[nodiscard]] bool is_on_the_way(const flight<N, double>& f, const flight<N, double>& g) {
    const auto there = position_at(f.state.position, f.state.velocity, g.since - f.since);
    for (int i = 0; i < N; ++i) {
        const double far = std::max(std::fabs(f.state.position[i]), std::fabs(there[i]));
        if (!(std::fabs(there[i] - g.state.position[i]) <= 0x1p-20 * far)) {
            return false;
        }
    }
    return true;
}

} // namespace graze::inline v0_1::detail
