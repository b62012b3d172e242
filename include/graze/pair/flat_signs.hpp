// The signs that decide the encounter of a ball with a flat shape, in doubles, with a bound from the present norms.
#pragma once

#include <graze/filter/scaled_filter.hpp>
#include <graze/formula/flat_encounter.hpp>
#include <graze/pair/bounded_double.hpp>
#include <graze/pair/computed_motion.hpp>
#include <graze/pair/flat_bounds.hpp>
#include <graze/pair/stage.hpp>

#include <algorithm>

namespace graze::inline v0_1::detail {

// Formulas whose terms are squares of differences that cancel: their values give closer bounds than the scales.
template <class F>
inline constexpr bool gains_by_values = false;
template <>
inline constexpr bool gains_by_values<border_discriminant> = true;
template <>
inline constexpr bool gains_by_values<corner_discriminant> = true;
template <class Nearest>
inline constexpr bool gains_by_values<touch_along_norm<Nearest>> = true;
template <>
inline constexpr bool gains_by_values<touch_outside_norm> = true;
template <>
inline constexpr bool gains_by_values<touch_behind_norm> = true;

template <class B, int N>
inline constexpr flat_edge<N, error_bound> border_bounds = B::border();

// The numbers of a border, each with the bound that the scales give it.
template <class B, int N>
[[nodiscard, gnu::always_inline]] constexpr inline flat_edge<N, bounded_double<52>>
with_bounds(const flat_edge<N, double>& x, const magnitudes& s) noexcept {
    using number = bounded_double<52>;
    const auto with = [&s]<class Get>(const auto& numbers, Get get) {
        constexpr error_bound b = get(border_bounds<B, N>);
        constexpr double k = b.error * error_bound::unit * error_bound::slack;
        return number(get(numbers), k * (power_of<b.degree[0]>(s.length) * power_of<b.degree[1]>(s.velocity) *
                                         power_of<b.degree[2]>(s.normal)));
    };
    const auto component = [&](int i) {
        if constexpr (N == 2) {
            return with(x, [](const auto& e) { return e.moment; });
        } else {
            const auto of_first = with(x, [](const auto& e) { return e.moment[0]; });
            return number(x.moment[i], of_first.error());
        }
    };
    flat_edge<N, number> r{
        with(x, [](const auto& e) { return e.ww; }),     with(x, [](const auto& e) { return e.wd; }),
        with(x, [](const auto& e) { return e.wu; }),     with(x, [](const auto& e) { return e.dd; }),
        with(x, [](const auto& e) { return e.ud; }),     with(x, [](const auto& e) { return e.uu; }),
        with(x, [](const auto& e) { return e.r; }),      with(x, [](const auto& e) { return e.far_wd; }),
        with(x, [](const auto& e) { return e.far_wu; }), with(x, [](const auto& e) { return e.inside; }),
        with(x, [](const auto& e) { return e.inward; }), with(x, [](const auto& e) { return e.speed; })};
    if constexpr (N == 2) {
        r.moment = component(0);
    } else {
        r.moment = make_vec<3>(component);
    }
    return r;
}

// For doubles that come from inputs of type T: by the scales and, where these leave a sign open, by values.
template <int N, class T>
struct filtered_judge {
    static constexpr bool has_roots = true;
    static constexpr bool sees_no_zero = true;
    magnitudes scales;
    mutable bool refined = false; // whether a sign was certain by values

    [[nodiscard]] constexpr stage decided_by() const noexcept {
        return !std::is_constant_evaluated() && refined ? stage::refined : stage::filter;
    }
    [[nodiscard]] constexpr double root_error() const noexcept {
        return error(touch_length{}, flat_touch<N, double>{});
    }
    // Not if the compiler has replaced the root by a worse estimate.
    [[nodiscard]] constexpr bool root(double x, double& y) const noexcept {
        y = number_traits<double>::sqrt(x);
        return magnitude_of(y * y - x) <= 0x1p-50 * x;
    }

    template <class X>
    struct bounds {
        [[nodiscard]] static consteval auto value() {
            return bounds_like<flat_bounds<N, T>>(static_cast<const X*>(nullptr));
        }
    };
    // How far F(x) may be from the exact number.
    template <class F, class X>
    [[nodiscard]] constexpr double error(F, const X&) const noexcept {
        return scaled_bound<bounds<X>, F>(scales);
    }
    template <class F, class X>
    [[nodiscard, gnu::always_inline]] constexpr int operator()(F f, const X& x) const noexcept {
        const int sign = filtered_sign<bounds<X>>(f, x, scales);
        if constexpr (gains_by_values<F>) {
            if (sign == open && !std::is_constant_evaluated()) [[unlikely]] { // constants go on in integers
                return by_values(f, x);
            }
        }
        return sign;
    }
    // The clearance from the plane, with the motion: near contact its terms are r² n·n, far below what the scales
    // allow.
    [[nodiscard, gnu::always_inline]] constexpr int operator()(way_clearance f, const flat_way<N, double>& x,
                                                               const flat_motion<N, double>& m) const noexcept {
        const int sign = (*this)(f, x);
        if (sign == open && !std::is_constant_evaluated()) [[unlikely]] {
            return by_values(m, error(f, x));
        }
        return sign;
    }

  private:
    // Losses by flushing to zero are below 2^-150 of the product of the scales (usable): 2^-100 of it is enough.
    template <class F>
    [[nodiscard, gnu::noinline]] int by_values(F f, const flat_edge<N, double>& x) const noexcept {
        return certain(f(with_bounds<flat_bounds<N, T>>(x, scales)), error(f, x));
    }
    // What is not exact of the motion is off by one rounding, from 64-bit integers by two.
    // A subnormal float that is read as zero is below 2^-96 of its scale (usable), and a dozen of them cost the
    // clearance less than 2^-90 of the scales' products. 2^-40 of the bound by scales, above 2^-88, is room for that.
    [[nodiscard, gnu::noinline]] int by_values(const flat_motion<N, double>& m, double by_scales) const noexcept {
        using number = bounded_double<52>;
        constexpr double of_input = is_wide_integer<T> ? 3 * error_bound::unit : 0;
        constexpr double of_difference = is_wide_integer<T> ? of_input : error_bound::unit;
        const auto with = [](const vec<N, double>& x, double part) {
            return make_vec<N>([&](int i) { return number(x[i], part * magnitude_of(x[i])); });
        };
        std::array<vec<N, number>, N - 1> e{};
        for (std::size_t i = 0; i < e.size(); ++i) {
            e[i] = with(m.e[i], of_input);
        }
        const auto w = with(m.w, of_difference);
        return certain(plane_clearance{}(plane_motion{w, w, face_normal(e), number(m.r, of_input * m.r)}),
                       0x1p8 * by_scales);
    }
    [[nodiscard]] int certain(const bounded_double<52>& x, double by_scales) const noexcept {
        const int sign = x.certain_sign(0x1p-48 * by_scales);
        refined = refined || sign != 0;
        return sign != 0 ? sign : open;
    }
};

// Σ|w_i| + r + ΣΣ|e_i|, Σ|u_i| and the largest edge.
template <int N>
[[nodiscard, gnu::always_inline]] constexpr inline magnitudes magnitudes_of(const flat_motion<N, double>& m) noexcept {
    double sum = 0;
    double largest = 0;
    for (const auto& e : m.e) {
        const double size = sum_of_magnitudes(e);
        sum += size;
        largest = std::max(largest, size);
    }
    return {sum_of_magnitudes(m.w) + m.r + sum, sum_of_magnitudes(m.u), N == 3 && m.is_triangle ? sum : largest};
}

template <int N, class T>
[[nodiscard, gnu::always_inline]] constexpr inline flat_motion<N, double>
computed_flat_motion(const ball<N, T>& b, const vec<N, T>& corner, const std::array<vec<N, T>, N - 1>& edge,
                     bool is_triangle) noexcept {
    std::array<vec<N, double>, N - 1> e{};
    for (std::size_t i = 0; i + 1 < static_cast<std::size_t>(N); ++i) {
        e[i] = rounded(wide(edge[i]));
    }
    return {rounded(wide(b.position) - wide(corner)), rounded(wide(b.velocity)), e, to_double(wide(b.radius)),
            is_triangle};
}

} // namespace graze::inline v0_1::detail
