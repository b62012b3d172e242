// The run in graze's doubles, compiled once for the examples and the tests: each dimension takes half a minute.
#pragma once

#include <graze/run.hpp>

#include <functional>
#include <vector>

template <int N>
using exact_event = graze::run_event<graze::exact_mechanics<N>>;

template <int N>
struct finished_run {
    graze::outcome outcome;
    std::vector<graze::flight<N>> flights; // of the balls, by the scene's indices
};

// A whole run. The observer may be empty; false stops the run.
template <int N>
[[nodiscard]] finished_run<N> run_exactly(const graze::scene<N>& scene, const graze::run_limits<double>& limits,
                                          const std::function<bool(const exact_event<N>&)>& observer = {},
                                          graze::cells cells = graze::cells::where_useful);
