// The contact of two movers by doubles, each component with a proven error.
//
// y = Δx + Δu τ is a sum of two doubles, s = -y·Δu, and then
//   position  x + u τ        normal  y/R        velocity  u_a + φ_a y/R,  u_b - φ_b y/R,  φ_a = 2 (s/R) m_b/(m_a + m_b)
// ((13), (20), (23) with (29): ⟨Δu,X̂⟩ = -s/R). Of an overlap τ = 0 and R is |Δx|.
//
// take(x, i, j) is called with two components as lanes, i and j as components.hpp counts them; take(x, i) with one. If
// no bounds are known the functions return false and have called nothing. mass_a, mass_b: 1 and 0 if ball a's mass is
// infinite, 0 and 1 if ball b's is.
#pragma once

#include <graze/contact/lane_steps.hpp>

#include <cmath>

namespace graze::inline v0_1::detail {

[[nodiscard, gnu::always_inline]] inline bool is_usable_mass(double mass) noexcept {
    return mass == 0 || within_powers<-200, 200>(mass);
}

// y with its low parts (of y2 only lane 1), and R = |y|.
template <bool Fused>
struct lane_contact {
    const lane_motion& motion;
    const lane_displacement<Fused>&y01, &y2;
    lanes low01, low2;
    exact_pair<double> R;
};

// What all components of a normal are off by, and at least the relative error of φ + 94 u².
struct common_error {
    double of_n, spread;

    static constexpr bool is_common = true;
    [[nodiscard, gnu::always_inline]] lanes of_n01(const lanes&) const noexcept { return both(of_n); }
    [[nodiscard, gnu::always_inline]] double of_n2(double) const noexcept { return of_n; }
};
// The same for each component by itself: `relative` of it and what y is off by there over R, of y2 lane 1.
struct error_by_component {
    lanes of_y01, of_y2;
    double relative, spread;

    static constexpr bool is_common = false;
    [[nodiscard, gnu::always_inline]] lanes of_n01(const lanes& n) const noexcept {
        return of_y01 + relative * absolute(n);
    }
    [[nodiscard, gnu::always_inline]] double of_n2(double n) const noexcept {
        return of_y2[1] + relative * absolute(n);
    }
};

// Takes the normal and the velocities.
//
// φ = 2 (s/R)/(m_a + m_b) m has a relative error of at most that of s + 12.2 u² + 9.2 u² (of 1/R) + 24.9 u² + 9.2 u² +
// 15.4 u² <= that of s + 71 u², and a low part of at most 9 u of it.
template <bool Fused, int N, class T, class Errors, class F>
[[gnu::always_inline]] inline void bound_impact(const ball<N, T>& a, const ball<N, T>& b, double mass_a, double mass_b,
                                                const lane_contact<Fused>& y, const exact_pair<double>& s,
                                                const Errors& errors, F& take) noexcept {
    const auto masses = two_sum(mass_a, mass_b);
    const auto inverse =
        inverse_of<Fused>(exact_pair<lanes>{lanes{y.R.value, masses.value}, lanes{y.R.error, masses.error}});
    const auto per_length = picked(inverse.high, 0, 0);
    const auto n01 = normal_of(y.y01, y.low01, per_length, both(inverse.low[0]));
    const auto n_2 = normal_of(y.y2, y.low2, per_length, both(inverse.low[0]));
    const lanes error01 = errors.of_n01(n01.high.value);
    const double error2 = errors.of_n2(n_2.high.value[1]);
    take(bounded<lanes>{n01.high.value, n01.low, error01 + both(underflow)}, 7, 8);

    const auto per_radius = times(s, picked(inverse.high, 0), inverse.low[0]);
    const auto per_mass =
        times(exact_pair<double>{2 * per_radius.value, 2 * per_radius.error}, picked(inverse.high, 1), inverse.low[1]);
    const lanes shares{mass_b, -mass_a};
    const auto product = two_product(as_factor<Fused>(both(per_mass.value)), as_factor<Fused>(shares));
    const auto phi = as_factor<Fused>(product.value);
    const lanes phi_low = product.error + per_mass.error * shares;
    const lanes sizes = absolute(phi.value);
    const lanes common = sizes * (2 * error2 + errors.spread) + underflow;
    const auto velocity = [&](const lanes& u, int i, int j, const auto& n, const lanes& error_of_n)
        __attribute__((always_inline)) {
        const auto error = [&] {
            if constexpr (Errors::is_common) {
                return picked(common, i, j);
            } else {
                return picked(sizes, i, j) * (2 * error_of_n + errors.spread * absolute(n.high.value)) + underflow;
            }
        }();
        return bounded_velocity(u, picked(phi, i, j), picked(phi_low, i, j), n, error);
    };
    take(velocity(first_two(a.velocity), 0, 0, n01, error01), 10, 11);
    take(velocity(first_two(b.velocity), 1, 1, n01, error01), 13, 14);
    if constexpr (N == 3) {
        const lane_normal<Fused> n2{picked(n_2.high, 1, 1), picked(n_2.low, 1, 1)};
        take(bounded<double>{n2.high.value[0], n2.low[0], error2 + underflow}, 9);
        take(velocity(last_two(a.velocity, b.velocity), 0, 1, n2, both(error2)), 12, 15);
    }
}

// The positions of two balls at the contact.
template <int N, class T, bool Fused, class F>
[[gnu::always_inline]] inline void bound_positions(const ball<N, T>& a, const ball<N, T>& b,
                                                   const newton_approach<Fused>& r, F& take) noexcept {
    take(bounded_position(first_two(a.position), first_two(a.velocity), r), 1, 2);
    take(bounded_position(first_two(b.position), first_two(b.velocity), r), 4, 5);
    if constexpr (N == 3) {
        take(bounded_position(last_two(a.position, b.position), last_two(a.velocity, b.velocity), r), 3, 6);
    }
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
                                                                     const newton_approach<Fused>& r) noexcept {
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

// The positions of two flights, each from its own start.
template <int N, class T, bool Fused, class F>
[[gnu::always_inline]] inline void bound_positions(const flight<N, T>& a, const flight<N, T>& b,
                                                   const lane_time<Fused>& time_a, const lane_time<Fused>& time_b,
                                                   double error, F& take) noexcept {
    const auto one = [&](const ball<N, T>& x, const lane_time<Fused>& t, int number) __attribute__((always_inline)) {
        take(bounded_position(first_two(x.position), first_two(x.velocity), t, error), number, number + 1);
        if constexpr (N == 3) {
            const auto third = [](const vec<N, T>& v) { return both(static_cast<double>(as_stored(v[2]))); };
            const auto at = bounded_position(third(x.position), third(x.velocity), t, error);
            take(bounded<double>{at.high[0], at.low[0], at.error[0]}, number + 2);
        }
    };
    one(a.state, time_a, 1);
    one(b.state, time_b, 4);
}

// Two movers that hit (D > 0) at about `time` after their start.
//
// Of flights the bounds hold with the length for L, since Δx's own error, 8.1 u² of it, is a small part of what they
// allow: y/R is off by at most (58.2 u² L + 1.87 |Δu| e)/R < 2.5 e a/σ; s by 84.1 u² L V + 1.5 V² e, relatively by 60.2
// u² γ + 1.5 e a/σ, so that φ is by (60.2 + 71 · 0.51) u² γ + 1.5 e a/σ, and 94 u² <= 48 u² γ: in all less than 2^-98
// γ.
template <bool Fused, moving B, class F>
[[nodiscard, gnu::always_inline]] inline bool bound_hit(const B& a, const B& b, double mass_a, double mass_b,
                                                        double time, F& take) noexcept {
    const lane_movers f = lane_movers_of<Fused>(a, b);
    const auto r = approach_near<Fused, dimension_of<B>>(f.motion, time, f.length2);
    if (!(r.sharp && is_usable_mass(mass_a) && is_usable_mass(mass_b))) [[unlikely]] {
        return false;
    }
    take(on_clock_of(a, b, r.time()), 0);
    if constexpr (is_flight<B>) {
        bound_positions(a, b, time_since(f.before_a, r), time_since(f.before_b, r), r.error, take);
    } else {
        bound_positions(a, b, r, take);
    }
    const lane_motion& m = f.motion;
    const lane_contact<Fused> y{
        m, r.y01, r.yR2, low_at_contact(r.y01, r.t1), low_at_contact(r.yR2, r.t1), {m.xR2.value[0], m.xR2.error[0]}};
    const auto s = closing_speed(y.y01, y.low01, y.y2, y.low2, m);
    const double turn = r.per_time * r.error;
    bound_impact(state_of(a), state_of(b), mass_a, mass_b, y, s,
                 common_error{2.5 * turn, 0x1p-98 * r.sensitivity + 2 * turn}, take);
    return true;
}

// The normal and velocities of two movers that overlap and approach, and the positions of flights at the later start.
//
// y = Δx exactly, |yl| <= u |yh|. The low terms of |Δx|² add up to at most 5.1 u |Δx|², with at most 6 roundings each,
// so that it is right to 31 u², relatively. One correction of the root in doubles leaves 15.5 u² of that, 6.3 u² of the
// next term, (7.1 u)²/8, and 8 u² of roundings: R = |Δx| is right to 30 u². The normal is then right to 8.3 u² + 4.2 u²
// + 9.2 u² + 30 u² < 2^-100; s to 32 u² R V/s; and χ = R V/s >= 1, so that 32 u² χ + 30 u² + 71 u² + 94 u² <= 2^-98 χ².
// Of balls each component of the normal is right to that of itself, and s to 32 u² of the sizes of its terms, which
// stand for R V in χ then: no component's error is another one's.
// Of flights Δx is off by 8.1 u² of the length Λ: by Λ/R times that, relatively, as is R; s by χ times that.
template <bool Fused, moving B, class F>
[[nodiscard, gnu::always_inline]] inline bool bound_overlap(const B& a, const B& b, double mass_a, double mass_b,
                                                            F& take) noexcept {
    const lane_movers f = lane_movers_of<Fused>(a, b);
    const lane_motion& m = f.motion;
    const lane_displacement<Fused> y01{as_factor<Fused>(m.x01.value), m.x01.error, as_factor<Fused>(m.u01.value)};
    const lane_displacement<Fused> y2{as_factor<Fused>(m.xR2.value), m.xR2.error, as_factor<Fused>(m.u_2.value)};
    const auto square01 = two_square(y01.high);
    const auto square2 = two_square(y2.high);
    const lanes rest01 = square01.error + y01.low * (y01.high.value + y01.high.value + y01.low);
    const lanes rest2 = square2.error + y2.low * (y2.high.value + y2.high.value + y2.low);
    const auto plane_sum = two_sum(square01.value[0], square01.value[1]);
    const auto sum = two_sum(plane_sum.value, square2.value[1]);
    const double low = (plane_sum.error + sum.error) + ((rest01[0] + rest01[1]) + rest2[1]);
    const double root = settled(std::sqrt(sum.value));
    const auto back = two_square(as_factor<Fused>(root));
    const double rest = settled(settled(sum.value - back.value) - back.error) + low;
    const lane_contact<Fused> y{m, y01, y2, y01.low, y2.low, fast_two_sum(root, settled(0.5 * rest / root))};

    const auto s = closing_speed(y01, y.low01, y2, y.low2, m);
    const lanes v01 = m.u01.value * m.u01.value;
    const double speed2 = v01[0] + v01[1] + m.u_2.value[1] * m.u_2.value[1];
    const double sensitivity = [&] {
        if constexpr (is_flight<B>) {
            return (sum.value / s.value) * (speed2 / s.value); // χ²
        } else {
            const lanes terms01 = absolute(m.x01.value * m.u01.value);
            return (terms01[0] + terms01[1] + absolute(m.xR2.value[1] * m.u_2.value[1])) / s.value;
        }
    }();
    if (!(within_powers<-200, 200>(sum.value) && within_powers<-200, 200>(speed2) && s.value > 0x1p-800 &&
          within_powers<-200, 200>(f.length2) && sensitivity < 0x1p64 && is_usable_mass(mass_a) &&
          is_usable_mass(mass_b))) [[unlikely]] {
        return false;
    }
    if constexpr (is_flight<B>) {
        const double off = 0x1p-102 * plain_sqrt(f.length2) / root;
        const auto since = [](const exact_pair<double>& before) {
            return lane_time<Fused>{as_factor<Fused>(both(before.value)), before.error};
        };
        bound_positions(a, b, since(f.before_a), since(f.before_b), 0, take);
        bound_impact(state_of(a), state_of(b), mass_a, mass_b, y, s,
                     common_error{0x1p-99 + 3 * off, (0x1p-98 + 4 * off) * sensitivity}, take);
    } else {
        const lanes exact{0, 0};
        bound_impact(state_of(a), state_of(b), mass_a, mass_b, y, s,
                     error_by_component{exact, exact, 0x1p-99, 0x1p-98 * sensitivity}, take);
    }
    return true;
}

} // namespace graze::inline v0_1::detail
