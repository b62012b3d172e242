// The common definition of the two files of exact runs.
#pragma once

#include "exact_runs.hpp"

#include <algorithm>
#include <utility>

template <int N>
finished_run<N> run_exactly(const graze::scene<N>& scene, const graze::run_limits<double>& limits,
                            const std::function<bool(const exact_event<N>&)>& observer, graze::cells cells,
                            const clock_keeping& clock) {
    graze::run<graze::exact_mechanics<N>> run(scene, {}, cells);
    const bool is_kept = clock.by < std::numeric_limits<double>::infinity();
    finished_run<N> result{};
    graze::outcome& all = result.outcome;
    graze::run_limits<double> some = limits;
    double now = 0;
    do {
        some.events = limits.events - all.events;
        some.events = is_kept ? std::min(clock.events, some.events) : some.events;
        graze::outcome done = run.advance(some, [&](const exact_event<N>& e) {
            now = std::max(e.after_a.since, e.after_b ? e.after_b->since : e.after_a.since);
            return !observer || observer(e);
        });
        done.events += all.events;
        done.choices += all.choices;
        all = std::move(done);
        if (is_kept && now >= 2 * clock.by && run.set_clock_back(clock.by)) {
            now -= clock.by;
            if (some.time) {
                *some.time -= clock.by;
            }
            if (clock.told) {
                clock.told();
            }
        }
    } while (all.why == graze::ending::events && all.events < limits.events);
    for (int i = 0; i < run.balls(); ++i) {
        result.flights.push_back(run.in_flight(i));
    }
    return result;
}
