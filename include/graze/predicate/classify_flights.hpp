// What becomes of two flights, exactly, from the instant on at which the later one starts.
#pragma once

#include <graze/pair/flight_pair.hpp>
#include <graze/predicate/classify_balls.hpp>
#include <graze/predicate/classify_walls.hpp>

#include <concepts>

namespace graze::inline v0_1 {

namespace detail {

template <int N, class T>
constexpr void check(const flight<N, T>& f, const char* argument) {
    check(f.state, argument);
    if (!is_finite_input(f.since)) {
        reject(argument, "since is not finite");
    }
}

// The scale of lengths bounds |x_a - x_b|, |u lead| and R, each by itself.
template <int N, class T>
struct flight_bounds {
    [[nodiscard]] static consteval auto value() {
        return with_lead(ball_bounds<N, T>::value(), bounded_vector<N>(error_bound::exact_input({0, 1, 0})),
                         error_bound::rounded_input({1, -1, 0}));
    }
};
template <int N, class T>
struct flight_filter {
    static constexpr double h = filter_constant(coefficient_h{}, flight_bounds<N, T>::value());
    static constexpr double c = filter_constant(coefficient_c{}, flight_bounds<N, T>::value());
    static constexpr double discriminant = filter_constant(halved_of_motion{}, flight_bounds<N, T>::value());

    static_assert(has_degrees(coefficient_h{}, flight_bounds<N, T>::value(), 1, 1, 0));
    static_assert(has_degrees(coefficient_c{}, flight_bounds<N, T>::value(), 2, 0, 0));
    static_assert(has_degrees(halved_of_motion{}, flight_bounds<N, T>::value(), 2, 2, 0));
    static_assert(discriminant > 2 * h * h && discriminant > 2 * c, "one constant must serve all three signs");
};

// Two flights in doubles at the later one's start: their motion and |x_a - x_b|² + |u lead|² + R².
template <int N>
struct rounded_flights {
    relative_motion<N, double, double, double> motion;
    double length2;
    bool in_range;
};

// The range, beside that of two balls (filter_balls). A lead of magnitude in [2^-500, 2^500), for floats in [2^-30,
// 2^30), or of two instants whose bits are the same is the difference of numbers of which a mode that reads subnormals
// as zero takes at most 2^-96 of it; and what it takes off u, 2^-126 for floats, is less than 2^-92 of the scale once
// it is multiplied with a lead below 2^34 times that.
template <int N, class T>
[[nodiscard, gnu::always_inline]] inline rounded_flights<N> rounded_motion(const flight<N, T>& a,
                                                                           const flight<N, T>& b) noexcept {
    constexpr int range = std::is_same_v<T, float> ? 30 : 500;
    const double lead = wide(b.since) - wide(a.since);
    const vec<N, double> u = wide(lead > 0 ? a.state.velocity : b.state.velocity);
    const auto now = rounded_motion(a.state, b.state);
    const double length2 = graze::squared_norm(now.dx) + graze::squared_norm(lead * u) + now.R * now.R;
    const unsigned known_lead = static_cast<unsigned>(bits_of(a.since) == bits_of(b.since)) |
                                static_cast<unsigned>(within_powers<-range, range>(std::fabs(lead)));
    const bool in_range = (known_lead & static_cast<unsigned>(lead * lead * 0x1p-68 < length2)) != 0;
    return {with_lead(now, u, lead), length2, in_range};
}

template <int N, class T>
[[nodiscard, gnu::always_inline]] inline filtered_balls filter_flights(const flight<N, T>& a,
                                                                       const flight<N, T>& b) noexcept {
    const auto m = rounded_motion(a, b);
    filtered_balls r = started_filter<T, flight_filter<N, T>>(m.motion, m.length2).finish();
    r.certain = r.certain & m.in_range & plain_radii(a.state.radius, b.state.radius);
    return r;
}

// The inputs of two flights, settled in a unit of time of their own.
template <int N, class T>
[[nodiscard]] constexpr timed_inputs<two_balls<N>> lift_flights(const flight<N, T>& a, const flight<N, T>& b) noexcept {
    auto in = lift_timed<two_balls<N>>(packed<two_balls<N>>(a.state, b.state), std::array<T, 2>{a.since, b.since});
    in.settle(in.unit());
    return in;
}

template <int N, class T>
constexpr void check_flights(const flight<N, T>& a, const flight<N, T>& b) {
    check(a, "flight a");
    check(b, "flight b");
}

// Flights of one velocity come no closer: no integers are needed.
template <int N, class T>
[[nodiscard, gnu::noinline]] constexpr encounter classify_exactly(const flight<N, T>& a, const flight<N, T>& b) {
    check_flights(a, b);
    if (is_same(a.state.velocity, b.state.velocity)) {
        return encounter::recede;
    }
    return with_exact_flights(lift_flights(a, b), [](const auto& pair) { return exact_encounter{}(pair.motion()); });
}

} // namespace detail

// What the encounters of balls mean at t = 0 those of flights mean at t0, the later one's `since`: from then on both
// are on their way. The motion before is exact, nothing is rounded. Laws 1 to 6 of classify_balls.hpp, with t0 for an
// overlap's time, and
//   12. flights of one `since` do what their balls do;
//   13. the answer stays the same when every `since` is shifted by one number, if the sums are exact.

// Whether two flights meet from t0 on, exactly, for every finite input. Throws std::domain_error that names the flight
// and the field when an input is not finite or a radius is negative; in a constant expression such input does not
// compile. The observer is told which stage decided.
template <int N, std::floating_point T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard, gnu::always_inline]] constexpr inline encounter classify(const flight<N, T>& a, const flight<N, T>& b,
                                                                      Observer&& observer = {}) {
    if (!std::is_constant_evaluated()) {
        if (const auto filtered = detail::filter_flights(a, b); filtered.certain) [[likely]] {
            observer(stage::filter);
            return filtered.what();
        }
    }
    const encounter what = detail::classify_exactly(a, b);
    observer(stage::exact);
    return what;
}

// Whether a flight meets a plane or a wall from its `since` on, exactly. Throws as for balls, naming the flight.
template <int N, std::floating_point T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr encounter classify(const flight<N, T>& f, const plane<N, T>& p, Observer&& observer = {}) {
    detail::check(f, "flight");
    return classify(f.state, p, observer);
}
template <int N, std::floating_point T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr encounter classify(const flight<N, T>& f, const wall<N, T>& w, Observer&& observer = {}) {
    detail::check(f, "flight");
    return classify(f.state, w, observer);
}

} // namespace graze::inline v0_1
