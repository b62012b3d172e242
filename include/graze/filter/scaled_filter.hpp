// The filter of any formula of a motion, by the magnitudes of its inputs: |computed - exact| <= K length^i velocity^j
// normal^k.
#pragma once

#include <graze/filter/static_filter.hpp>

#include <cmath>
#include <type_traits>

namespace graze::inline v0_1::detail {

// Upper bounds on the norms of a motion's lengths, velocities and normals. They are sums of magnitudes, so that no root
// is taken.
struct magnitudes {
    double length = 0;
    double velocity = 0;
    double normal = 1;
};

// Without a branch, which random signs would mislead.
[[nodiscard]] constexpr double magnitude_of(double x) noexcept {
    return !std::is_constant_evaluated() ? std::fabs(x) : x < 0 ? -x : x;
}

// Σ|x_i|, an upper bound of the norm.
template <int N>
[[nodiscard, gnu::always_inline]] constexpr inline double sum_of_magnitudes(const vec<N, double>& x) noexcept {
    if constexpr (N == 2) {
        return magnitude_of(x[0]) + magnitude_of(x[1]);
    } else {
        return magnitude_of(x[0]) + magnitude_of(x[1]) + magnitude_of(x[2]);
    }
}

// The least of a scale in the filter's range.
template <class T>
inline constexpr double smallest_scale = std::is_same_v<T, float> ? 0x1p-30 : 0x1p-50;

// Whether the magnitudes are in the filter's range. In that range no formula of degree up to 12 in lengths, 4 in
// velocities and 10 in normals over- or underflows. Products of scales stay within 2^±800. A loss by flushing to zero
// is below 2^-1022, less than 2^-150 of them, and the slack of the constants (2^-92 of them) covers all losses. A
// subnormal float may be flushed when it is converted to double, so the range of floats starts higher. A NaN or an
// infinity among the inputs is out of range too.
template <class T>
[[nodiscard]] constexpr bool usable(const magnitudes& s) noexcept {
    constexpr int low = std::is_same_v<T, float> ? -30 : -50;
    return static_cast<unsigned>(within_powers<low, 50>(s.length)) &
           static_cast<unsigned>(within_powers<low, 50>(s.velocity)) &
           static_cast<unsigned>(within_powers<low, 50>(s.normal));
}

// For questions in which velocities don't matter: they may be zero, or read as zero.
constexpr void forget_rest_in(magnitudes& s) noexcept {
    s.velocity = std::bit_cast<std::uint64_t>(s.velocity) == 0 ? 1 : s.velocity;
}

// The bound of F.
template <class Bounds, class F>
[[nodiscard, gnu::always_inline]] constexpr inline double scaled_bound(const magnitudes& s) noexcept {
    constexpr double k = filter_constant(F{}, Bounds::value());
    constexpr error_bound::degrees d = filter_degrees(F{}, Bounds::value());
    static_assert(d[0] <= 12 && d[1] <= 4 && d[2] <= 10 && 50 * (d[0] + d[1] + d[2]) <= 800,
                  "outside the range that usable() checks");
    return k * (power_of<d[0]>(s.length) * power_of<d[1]>(s.velocity) * power_of<d[2]>(s.normal));
}

// The sign of F for a motion in doubles, or `open`. Bounds is a type whose value() is the same motion in error_bound.
template <class Bounds, class F, class M>
[[nodiscard]] constexpr int filtered_sign(F f, const M& motion, const magnitudes& s) noexcept {
    return certain_sign(f(motion), scaled_bound<Bounds, F>(s));
}

} // namespace graze::inline v0_1::detail
