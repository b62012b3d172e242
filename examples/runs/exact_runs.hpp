// A whole run in graze's doubles, for the examples and the tests.
#pragma once

#include <graze/run.hpp>

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

template <int N>
using exact_event = graze::run_event<graze::exact_mechanics<N>>;

template <int N>
struct finished_run {
    graze::outcome outcome;
    std::vector<graze::flight<N>> flights; // of the balls, by the scene's indices
};

// Keeps a run's clock between `by` and about twice that, so that times stay as fine as they are then. Checks the clock
// every so many events. told: called after the clock was set back by `by`.
struct clock_keeping {
    double by = std::numeric_limits<double>::infinity();
    std::uint64_t events = 1000;
    std::function<void()> told{};
};

// A whole run. The observer may be empty; if it returns false, the run stops. The limits are in the clock of the start.
template <int N>
[[nodiscard]] finished_run<N> run_exactly(const graze::scene<N>& scene, const graze::run_limits<double>& limits,
                                          const std::function<bool(const exact_event<N>&)>& observer = {},
                                          graze::cells cells = graze::cells::where_useful,
                                          const clock_keeping& clock = {});
