// Steps of a run beside its events: other states, jams, what ends it.
#pragma once

#include <graze/run/forecast.hpp>
#include <graze/run/jam.hpp>
#include <graze/run/outcome.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace graze::inline v0_1::detail {

// The time `now` of an event as a state holds it, perhaps rounded to a float; not after `now`.
template <class T>
[[nodiscard]] double as_states_have(double now) {
    if constexpr (std::floating_point<T>) {
        return std::min(now, static_cast<double>(static_cast<T>(now)));
    } else {
        return now;
    }
}

// The fault of another state of ball a, or nullptr, by its roundings to doubles. Roundings of two equal times differ by
// no more than 2^-49 of them.
template <mechanics M>
[[nodiscard]] const char* fault_of_state(const moving_scene<M>& scene, body a, const typename M::state& other,
                                         double now) {
    const flight<M::dimension, double> was = scene.rules().about(scene[a].state);
    const flight<M::dimension, double> is = scene.rules().about(other);
    return !is_finite(is.state.position)         ? "position is not finite"
           : !is_finite(is.state.velocity)       ? "velocity is not finite"
           : !is_finite_input(is.since)          ? "time is not finite"
           : is.state.radius != was.state.radius ? "radius has changed"
           : is.state.mass != was.state.mass     ? "mass has changed"
           : !scene[a].immovable && is.since + std::fabs(is.since) * 0x1p-48 < now
               ? "state is earlier than the last event"
               : nullptr;
}

// A double that is not before a time.
template <mechanics M>
[[nodiscard]] double not_before(const M& rules, const typename M::number& instant) {
    using number = typename M::number;
    const auto all = make_vec<M::dimension>([&](int) { return instant; });
    const double near = rules.about(rules.start({all, all, number(0), number(1)})).state.position[0];
    return near + std::fabs(near) * 0x1p-49 + std::numeric_limits<double>::min();
}

// A double that is not before a time limit. Throws std::domain_error if that is not a number.
template <mechanics M>
[[nodiscard]] double end_of(const M& rules, const std::optional<typename M::number>& limit) {
    if (limit && graze::sign(*limit) == 0 && !is_finite_number(*limit)) {
        throw std::domain_error("the time limit is not a number");
    }
    constexpr double never = std::numeric_limits<double>::max();
    return limit ? std::min(never, not_before<M>(rules, *limit)) : never;
}

// Sets the clocks of all balls back, until one cannot be.
template <mechanics M>
[[nodiscard]] bool set_clocks_back(moving_scene<M>& scene, const typename M::number& by) {
    for (body a = 0; a < scene.balls(); ++a) {
        if (!scene.rules().set_back(scene[a].state, by)) {
            return false;
        }
    }
    return true;
}

// Whether an event is after that time.
template <mechanics M>
[[nodiscard]] bool is_after(const moving_scene<M>& scene, const timed_event<typename M::time>& d,
                            const typename M::number& end) {
    try {
        return scene.rules().order(d.when, end) > 0;
    } catch (graze::undecided& e) {
        e.between(scene.named(d.what.a, d.what.b));
        throw;
    }
}

// Throws std::domain_error for two mirrors whose event is next.
template <mechanics M>
[[noreturn]] void refuse_mirrors(const moving_scene<M>& scene, const timed_event<typename M::time>& d) {
    std::ostringstream message;
    message << to_string(scene.named(d.what.a, d.what.b))
            << ": both masses are infinite, and they meet at about t = " << scene.rules().bounds(d.when).lower;
    throw std::domain_error(message.str());
}

// Whether the run goes on.
template <class Observer, class Event>
[[nodiscard]] bool tell(Observer& observer, const Event& told) {
    if constexpr (std::is_void_v<decltype(observer(told))>) {
        observer(told);
        return true;
    } else {
        return static_cast<bool>(observer(told));
    }
}

// An observer of any type, as one that is compiled once. It lives no longer than what it observes for.
template <class Event>
class listener {
  public:
    template <class Tell>
    explicit listener(const Tell& tell)
        : tell_(&tell), call_([](const void* t, const Event& told) { return (*static_cast<const Tell*>(t))(told); }) {}

    bool operator()(const Event& told) const { return call_(tell_, told); }

  private:
    const void* tell_;
    bool (*call_)(const void*, const Event&);
};

// Makes the forecast anew where that is cheaper than to go on. Nothing will happen before `now`.
template <mechanics M>
void keep_up_to_date(forecast<M>& ahead, double now) {
    if (ahead.is_outdated()) {
        forecast<M> anew(ahead);
        anew.predict_all(now);
        ahead = std::move(anew);
    }
}

// Which of the two that have just met is jammed, or no_body. Mirrors are not: nothing holds them.
template <mechanics M>
[[nodiscard]] body jammed(const moving_scene<M>& scene, jam_watch& jams, body a, body b, double now,
                          std::uint64_t most) noexcept {
    const bool first = !scene[a].immovable && jams.note(a, b, now, most);
    const bool second = b < scene.balls() && !scene[b].immovable && jams.note(b, a, now, most);
    return first ? a : second ? b : no_body;
}

// Names those of a jam that have not been named before.
template <mechanics M>
void name_jam(const moving_scene<M>& scene, const jammed_bodies& jam, outcome& done) {
    for (const body b : jam) {
        if (b == no_body) {
            continue;
        }
        const participant part = scene.part(b);
        if (std::find(done.jammed.begin(), done.jammed.end(), part) == done.jammed.end()) {
            done.jammed.push_back(part);
        }
    }
}

// Stops those of a jam that can stop.
template <mechanics M>
void stop_jam(forecast<M>& ahead, const jammed_bodies& jam, double now) {
    moving_scene<M>& scene = ahead.scene();
    const auto is_ball = [&](body b) { return b < scene.balls(); };
    const auto mirror = std::find_if(jam.begin(), jam.end(), [&](body b) { return is_ball(b) && scene[b].immovable; });
    for (const body b : jam) {
        if (is_ball(b) && !scene[b].immovable) {
            scene.stop(b, mirror != jam.end() ? *mirror : no_body);
            ahead.note_place(b);
        }
    }
    ahead.forget();
    for (const body b : jam) {
        if (is_ball(b) && !scene[b].immovable) {
            ahead.predict(b, now);
        }
    }
    ahead.accept();
}

} // namespace graze::inline v0_1::detail
