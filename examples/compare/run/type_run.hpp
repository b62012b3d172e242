// A run in a number type: recorded and judged first, then timed.
#pragma once

#include "runnable.hpp"
#include "scene_in.hpp"

#include "../answer_reader.hpp"
#include "../exact_access.hpp"
#include "../reader.hpp"
#include "../stopwatch.hpp"

#include <graze/run/run.hpp>

#include <cmath>
#include <functional>
#include <limits>

namespace compare::run {

// An infinite mass in T.
template <class T>
[[nodiscard]] T infinite_mass() {
    return T(std::numeric_limits<double>::infinity());
}

template <class T>
[[nodiscard]] std::optional<wide> wide_or_nothing(const T& x) {
    const exact none = 0;
    const exact_view nothing = exact_access::view(none);
    computed_sink told;
    reader<T>::read(x, {{nothing, nothing, nothing}, told});
    const auto* number = std::get_if<wide>(&told.value().value());
    return number != nullptr ? std::optional<wide>(*number) : std::nullopt;
}

template <int N, class T>
[[nodiscard]] std::optional<graze::vec<N, wide>> wide_or_nothing(const graze::vec<N, T>& x) {
    graze::vec<N, wide> result{};
    for (int i = 0; i < N; ++i) {
        const std::optional<wide> component = wide_or_nothing(x[i]);
        if (!component) {
            return {};
        }
        result[i] = *component;
    }
    return result;
}

template <class M>
class type_run {
  public:
    static constexpr int N = M::dimension;
    using number = typename M::number;
    using place = typename judge<N>::place;

    type_run(const exact_scene<N>& scene, const true_sequence<N>& truth, const run_plan& plan)
        : scene_(scene), truth_(truth), plan_(plan),
          own_(scene_in<number>(scene, infinite_mass<number>(), [](const exact& x) { return convert<number>(x); })) {
        // A wrong sequence may have many more events than the true one.
        limits_.events = plan.how_far.events.value_or(2 * truth.steps.size() + 1000);
        limits_.jam = plan.how_far.jam;
        if (plan.how_far.until) {
            limits_.time = convert<number>(*plan.how_far.until);
        }
    }

    [[nodiscard]] history recorded() {
        history found;
        try {
            graze::run<M> run(own_.view());
            const graze::run<M> fresh(run);
            judge<N> events(truth_, found);
            start_paths(found, run);
            std::uint64_t done_yet = 0;
            const observer watch([&](const graze::run_event<M>& e) {
                const place a = wide_or_nothing(e.after_a.state.position);
                events.event(e.who, about(run.rules(), e.when), a,
                             e.after_b ? wide_or_nothing(e.after_b->state.position) : a);
                add_to_path(found, e.who.a, run.rules().about(e.after_a));
                if (e.after_b != nullptr) {
                    add_to_path(found, e.who.b, run.rules().about(*e.after_b));
                }
                if (++done_yet % 1024 == 0 && plan_.show_progress) {
                    plan_.show_progress(done_yet, about(run.rules(), e.when));
                }
                return !interrupted();
            });
            const graze::outcome done = run.advance(limits_, watch);
            if (done.why == graze::ending::stopped) {
                found.compared = comparison::part;
                return found;
            }
            if (done.why == graze::ending::cascade) {
                found.problem = "events without end while time stands still";
            }
            finish(found, events, run);
            measure(found, fresh);
        } catch (const std::exception& error) {
            found.problem = error.what();
        }
        return found;
    }

  private:
    using observer = std::function<bool(const graze::run_event<M>&)>; // for both runs: advance is compiled once

    const exact_scene<N>& scene_;
    const true_sequence<N>& truth_;
    const run_plan& plan_;
    owned_scene<N, number> own_;
    graze::run_limits<number> limits_;

    [[nodiscard]] static double about(const M& mechanics, const typename M::time& t) {
        const graze::time_bounds bounds = mechanics.bounds(t);
        return bounds.lower + (bounds.upper - bounds.lower) / 2;
    }

    void start_paths(history& found, const graze::run<M>& run) const {
        if (N == 2 && plan_.with_paths) {
            found.paths.resize(scene_.balls.size());
            for (int i = 0; i < run.balls(); ++i) {
                add_to_path(found, i, run.rules().about(run.in_flight(i)));
            }
        }
    }
    static void add_to_path(history& found, int ball, const graze::flight<N, double>& f) {
        if (!found.paths.empty()) {
            found.paths[static_cast<std::size_t>(ball)].push_back({f.since, f.state.position[0], f.state.position[1]});
        }
    }

    void finish(history& found, judge<N>& events, const graze::run<M>& run) const {
        const number end = limits_.time && found.problem.empty() ? *limits_.time : last_time(run);
        std::vector<place> places;
        for (int i = 0; i < run.balls(); ++i) {
            const auto& f = run.in_flight(i);
            const number fly =
                scene_.balls[static_cast<std::size_t>(i)].inverse_mass.is_zero() ? number(0) : number(end - f.since);
            const auto at = graze::position_at(f.state.position, f.state.velocity, fly);
            places.push_back(wide_or_nothing(at));
            if (!found.paths.empty()) {
                found.paths[static_cast<std::size_t>(i)].push_back(
                    {static_cast<double>(end), static_cast<double>(at[0]), static_cast<double>(at[1])});
            }
        }
        events.end(places);
        drift(found, run);
    }
    [[nodiscard]] static number last_time(const graze::run<M>& run) {
        number last(0);
        for (int i = 0; i < run.balls(); ++i) {
            const number& since = run.in_flight(i).since;
            last = last < since ? since : last;
        }
        return last;
    }

    void drift(history& found, const graze::run<M>& run) const {
        wide energy = 0, before = 0, momentum = 0;
        graze::vec<N, wide> gained{};
        bool alone = own_.planes.empty() && own_.walls.empty() && own_.triangles.empty(); // nothing absorbs momentum
        for (std::size_t i = 0; i < scene_.balls.size(); ++i) {
            if (scene_.balls[i].inverse_mass.is_zero()) {
                alone = false;
                continue;
            }
            const auto now = wide_or_nothing(run.in_flight(static_cast<int>(i)).state.velocity);
            const auto then = wide_or_nothing(own_.balls[i].velocity);
            if (!now || !then) {
                return;
            }
            const wide m = to_wide(scene_.balls[i].shape.mass);
            for (int k = 0; k < N; ++k) {
                energy += m * (*now)[k] * (*now)[k];
                before += m * (*then)[k] * (*then)[k];
                gained[k] += m * ((*now)[k] - (*then)[k]);
                momentum += abs(m * (*then)[k]);
            }
        }
        if (before > 0) {
            found.energy_drift = static_cast<double>(abs(energy - before) / before);
            wide largest = 0;
            for (int k = 0; k < N; ++k) {
                largest = std::max(largest, wide(abs(gained[k])));
            }
            if (alone) {
                found.momentum_drift = static_cast<double>(largest / momentum);
            }
        }
    }

    void measure(history& found, const graze::run<M>& fresh) const {
        if (found.events.empty() || !(plan_.timing > 0)) {
            return;
        }
        const observer nobody([](const graze::run_event<M>&) { return !interrupted(); });
        double spent = 0;
        std::uint64_t events = 0;
        while (spent < plan_.timing && !interrupted()) {
            graze::run<M> run(fresh);
            const stopwatch watch;
            events += run.advance(limits_, nobody).events;
            spent += watch.seconds();
        }
        found.events_per_second = spent > 0 ? static_cast<double>(events) / spent : 0;
    }
};

template <class M>
[[nodiscard]] history run_type(const exact_scene<M::dimension>& scene, const true_sequence<M::dimension>& truth,
                               const run_plan& plan) {
    return type_run<M>(scene, truth, plan).recorded();
}

} // namespace compare::run
