// The common definition of the two files of exact runs.
#pragma once

#include "exact_runs.hpp"

template <int N>
finished_run<N> run_exactly(const graze::scene<N>& scene, const graze::run_limits<double>& limits,
                            const std::function<bool(const exact_event<N>&)>& observer, graze::cells cells) {
    graze::run<graze::exact_mechanics<N>> run(scene, {}, cells);
    finished_run<N> result;
    result.outcome = run.advance(limits, [&](const exact_event<N>& e) { return !observer || observer(e); });
    for (int i = 0; i < run.balls(); ++i) {
        result.flights.push_back(run.in_flight(i));
    }
    return result;
}
