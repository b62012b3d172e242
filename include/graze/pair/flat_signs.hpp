// The signs that decide what becomes of a ball and a flat thing, in doubles with a bound from the norms at hand.
#pragma once

#include <graze/filter/scaled_filter.hpp>
#include <graze/formula/flat_encounter.hpp>
#include <graze/pair/bounded_double.hpp>
#include <graze/pair/rounded_motion.hpp>
#include <graze/pair/stage.hpp>

#include <algorithm>

namespace graze::inline v0_1::detail {

// A flat motion's numbers for error_bound. The scale of lengths bounds |w| + r + Σ|e_i|, that of the third kind each
// |e_i|, and |e₁ - e₀| of a triangle: what is of a lower degree in w may be taken as one of a higher.
template <int N, class T>
struct flat_bounds {
    static constexpr int roundings = is_wide_integer<T> ? 8 : 3; // of w, from up to two edges further
    [[nodiscard]] static consteval error_bound edge() { return {1, bounded_input<T>({0, 0, 1}, 1).error, {0, 0, 1}}; }
    [[nodiscard]] static consteval flat_motion<N, error_bound> motion() {
        flat_motion<N, error_bound> m{bounded_vector<N>(detail::rounded(1, 0, 1, roundings, {1, 0, 0})),
                                      bounded_vector<N>(bounded_velocity<T>(0)),
                                      {},
                                      bounded_length<T>(0),
                                      true};
        for (auto& e : m.e) {
            e = bounded_vector<N>(edge());
        }
        return m;
    }
    [[nodiscard]] static consteval error_bound as_length(const error_bound& x) { // one edge of it
        return {x.magnitude, x.error, {x.degree[0] + 1, x.degree[1], x.degree[2] - 1}};
    }
    [[nodiscard]] static consteval flat_way<N, error_bound> way() {
        auto x = way_of(motion());
        x.facing = as_length(x.facing);
        return x;
    }
    [[nodiscard]] static consteval flat_extent<error_bound> extent() {
        const auto m = motion();
        const error_bound ue = as_length(graze::dot(m.u, m.e[0]));
        return {graze::dot(m.w, m.u), ue + ue, ue + ue};
    }
    [[nodiscard]] static consteval flat_edges<N, error_bound> edges() {
        const error_bound ee = graze::squared_norm(motion().e[0]);
        return {ee, ee, ee};
    }
    [[nodiscard]] static consteval flat_hull<N, error_bound> hull() {
        const auto m = motion();
        const error_bound ee = as_length(as_length(graze::squared_norm(m.e[0])));
        return {m.w + m.w, m.u, m.r, ee + ee + graze::twice(ee)};
    }
    [[nodiscard]] static consteval flat_place<N, error_bound> place() {
        auto x = place_of(motion(), way_of(motion()));
        x.facing = as_length(x.facing);
        return x;
    }
    // | |n| - |n̂| | <= |n - n̂|; the root of n̂·n̂, which is right to 4u, is right to 2u + 2u by its square
    // (filtered_judge).
    [[nodiscard]] static consteval flat_touch<N, error_bound> touch() {
        const auto x = way();
        const error_bound n = face_normal(motion().e)[0];
        return {{n.magnitude, n.error + 4 * n.magnitude, n.degree}, x.facing, x.r, x.at, x.pull};
    }
    [[nodiscard]] static consteval flat_edge<N, error_bound> border() {
        const auto m = motion();
        const auto w = way();
        const error_bound wd = graze::dot(m.w, m.e[0]), wu = graze::dot(m.w, m.u), dd = graze::dot(m.e[0], m.e[0]);
        const error_bound ud = graze::dot(m.u, m.e[0]);
        return {graze::dot(m.w, m.w),
                wd,
                wu,
                dd,
                ud,
                graze::dot(m.u, m.u),
                m.r,
                wd - as_length(dd),
                wu - as_length(ud),
                inside_border{}(w),
                inward_speed{}(w),
                w.speed,
                graze::cross(m.w, m.u)};
    }
};

// Which of these numbers a formula takes.
template <class B, int N>
[[nodiscard]] consteval auto bounds_like(const flat_way<N, double>*) {
    return B::way();
}
template <class B, int N>
[[nodiscard]] consteval auto bounds_like(const flat_place<N, double>*) {
    return B::place();
}
template <class B>
[[nodiscard]] consteval auto bounds_like(const flat_extent<double>*) {
    return B::extent();
}
template <class B, int N>
[[nodiscard]] consteval auto bounds_like(const flat_edges<N, double>*) {
    return B::edges();
}
template <class B, int N>
[[nodiscard]] consteval auto bounds_like(const flat_hull<N, double>*) {
    return B::hull();
}
template <class B, int N>
[[nodiscard]] consteval auto bounds_like(const flat_touch<N, double>*) {
    return B::touch();
}
template <class B, int N>
[[nodiscard]] consteval auto bounds_like(const flat_edge<N, double>*) {
    return B::border();
}

// Formulas whose terms are squares of what cancels by itself: their values tell more than the scales do.
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

// Of doubles that come from inputs of type T: by the scales and, where that leaves a sign open, by values.
template <int N, class T>
struct filtered_judge {
    static constexpr bool has_roots = true;
    magnitudes scales;
    mutable bool refined = false; // whether a sign was certain by values

    [[nodiscard]] constexpr stage decided_by() const noexcept {
        return !std::is_constant_evaluated() && refined ? stage::refined : stage::filter;
    }
    [[nodiscard]] constexpr double root_error() const noexcept {
        return error(touch_length{}, flat_touch<N, double>{});
    }
    // Not where the compiler has put a worse estimate in the place of the root.
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
            if (sign == open && !std::is_constant_evaluated()) [[unlikely]] { // constants have integers next
                return by_values(f, x);
            }
        }
        return sign;
    }

  private:
    // What is flushed to zero is below 2^-150 of the product of the scales (usable): 2^-100 of it is room for all.
    template <class F>
    [[nodiscard, gnu::noinline]] int by_values(F f, const flat_edge<N, double>& x) const noexcept {
        const bounded_double<52> y = f(with_bounds<flat_bounds<N, T>>(x, scales));
        const int sign = y.certain_sign(0x1p-48 * error(f, x));
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
rounded_flat_motion(const ball<N, T>& b, const vec<N, T>& corner, const std::array<vec<N, T>, N - 1>& edge,
                    bool is_triangle) noexcept {
    std::array<vec<N, double>, N - 1> e{};
    for (std::size_t i = 0; i + 1 < static_cast<std::size_t>(N); ++i) {
        e[i] = rounded(wide(edge[i]));
    }
    return {rounded(wide(b.position) - wide(corner)), rounded(wide(b.velocity)), e, to_double(wide(b.radius)),
            is_triangle};
}

} // namespace graze::inline v0_1::detail
