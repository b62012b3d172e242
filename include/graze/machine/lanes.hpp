// Two doubles side by side, worked on together where the machine can.
#pragma once

#include <graze/machine/fence.hpp>

#include <cmath>

namespace graze::inline v0_1::detail {

#if defined(__GNUC__) && (defined(__SSE2__) || !defined(__i386__))
// GNU's vector extension: operators go lane by lane, on targets without such registers as well.
typedef double lanes __attribute__((vector_size(16)));
#else
struct lanes {
    double lane[2];

    [[nodiscard]] constexpr double operator[](int i) const noexcept { return lane[i]; }
    [[nodiscard]] friend constexpr lanes operator-(const lanes& x) noexcept { return {-x[0], -x[1]}; }
    [[nodiscard]] friend constexpr lanes operator+(const lanes& x, const lanes& y) noexcept {
        return {x[0] + y[0], x[1] + y[1]};
    }
    [[nodiscard]] friend constexpr lanes operator-(const lanes& x, const lanes& y) noexcept { return x + -y; }
    [[nodiscard]] friend constexpr lanes operator*(const lanes& x, const lanes& y) noexcept {
        return {x[0] * y[0], x[1] * y[1]};
    }
    [[nodiscard]] friend constexpr lanes operator*(double x, const lanes& y) noexcept { return lanes{x, x} * y; }
    [[nodiscard]] friend constexpr lanes operator*(const lanes& x, double y) noexcept { return y * x; }
    [[nodiscard]] friend constexpr lanes operator+(const lanes& x, double y) noexcept { return x + lanes{y, y}; }
    [[nodiscard]] friend constexpr lanes operator-(double x, const lanes& y) noexcept { return lanes{x, x} - y; }
    [[nodiscard]] friend constexpr lanes operator/(double x, const lanes& y) noexcept { return {x / y[0], x / y[1]}; }
};
#endif

[[nodiscard, gnu::always_inline]] inline lanes both(double x) noexcept { return lanes{x, x}; }

// √x for x >= 0, without the check for x < 0 that std::sqrt makes to set errno.
[[nodiscard, gnu::always_inline]] inline double plain_sqrt(double x) noexcept {
#if defined(__GNUC__) && defined(__SSE2_MATH__)
    return __builtin_ia32_sqrtsd(lanes{x, 0})[0];
#else
    return std::sqrt(x);
#endif
}

[[nodiscard, gnu::always_inline]] inline double absolute(double x) noexcept { return std::fabs(x); }
[[nodiscard, gnu::always_inline]] inline lanes absolute(const lanes& x) noexcept {
    return lanes{std::fabs(x[0]), std::fabs(x[1])};
}

} // namespace graze::inline v0_1::detail
