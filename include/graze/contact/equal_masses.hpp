// The velocities of two movers of equal masses after a contact, in double words with proven errors.
//
// In (23) with m_a = m_b each takes over the other's velocity, but for what is across the normal:
//   v_a = u_b + w,  v_b = u_a - w,  w = Δu - (n·Δu) n = (n × Δu) × n,  n × Δu = (Δx × Δu)/R.
// u_a + φ n cancels all of u_a that is along n; this does not. u = 2^-53.
#pragma once

#include <graze/contact/components.hpp>
#include <graze/contact/lane_steps.hpp>
#include <graze/machine/fence.hpp>
#include <graze/time/word_approach.hpp>

namespace graze::inline v0_1::detail {

// What both velocities are known to be: each component, or an infinite error.
template <int N>
struct exchanged_velocities {
    bounded<double> a[N], b[N];

    constexpr exchanged_velocities() noexcept {
        for (int i = 0; i < N; ++i) {
            a[i] = b[i] = {0, 0, hidden_infinity()};
        }
    }
};

// x y: what the product of two computed values is off by, beside its roundings.
template <class V>
[[nodiscard, gnu::always_inline]] constexpr inline double product_moved(const bounded_value<V>& x,
                                                                        const bounded_value<V>& y) noexcept {
    return 1.0001 * (std::fabs(x.value.high) * y.error + (std::fabs(y.value.high) + y.error) * x.error);
}

// x y - z w, and x y.
template <bool Fused>
[[nodiscard, gnu::always_inline]] inline bounded_value<loose_word<Fused>>
difference_of_products(const bounded_value<loose_word<Fused>>& x, const bounded_value<loose_word<Fused>>& y,
                       const bounded_value<loose_word<Fused>>& z, const bounded_value<loose_word<Fused>>& w) noexcept {
    const auto computed = difference_of_products(x.value, y.value, z.value, w.value);
    return {computed.value, computed.error + (product_moved(x, y) + product_moved(z, w))};
}
template <bool Fused>
[[nodiscard, gnu::always_inline]] inline bounded_value<loose_word<Fused>>
product_of(const bounded_value<loose_word<Fused>>& x, const bounded_value<loose_word<Fused>>& y) noexcept {
    constexpr double k = (word_rounding::exact_input() * word_rounding::exact_input()).bound();
    const auto value = (x.value * y.value).in_order();
    return {value, 1.0001 * k * std::fabs(value.high) + product_moved(x, y)};
}

// x/R: 1/R is right to 9.2u² with a low part of 2.02u.
template <bool Fused>
[[nodiscard, gnu::always_inline]] inline bounded_value<loose_word<Fused>>
over_radius(const bounded_value<loose_word<Fused>>& x, const lane_inverse<Fused, double>& per_R) noexcept {
    constexpr double k = (word_rounding::exact_input() * word_rounding(3, 10)).bound();
    const auto value = (x.value * loose_word<Fused>(per_R.high.value, per_R.low)).in_order();
    return {value, 1.0001 * (k * std::fabs(value.high) + x.error * per_R.high.value)};
}

// Of velocities u_a and u_b, from Δx × Δu, y = Δx + Δu τ, each component with an error, and R; R may be off by a share
// of it, `off`. What Δx × Δu loses by underflow, less than 2^-1060, is multiplied by 1/R; the rest is less than
// `underflow`.
template <bool Fused, int N>
[[nodiscard, gnu::noinline]] exchanged_velocities<N>
exchange_velocities(const vec<N, double>& u_a, const vec<N, double>& u_b, const word_cross<Fused, N>& cross,
                    const vec<N, loose_word<Fused>>& y, const vec<N, double>& y_error, const exact_pair<double>& R,
                    double off) noexcept {
    using word = loose_word<Fused>;
    using number = bounded_value<word>;
    const auto per_R = inverse_of<Fused>(R);
    const auto widened = [&](number x) __attribute__((always_inline)) {
        x.error += 1.0001 * off * std::fabs(x.value.high);
        return x;
    };
    const auto n = make_vec<N>([&](int i) { return widened(over_radius(number{y[i], y_error[i]}, per_R)); });
    const auto turn = [&](const word& x, double error) __attribute__((always_inline)) {
        return widened(over_radius(number{x, error + 0x1p-1060}, per_R));
    };
    vec<N, number> w;
    if constexpr (N == 2) {
        const number z = turn(cross.value, cross.error);
        const number first = product_of(z, n[1]);
        w = {{number{-first.value, first.error}, product_of(z, n[0])}};
    } else {
        const auto z = make_vec<3>([&](int i) { return turn(cross.value[i], cross.each[i]); });
        w = make_vec<3>([&](int i) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            return difference_of_products(z[j], n[k], z[k], n[j]);
        });
    }
    exchanged_velocities<N> r;
    // The low part takes a rounding of at most u (u |sum| + u |w|), and one more in adding the bound.
    const auto put = [](bounded<double> & to, double u, const number& x, double sign) __attribute__((always_inline)) {
        const auto sum = two_sum(u, sign * x.value.high);
        to = {sum.value, sum.error + sign * x.value.low,
              1.0001 * x.error + (0x1p-103 * (std::fabs(sum.value) + std::fabs(x.value.high)) + underflow)};
    };
    for (int i = 0; i < N; ++i) {
        put(r.a[i], as_stored(u_b[i]), w[i], 1);
        put(r.b[i], as_stored(u_a[i]), w[i], -1);
    }
    return r;
}

// The same of two balls that overlap: y = Δx and R = |Δx|.
template <int N>
[[nodiscard, gnu::noinline]] exchanged_velocities<N> exchange_of_overlap(const ball<N, double>& a,
                                                                         const ball<N, double>& b) noexcept {
    using word = loose_word<false>;
    const auto difference = [](const vec<N, double>& x, const vec<N, double>& y) {
        return make_vec<N>([&](int i) { return word(two_difference(as_stored(x[i]), as_stored(y[i]))); });
    };
    constexpr double k = graze::squared_norm(make_vec<N>([](int) { return word_rounding::exact_input(); })).bound();
    const auto dx = difference(a.position, b.position);
    const word square = graze::squared_norm(dx).in_order();
    if (!within_powers<-900, 200>(square.high)) {
        return {};
    }
    const word_root<false> R(square, 1.0001 * k * square.high);
    const word ordered = R.value.in_order();
    return exchange_velocities(a.velocity, b.velocity, word_cross<false, N>(dx, difference(a.velocity, b.velocity), 0),
                               dx, vec<N, double>{}, exact_pair<double>{ordered.high, ordered.low},
                               1.1 * R.error / ordered.high);
}

// Takes components; of each velocity the bound that is narrower.
template <int N, class F>
struct narrower_velocities {
    F& take;
    exchanged_velocities<N> exchanged{};
    bool is_known = false;

    [[gnu::always_inline]] void operator()(const bounded<double>& x, int number) noexcept {
        if (is_known && number >= velocity_a) [[unlikely]] {
            take_narrower(x, number);
        } else {
            take(x, number);
        }
    }
    [[gnu::always_inline]] void operator()(const bounded<lanes>& x, int i, int j) noexcept {
        if (is_known && i >= velocity_a) [[unlikely]] {
            take_narrower({x.high[0], x.low[0], x.error[0]}, i);
            take_narrower({x.high[1], x.low[1], x.error[1]}, j);
        } else {
            take(x, i, j);
        }
    }

  private:
    static constexpr int velocity_a = static_cast<int>(contact_component::velocity_a);
    static constexpr int velocity_b = static_cast<int>(contact_component::velocity_b);

    [[gnu::noinline]] void take_narrower(const bounded<double>& x, int number) noexcept {
        const auto& other = number < velocity_b ? exchanged.a[number - velocity_a] : exchanged.b[number - velocity_b];
        take(other.error < x.error ? other : x, number);
    }
};

} // namespace graze::inline v0_1::detail
