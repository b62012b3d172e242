// The contact of two flights that hit rounded by doubles alone, as far as that leaves no doubt: that of balls
// (contact/bounded_impact.hpp) from where they are when both have started.
//
// u = 2^-53; notation and counting of roundings as in predicate/fast_approach.hpp.
#pragma once

#include <graze/contact/fast_contact.hpp>
#include <graze/shape/flight.hpp>

namespace graze::inline v0_1::detail {

// The relative motion at the later start, how long before that each started, and 2 (|x_a - x_b|² + |u lead|²) + R²,
// at least |Δx|² + R².
//
// Δx is the sum of the doubles x, p and s (the values of x_a - x_b, of u lead and of their sum) and of their errors and
// u times the error of lead, which are at most u |x|, u |p|, u (|x| + |p|) and u |p|. Its error comes from adding these
// up: u² |p|, u² 2|p|, u² (2|p| + |x|), u² (3|p| + 2|x|), at most 8 u² (|x| + |p|): 8.1 u² of the length.
struct lane_flights {
    lane_motion motion;
    double start;
    exact_pair<double> before_a, before_b;
    double length2;
};

// x + u lead.
template <bool Fused>
[[nodiscard, gnu::always_inline]] inline exact_pair<lanes>
moved(const exact_pair<lanes>& x, const lanes& u, const exact_pair<double>& lead, double& way2) noexcept {
    const auto way = two_product(as_factor<Fused>(u), as_factor<Fused>(both(lead.value)));
    const auto sum = two_sum(x.value, way.value);
    const lanes squares = x.value * x.value + way.value * way.value;
    way2 += squares[0] + squares[1];
    return two_sum(sum.value, lanes(sum.error + ((way.error + u * lead.error) + x.error)));
}

template <bool Fused, int N, class T>
[[nodiscard, gnu::always_inline]] inline lane_flights lane_flights_of(const flight<N, T>& a,
                                                                      const flight<N, T>& b) noexcept {
    const double since_a = static_cast<double>(as_stored(a.since));
    const double since_b = static_cast<double>(as_stored(b.since));
    const auto lead = two_difference(since_b, since_a);
    const bool a_first = lead.value > 0;
    const vec<N, T>& u = a_first ? a.state.velocity : b.state.velocity;
    lane_flights r;
    r.motion = lane_motion_of(a.state, b.state);
    const double radius = r.motion.xR2.value[0];
    double way2 = 0; // with R² twice
    r.motion.x01 = moved<Fused>(r.motion.x01, first_two(u), lead, way2);
    const double third = N == 3 ? static_cast<double>(as_stored(u[N - 1])) : 0.0;
    r.motion.xR2 = moved<Fused>(r.motion.xR2, lanes{0, third}, lead, way2);
    r.length2 = 2 * way2 - radius * radius;
    r.start = a_first ? since_b : since_a;
    const exact_pair<double> none{0, 0};
    r.before_a = a_first ? lead : none;
    r.before_b = a_first ? none : exact_pair<double>{-lead.value, -lead.error};
    return r;
}

// before + t0 + t1: a sum of two doubles, the second at most 2u of the first and |t1|, that is off by at most 3 u² of
// the first, 2u |t1| and the error of t1, together 3 u² of it and 1.07 of that.
template <bool Fused>
struct lane_time {
    factor<lanes, Fused> high;
    double low;
};
template <bool Fused>
[[nodiscard, gnu::always_inline]] inline lane_time<Fused> time_since(const exact_pair<double>& before,
                                                                     const fast_approach<Fused>& r) noexcept {
    const auto sum = two_sum(before.value, r.t0.value[0]);
    return {as_factor<Fused>(both(sum.value)), sum.error + (before.error + r.t1)};
}

// x + u t. The roundings are at most 3 u² |x| + |u| (11 u² t + 0.1 e), those of t 3 u² t + 1.07 e, e the error of t1.
template <bool Fused>
[[nodiscard, gnu::always_inline]] inline bounded<lanes>
bounded_position(const lanes& x, const lanes& u, const lane_time<Fused>& t, double error) noexcept {
    const auto way = two_product(as_factor<Fused>(u), t.high);
    const auto sum = two_sum(x, way.value);
    const lanes low = (sum.error + way.error) + u * t.low;
    const double of_time = 1.25 * error + 0x1p-102 * t.high.value[0];
    return {sum.value, low, 0x1p-104 * absolute(x) + absolute(u) * of_time + underflow};
}

// Two flights that hit (D > 0) at about `time` after the later start. take: as bound_hit's.
//
// The bounds of bound_hit hold with the length for L, since Δx's own error, 8.1 u² of it, is a small part of what they
// allow: y/R is off by at most (58.2 u² L + 1.87 |Δu| e)/R < 2.5 e a/σ; s by 84.1 u² L V + 1.5 V² e, relatively by 60.2
// u² γ + 1.5 e a/σ, so that φ is by (60.2 + 71 · 0.51) u² γ + 1.5 e a/σ, and 94 u² <= 48 u² γ: in all less than 2^-98
// γ.
template <bool Fused, int N, class T, class F>
[[nodiscard, gnu::always_inline]] inline bool bound_hit(const flight<N, T>& a, const flight<N, T>& b, double mass_a,
                                                        double mass_b, double time, F& take) noexcept {
    const lane_flights f = lane_flights_of<Fused>(a, b);
    const auto r = approach_near<Fused>(f.motion, time, f.length2);
    if (!(r.good && is_usable_mass(mass_a) && is_usable_mass(mass_b))) [[unlikely]] {
        return false;
    }
    const auto& x_a = a.state.position;
    const auto& x_b = b.state.position;
    const auto& u_a = a.state.velocity;
    const auto& u_b = b.state.velocity;
    const auto absolute_time = two_sum(f.start, r.t0.value[0]);
    take(bounded<double>{absolute_time.value, absolute_time.error + r.t1,
                         1.1 * r.error + 0x1p-104 * absolute(absolute_time.value)},
         0);
    const auto time_a = time_since(f.before_a, r);
    const auto time_b = time_since(f.before_b, r);
    take(bounded_position(first_two(x_a), first_two(u_a), time_a, r.error), 1, 2);
    take(bounded_position(first_two(x_b), first_two(u_b), time_b, r.error), 4, 5);
    if constexpr (N == 3) {
        const auto third = [](const auto& x) { return both(static_cast<double>(as_stored(x[2]))); };
        const auto at_a = bounded_position(third(x_a), third(u_a), time_a, r.error);
        const auto at_b = bounded_position(third(x_b), third(u_b), time_b, r.error);
        take(bounded<double>{at_a.high[0], at_a.low[0], at_a.error[0]}, 3);
        take(bounded<double>{at_b.high[0], at_b.low[0], at_b.error[0]}, 6);
    }
    const lane_motion& m = f.motion;
    const lane_contact<Fused> y{
        m, r.y01, r.yR2, low_at_contact(r.y01, r.t1), low_at_contact(r.yR2, r.t1), {m.xR2.value[0], m.xR2.error[0]}};
    const auto s = closing_speed(y.y01, y.low01, y.y2, y.low2, m);
    const double turn = r.per_time * r.error;
    bound_impact(a.state, b.state, mass_a, mass_b, y, s, 2.5 * turn, 0x1p-98 * r.sensitivity + 2 * turn, take);
    return true;
}

template <int N, class T>
struct flights_by_doubles {
    contact<N, T>& c;
    const flight<N, T>&a, &b;
    double mass_a, mass_b, time;

    template <bool Fused>
    [[nodiscard, gnu::always_inline]] parts operator()(std::bool_constant<Fused>) const noexcept {
        rounded_components<N, T> taken{c};
        return bound_hit<Fused>(a, b, mass_a, mass_b, time, taken) ? taken.certain : 0;
    }
};

// Fills in the components that are certain, of flights that hit, and returns the others.
template <int N, class T>
[[nodiscard]] inline parts fast_contact(contact<N, T>& c, const flight<N, T>& a, const flight<N, T>& b, double mass_a,
                                        double mass_b, double time) noexcept {
    const parts certain = with_best_products(flights_by_doubles<N, T>{c, a, b, mass_a, mass_b, time});
    return open_after(certain, c, a.state, b.state, mass_a, mass_b, bits_of(a.since) == bits_of(b.since));
}

} // namespace graze::inline v0_1::detail
