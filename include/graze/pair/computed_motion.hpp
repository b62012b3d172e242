// A pair's relative motion in doubles, for filters, and how far it is from the exact one.
#pragma once

#include <graze/analysis/error_bound.hpp>
#include <graze/exact/binary.hpp>
#include <graze/exact/integer.hpp>
#include <graze/formula/plane_crossing.hpp>
#include <graze/formula/relative_motion.hpp>
#include <graze/machine/fence.hpp>
#include <graze/number/floating.hpp>

#include <type_traits>

namespace graze::inline v0_1::detail {

// x as a double: with a relative error of at most 2u for a 64-bit integer and its differences, exactly for all other
// inputs.
template <int B>
[[nodiscard]] constexpr double to_double(const integer<B>& x) noexcept {
    static_assert(B <= 66);
    const integer<B> magnitude = x.is_negative() ? -x : x;
    const double value = static_cast<double>(magnitude.limb(1)) * 0x1p64 +
                         static_cast<double>(magnitude.limb(0)); // one of them is small
    return x.is_negative() ? -value : value;
}
[[nodiscard]] constexpr double to_double(double x) noexcept { return x; }

// float, double and int32 are exact as doubles; a difference of 64-bit integers is taken before it is rounded.
template <class T>
using difference_type = std::conditional_t<is_wide_integer<T>, integer<64>, double>;

template <class T>
[[nodiscard]] constexpr auto wide(const T& x) noexcept {
    return static_cast<difference_type<T>>(as_stored(x));
}
template <int N, class T>
[[nodiscard]] constexpr auto wide(const vec<N, T>& x) noexcept {
    return make_vec<N>([&](int i) { return wide(x[i]); });
}
template <int N, class T>
[[nodiscard]] constexpr auto rounded(const vec<N, T>& x) noexcept {
    return make_vec<N>([&](int i) { return to_double(x[i]); });
}

template <int N, class T>
[[nodiscard, gnu::always_inline]] constexpr inline auto computed_motion(const ball<N, T>& a,
                                                                        const ball<N, T>& b) noexcept {
    using D = difference_type<T>;
    const auto m = relative_motion_of(ball<N, D>{wide(a.position), wide(a.velocity), wide(a.radius)},
                                      ball<N, D>{wide(b.position), wide(b.velocity), wide(b.radius)});
    return relative_motion{rounded(m.dx), rounded(m.du), to_double(m.R)};
}

template <int N, class T>
[[nodiscard]] constexpr auto computed_motion(const ball<N, T>& b, const plane<N, T>& p) noexcept {
    return plane_motion{rounded(wide(b.position) - wide(p.point)), rounded(wide(b.velocity)), rounded(wide(p.normal)),
                        to_double(wide(b.radius))};
}

// The same motions for error_bound, each vector against the scale that bounds its norm. Inputs of double and narrower
// types are exact and their differences rounded once; numbers from 64-bit integers are rounded at most twice.
template <class T>
[[nodiscard]] consteval error_bound bounded_input(error_bound::degrees d, int roundings) {
    const int count = is_wide_integer<T> ? 2 : roundings;
    return detail::rounded(1, 0, 1, count, d);
}
template <class T>
[[nodiscard]] consteval error_bound bounded_length(int roundings) {
    return {1, bounded_input<T>({1, 0, 0}, roundings).error, {1, 0, 0}};
}
template <class T>
[[nodiscard]] consteval error_bound bounded_velocity(int roundings) {
    return {1, bounded_input<T>({0, 1, 0}, roundings).error, {0, 1, 0}};
}
template <class T>
[[nodiscard]] consteval error_bound bounded_normal() {
    return {1, bounded_input<T>({0, 0, 1}, 0).error, {0, 0, 1}};
}

template <int N, class T>
struct ball_bounds {
    [[nodiscard]] static consteval auto value() {
        return relative_motion{bounded_vector<N>(bounded_length<T>(1)), bounded_vector<N>(bounded_velocity<T>(1)),
                               bounded_length<T>(1)};
    }
};
template <int N, class T>
struct plane_bounds {
    [[nodiscard]] static consteval auto value() {
        return plane_motion{bounded_vector<N>(bounded_length<T>(1)), bounded_vector<N>(bounded_velocity<T>(0)),
                            bounded_vector<N>(bounded_normal<T>()), bounded_length<T>(0)};
    }
};

} // namespace graze::inline v0_1::detail
