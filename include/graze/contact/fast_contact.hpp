// The contact of two balls that hit, from doubles: each component with a proven error, and rounded where that leaves no
// doubt.
//
// y = Δx + Δu τ is a sum of two doubles, s = -y·Δu = √D, and then
//   position  x + u τ        normal  y/R        velocity  u_a + φ_a y/R,  u_b - φ_b y/R,  φ_a = 2 (s/R) m_b/(m_a + m_b)
// ((13), (20), (23) with (29): ⟨Δu,X̂⟩ = -s/R). Errors of low parts are counted as in predicate/fast_approach.hpp, whose
// bounds and notation are used; e is its error of the time.
#pragma once

#include <graze/contact/contact.hpp>
#include <graze/contact/parts.hpp>
#include <graze/number/fused.hpp>
#include <graze/predicate/fast_approach.hpp>
#include <graze/predicate/rounding_test.hpp>

namespace graze::detail {

// 1/x of two sums x = value + error: with r = 1 - ih x = 1 - ih value - ih error, 1/x = ih + ih r + ih r²/(1 - r), |r|
// <= 2.01 u. Its relative error is at most u² + 2u² + 2.1u² + 4.1u² <= 9.2 u², and |il| <= 2.02 u ih.
template <bool Fused>
struct lane_inverse {
    factor<lanes, Fused> high;
    lanes low;
};
template <bool Fused>
[[nodiscard, gnu::always_inline]] inline lane_inverse<Fused> inverse_of(const exact_pair<lanes>& x) noexcept {
    const auto inverse = as_factor<Fused>(settled(1 / x.value));
    const auto product = two_product(inverse, as_factor<Fused>(x.value));
    const lanes rest = settled(settled(1 - product.value) - product.error) - inverse.value * x.error;
    return {inverse, rest * inverse.value};
}

// x + u (t0 + t1): an error of at most 2^-104 |x| + 1.25 |u| e. The parts that are added up at the end are the errors
// of a product and of a sum, and u t1: three roundings of each, and one for adding the bound, make at most 3u² |x| +
// |u| (6u² t0 + 3u |t1| + e).
template <bool Fused>
[[nodiscard, gnu::always_inline]] inline bounded<lanes> bounded_position(const lanes& x, const lanes& u,
                                                                         const fast_approach<Fused>& r) noexcept {
    const auto way = two_product(as_factor<Fused>(u), r.t0);
    const auto sum = two_sum(x, way.value);
    const lanes low = (sum.error + way.error) + u * r.t1;
    return {sum.value, low, 0x1p-104 * absolute(x) + absolute(u) * (1.25 * r.error) + underflow};
}

// The normal, high + low.
template <bool Fused>
struct lane_normal {
    factor<lanes, Fused> high;
    lanes low;
};

// yl at τ: zl = yl + Δu t1 has an error of at most 10.1 u² |Δx| + 1.21 |Δu| e, and |zl| <= 3.02 u m + |Δu t1|. Times
// (ih, il), with roundings of at most 8.3 u² |yh| ih + 4.2 u |zl| ih and the inverse's 9.2 u² |yh| ih: together, the
// rounding in adding the bound included, at most (50 u² |Δx| + 1.87 |Δu| e)/R, which is less than 2.5 e a/σ since L <=
// 2^98.5 V e and V/R <= 1.003 a/σ.
template <bool Fused>
[[nodiscard, gnu::always_inline]] inline lanes low_at_contact(const lane_displacement<Fused>& y, double t1) noexcept {
    return y.low + y.du.value * t1;
}
template <bool Fused>
[[nodiscard, gnu::always_inline]] inline lane_normal<Fused>
normal_of(const lane_displacement<Fused>& y, const lanes& low, const factor<lanes, Fused>& inverse,
          const lanes& inverse_low) noexcept {
    const auto product = two_product(y.high, inverse);
    return {as_factor<Fused>(product.value), (product.error + y.high.value * inverse_low) + low * inverse.value};
}

// u + φ n: an error of at most |φ| (1.6 error of n + |n| (the relative error of φ + 74 u²)) + 2u² |u|, for |φ's low
// part|
// <= 9 u |φ|. own_error is that without the last term.
template <bool Fused>
[[nodiscard, gnu::always_inline]] inline bounded<lanes>
bounded_velocity(const lanes& u, const factor<lanes, Fused>& phi, const lanes& phi_low, const lane_normal<Fused>& n,
                 const lanes& own_error) noexcept {
    const auto product = two_product(phi, n.high);
    const auto sum = two_sum(u, product.value);
    const lanes low = sum.error + (product.error + (phi.value * n.low + phi_low * n.high.value));
    return {sum.value, low, 0x1p-105 * absolute(u) + own_error};
}

// (x.value + x.error)(high + low) but for the product of the low parts: its relative error is at most 5.2 u² + 4.1 u λ
// more than its factors', |x.error| <= λ |x.value|, |low| <= 3.1 u |high|; and its low part is at most λ + 3.1 u of it.
template <bool Fused>
[[nodiscard, gnu::always_inline]] inline exact_pair<double>
times(const exact_pair<double>& x, const factor<double, Fused>& high, double low) noexcept {
    const auto product = two_product(as_factor<Fused>(x.value), high);
    return {product.value, (product.error + x.value * low) + x.error * high.value};
}

// s = -y·Δu at contact, its low part at most u of it. Three products and two sums without error; the low terms add up
// to at most u (4.1 R V + 6.8 L V) + V² |t1|, with 6 roundings each; y's own error makes 10.1 u² L V + 1.21 V² e.
// Together 76 u² L V + 1.5 V² e, relatively at most 54 u² γ + 1.5 e a/σ.
template <bool Fused>
[[nodiscard, gnu::always_inline]] inline exact_pair<double>
closing_speed(const fast_approach<Fused>& r, const lanes& low01, const lanes& low2) noexcept {
    const auto product01 = two_product(r.y01.high, r.y01.du);
    const auto product2 = two_product(r.yR2.high, r.yR2.du);
    const lanes rest01 = product01.error + (r.y01.high.value * r.motion.u01.error + low01 * r.y01.du.value);
    const lanes rest2 = product2.error + (r.yR2.high.value * r.motion.u_2.error + low2 * r.yR2.du.value);
    const auto plane_sum = two_sum(product01.value[0], product01.value[1]);
    const auto sum = two_sum(plane_sum.value, product2.value[1]);
    const double low = (plane_sum.error + sum.error) + ((rest01[0] + rest01[1]) + rest2[1]);
    return fast_two_sum(-sum.value, -settled(low));
}

// Lanes of x in another order, and one of them alone.
[[nodiscard, gnu::always_inline]] inline lanes picked(const lanes& x, int first, int second) noexcept {
    return lanes{x[first], x[second]};
}
template <bool Fused>
[[nodiscard, gnu::always_inline]] inline factor<lanes, Fused> picked(const factor<lanes, Fused>& x, int first,
                                                                     int second) noexcept {
    return {picked(x.value, first, second), {picked(x.parts.high, first, second), picked(x.parts.low, first, second)}};
}

template <bool Fused>
[[nodiscard, gnu::always_inline]] inline factor<double, Fused> picked(const factor<lanes, Fused>& x, int i) noexcept {
    return {x.value[i], {x.parts.high[i], x.parts.low[i]}};
}

template <int N, class T>
[[nodiscard, gnu::always_inline]] inline lanes first_two(const vec<N, T>& x) noexcept {
    return lanes{static_cast<double>(x[0]), static_cast<double>(x[1])};
}
template <int N, class T>
[[nodiscard, gnu::always_inline]] inline lanes last_two(const vec<N, T>& x, const vec<N, T>& y) noexcept {
    return lanes{static_cast<double>(x[N - 1]), static_cast<double>(y[N - 1])};
}

// Component `number` of a contact, as parts count them.
template <int N, class T>
[[nodiscard, gnu::always_inline]] inline T& component(contact<N, T>& c, int number) noexcept {
    const int i = (number - 1) % 3;
    return number == 0   ? c.time
           : number < 4  ? c.position_a[i]
           : number < 7  ? c.position_b[i]
           : number < 10 ? c.normal[i]
           : number < 13 ? c.velocity_a[i]
                         : c.velocity_b[i];
}

// Components that no arithmetic is needed for, which the intervals leave open when they are 0: where a ball does not
// move along an axis, and where both are, and move, alike.
template <int N, class T>
[[nodiscard, gnu::noinline]] inline parts fast_hit_at_rest(parts open_parts, contact<N, T>& c, const ball<N, T>& a,
                                                           const ball<N, T>& b) noexcept {
    const T zero(0);
    const auto set = [&](part which, int i, T& to, T value) {
        const parts bit = parts{1} << (static_cast<int>(which) + i);
        to = (open_parts & bit) != 0 ? value + zero : to; // -0 + 0 = +0
        open_parts &= ~bit;
    };
    for (int i = 0; i < N; ++i) {
        if (a.velocity[i] == zero) {
            set(part::position_a, i, c.position_a[i], a.position[i]);
        }
        if (b.velocity[i] == zero) {
            set(part::position_b, i, c.position_b[i], b.position[i]);
        }
        if (a.position[i] == b.position[i] && a.velocity[i] == b.velocity[i]) {
            set(part::normal, i, c.normal[i], zero);
            set(part::velocity_a, i, c.velocity_a[i], a.velocity[i]);
            set(part::velocity_b, i, c.velocity_b[i], b.velocity[i]);
        }
    }
    return open_parts;
}

// The contact of two balls that hit (D > 0) near `time`: take(x, i, j) is called with components i and j as lanes, or
// take(x, i) with one. False, and calls nothing, if no bounds are known. mass_a, mass_b: 1 and 0 where ball a's mass is
// infinite, 0 and 1 where b's.
//
// φ = 2 (s/R)/(m_a + m_b) m has a relative error of at most 54 u² γ + 1.5 e a/σ (of s) + 17.5 u² + 4.1 u² + 17.5 u² +
// 17 u² + 14 u² <= 90 u² γ + 1.5 e a/σ, and a low part of at most 9 u of it.
template <bool Fused, int N, class T, class F>
[[nodiscard, gnu::always_inline]] inline bool bound_hit(const ball<N, T>& a, const ball<N, T>& b, double mass_a,
                                                        double mass_b, double time, F& take) noexcept {
    const lane_motion m = lane_motion_of(a, b);
    const auto r = approach_near<Fused>(m, time);
    const auto in_range = [](double mass) __attribute__((always_inline)) {
        return mass == 0 || within_powers<-200, 200>(mass);
    };
    if (!(r.good && in_range(mass_a) && in_range(mass_b))) [[unlikely]] {
        return false;
    }
    take(r.time(), 0);
    take(bounded_position(first_two(a.position), first_two(a.velocity), r), 1, 2);
    take(bounded_position(first_two(b.position), first_two(b.velocity), r), 4, 5);
    if constexpr (N == 3) {
        take(bounded_position(last_two(a.position, b.position), last_two(a.velocity, b.velocity), r), 3, 6);
    }

    const auto masses = two_sum(mass_a, mass_b);
    const auto inverse = inverse_of<Fused>(
        {lanes{m.xR2.value[0], masses.value}, lanes{m.xR2.error[0], masses.error}}); // of R and m_a + m_b
    const auto per_length = picked(inverse.high, 0, 0);
    const lanes low01 = low_at_contact(r.y01, r.t1);
    const lanes lowR2 = low_at_contact(r.yR2, r.t1);
    const auto n01 = normal_of(r.y01, low01, per_length, both(inverse.low[0]));
    const auto nR2 = normal_of(r.yR2, lowR2, per_length, both(inverse.low[0]));
    const double turn = r.per_time * r.error;
    const double error_of_n = 2.5 * turn + underflow;
    take(bounded<lanes>{n01.high.value, n01.low, both(error_of_n)}, 7, 8);

    const auto s = closing_speed(r, low01, lowR2);
    const auto per_radius = times(s, picked(inverse.high, 0), inverse.low[0]);
    const auto per_mass = times({2 * per_radius.value, 2 * per_radius.error}, picked(inverse.high, 1), inverse.low[1]);
    const lanes shares{mass_b, -mass_a};
    const auto product = two_product(as_factor<Fused>(both(per_mass.value)), as_factor<Fused>(shares));
    const auto phi = as_factor<Fused>(product.value);
    const lanes phi_low = product.error + per_mass.error * shares;
    const lanes error = absolute(phi.value) * (0x1p-98 * r.sensitivity + 7 * turn) + underflow;
    const auto velocity = [&](const lanes& u, int i, int j, const auto& n) __attribute__((always_inline)) {
        return bounded_velocity(u, picked(phi, i, j), picked(phi_low, i, j), n, picked(error, i, j));
    };
    take(velocity(first_two(a.velocity), 0, 0, n01), 10, 11);
    take(velocity(first_two(b.velocity), 1, 1, n01), 13, 14);
    if constexpr (N == 3) {
        const lane_normal<Fused> n2{picked(nR2.high, 1, 1), picked(nR2.low, 1, 1)};
        take(bounded<double>{n2.high.value[0], n2.low[0], error_of_n}, 9);
        take(velocity(last_two(a.velocity, b.velocity), 0, 1, n2), 12, 15);
    }
    return true;
}

// The parts for one bit a component in the order in which bound_hit takes them, the last one in bit 0; of two lanes the
// second one has the upper bit.
template <int N>
[[nodiscard]] constexpr parts part_bits(unsigned taken) noexcept {
    constexpr int order[2][16] = {{0, 2, 1, 5, 4, 8, 7, 11, 10, 14, 13},
                                  {0, 2, 1, 5, 4, 6, 3, 8, 7, 11, 10, 14, 13, 9, 15, 12}};
    parts result = 0;
    for (int i = 0; i < 1 + 5 * N; ++i) {
        result |= (taken >> (5 * N - i) & 1U) << order[N - 2][i];
    }
    return result;
}

// Takes what is bounded: writes the upper ends, and keeps for each whether it is certain.
template <int N, class T>
struct rounded_components {
    contact<N, T>& c;
    unsigned agreed = 0; // in the order of taking

    [[gnu::always_inline]] void operator()(const bounded<double>& x, int number) noexcept {
        const ends<double> interval = ends_of<T>(x);
        component(c, number) = static_cast<T>(interval.upper);
        agreed = agreed << 1 | static_cast<unsigned>(agree<T>(interval));
    }
    [[gnu::always_inline]] void operator()(const bounded<lanes>& x, int first, int second) noexcept {
        const ends<lanes> interval = ends_of<T>(x);
        component(c, first) = static_cast<T>(interval.upper[0]);
        component(c, second) = static_cast<T>(interval.upper[1]);
        agreed = agreed << 2 | agreeing<T>(interval);
    }
};

// bound_hit with rounded_components: which components are certain.
template <int N, class T>
struct hit_by_doubles {
    contact<N, T>& c;
    const ball<N, T>&a, &b;
    double mass_a, mass_b, time;

    template <bool Fused>
    [[nodiscard, gnu::always_inline]] unsigned operator()(std::bool_constant<Fused>) const noexcept {
        rounded_components<N, T> taken{c};
        return bound_hit<Fused>(a, b, mass_a, mass_b, time, taken) ? taken.agreed : 0;
    }
};

// Fills in the components that are certain and returns the others. The velocity of a ball of infinite mass is its own.
template <int N, class T>
[[nodiscard]] inline parts fast_hit(contact<N, T>& c, const ball<N, T>& a, const ball<N, T>& b, double mass_a,
                                    double mass_b, double time) noexcept {
    const unsigned agreed = with_best_products(hit_by_doubles<N, T>{c, a, b, mass_a, mass_b, time});
    const bool heavy = mass_a == 0 || mass_b == 0;
    if (agreed == (1U << (1 + 5 * N)) - 1 && !heavy) [[likely]] {
        return 0;
    }
    constexpr parts of_velocity = 7;
    parts certain = part_bits<N>(agreed);
    if (mass_a == 0) {
        c.velocity_b = b.velocity;
        certain |= of_velocity << static_cast<int>(part::velocity_b);
    }
    if (mass_b == 0) {
        c.velocity_a = a.velocity;
        certain |= of_velocity << static_cast<int>(part::velocity_a);
    }
    const parts open_parts = (N == 3 ? 0xffffU : 0x6db7U) & ~certain;
    return open_parts == 0 ? 0 : fast_hit_at_rest(open_parts, c, a, b);
}

} // namespace graze::detail
