// Whether all numbers of an interval round to the same number.
#pragma once

#include <graze/exact/binary.hpp>
#include <graze/exact/rounding.hpp>
#include <graze/machine/error_free.hpp>
#include <graze/machine/lanes.hpp>

#include <type_traits>

namespace graze::inline v0_1::detail {

// A number that is within `error` of high + low.
template <class V>
struct bounded {
    V high, low, error;
};

// The ends of that interval, each rounded to the nearest double. For T = float they are moved outwards by more than
// that rounding, so that nothing is rounded twice.
template <class V>
struct ends {
    V lower, upper;
};
template <class T, class V>
[[nodiscard, gnu::always_inline]] inline ends<V> ends_of(const bounded<V>& x) noexcept {
    V error = x.error;
    if constexpr (std::is_same_v<T, float>) {
        error += 0x1p-51 * (absolute(x.high) + absolute(x.low));
    }
    return {settled(x.high + settled(x.low - error)), settled(x.high + settled(x.low + error))};
}

// Added to an error, for losses by underflow. Where it is used, lengths and velocities are within 2^±150, masses within
// 2^±200, and 1/R is below 2^203: a loss of 2^-1071 in y is below 2^-860 in a normal and 2^-710 in a velocity. So
// results below 2^-647 are not certain, nor is any exact zero.
inline constexpr double underflow = 0x1p-700;

// Whether both ends round to the same T, except to a zero, whose sign would be open. Every number between them then
// rounds to it, since rounding is monotonic.
template <class T>
[[nodiscard, gnu::always_inline]] inline bool agree(const ends<double>& x) noexcept {
    if constexpr (std::is_same_v<T, double>) {
        return x.lower >= x.upper; // the ends are in order, and no NaN: cheaper than ==
    } else {
        return static_cast<T>(x.lower) == static_cast<T>(x.upper) && static_cast<T>(x.lower) != 0;
    }
}

// The same for two lanes, in bits 0 and 1.
template <class T>
[[nodiscard, gnu::always_inline]] inline unsigned agreeing(const ends<lanes>& x) noexcept {
#if defined(__SSE2__)
    if constexpr (std::is_same_v<T, double>) {
        return static_cast<unsigned>(__builtin_ia32_movmskpd(reinterpret_cast<lanes>(x.lower == x.upper)));
    }
#endif
    return static_cast<unsigned>(agree<T>({x.lower[0], x.upper[0]})) |
           static_cast<unsigned>(agree<T>({x.lower[1], x.upper[1]})) << 1;
}

// A rounded number, or none where a doubt is left. Compilers keep it in registers; a std::optional they send through
// memory, and its parts are then waited for.
template <class T>
struct certain_number {
    T value{};
    bool is_certain = false;

    [[nodiscard]] constexpr explicit operator bool() const noexcept { return is_certain; }
    [[nodiscard]] constexpr T operator*() const noexcept { return value; }
};

// A positive number rounded to nearest, downward or upward; none where its bounds leave a doubt. For floats in
// directed modes they always do.
template <class T>
[[nodiscard]] inline certain_number<T> certainly_rounded(const bounded<double>& x, rounding mode) noexcept {
    if (mode == rounding::nearest) {
        const ends<double> interval = ends_of<T>(x);
        return {static_cast<T>(interval.upper), agree<T>(interval)};
    }
    if constexpr (std::is_same_v<T, double>) {
        // The number is r + rest ± error, r the nearest double. The sign of rest tells on which side of r it is.
        const auto [r, rest] = two_sum(x.high, x.low);
        if (r > 0x1p-900 && absolute(rest) > x.error) {
            const std::uint64_t bits = bits_of(r);
            const bool above = rest > 0;
            return {std::bit_cast<double>(mode == rounding::downward ? (above ? bits : bits - 1)
                                                                     : (above ? bits + 1 : bits)),
                    true};
        }
    }
    return {};
}

} // namespace graze::inline v0_1::detail
