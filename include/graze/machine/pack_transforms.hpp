// Error-free transforms, square roots and range checks for packs of lanes.
#pragma once

#include <graze/machine/error_free.hpp>
#include <graze/machine/lanes.hpp>
#include <graze/machine/pack.hpp>

#include <bit>
#include <cstdint>

namespace graze::inline v0_1::detail {

template <class T, int Lanes>
[[nodiscard, gnu::always_inline]] inline pack<T, Lanes> settled(pack<T, Lanes> x) noexcept {
    return pack<T, Lanes>::of(settled(x.value));
}

#if defined(__has_builtin)
#if __has_builtin(__builtin_elementwise_fma)
#define GRAZE_DETAIL_FMA __builtin_elementwise_fma
#endif
#endif
template <int Lanes>
[[nodiscard, gnu::always_inline]] inline pack<double, Lanes>
fused_residual(const pack<double, Lanes>& x, const pack<double, Lanes>& y, const pack<double, Lanes>& p) noexcept {
    using V = pack<double, Lanes>;
#if defined(GRAZE_DETAIL_FMA)
    return V::of(GRAZE_DETAIL_FMA(x.value, y.value, -p.value));
#elif defined(__FMA__)
    if constexpr (Lanes == 4) {
        return V::of(__builtin_ia32_vfmaddpd256(x.value, y.value, -p.value));
    } else if constexpr (Lanes == 2) {
        return V::of(__builtin_ia32_vfmaddpd(x.value, y.value, -p.value));
    }
#endif
    return V::made([&](int k) { return fused_residual(x[k], y[k], p[k]); });
}
#undef GRAZE_DETAIL_FMA

// √x of an x that is not negative.
template <int Lanes>
[[nodiscard, gnu::always_inline]] inline pack<double, Lanes> plain_sqrt(const pack<double, Lanes>& x) noexcept {
    using V = pack<double, Lanes>;
#if defined(__SSE2__) && !defined(__clang__)
    if constexpr (Lanes == 2) {
        return V::of(__builtin_ia32_sqrtpd(x.value));
    }
#if defined(__AVX__)
    if constexpr (Lanes == 4) {
        return V::of(__builtin_ia32_sqrtpd256(x.value));
    }
#endif
#elif defined(__clang__) && __clang_major__ >= 17
    return V::of(__builtin_elementwise_sqrt(x.value));
#endif
    return V::made([&](int k) { return plain_sqrt(x[k]); });
}

// Whether x is in [2^Low, 2^High).
template <int Low, int High, int Lanes>
[[nodiscard, gnu::always_inline]] inline pack_mask<double, Lanes> within_powers(const pack<double, Lanes>& x) noexcept {
    using V = pack<double, Lanes>;
    constexpr auto power = [](int e) { return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + e) << 52); };
    return ~(x < V(power(Low))) & (x < V(power(High)));
}

// Two packs side by side, as `lanes` are two doubles.
template <class V>
struct two_packs {
    V first, second;

    two_packs() = default;
    [[gnu::always_inline]] two_packs(const V& x, const V& y) noexcept : first(x), second(y) {}
    [[gnu::always_inline]] two_packs(double x, double y) noexcept : first(x), second(y) {}

    [[nodiscard, gnu::always_inline]] V operator[](int i) const noexcept { return i == 0 ? first : second; }
    [[nodiscard, gnu::always_inline]] friend inline two_packs operator-(const two_packs& x) noexcept {
        return {-x.first, -x.second};
    }
    [[nodiscard, gnu::always_inline]] friend inline two_packs operator+(const two_packs& x,
                                                                        const two_packs& y) noexcept {
        return {x.first + y.first, x.second + y.second};
    }
    [[nodiscard, gnu::always_inline]] friend inline two_packs operator-(const two_packs& x,
                                                                        const two_packs& y) noexcept {
        return {x.first - y.first, x.second - y.second};
    }
    [[nodiscard, gnu::always_inline]] friend inline two_packs operator*(const two_packs& x,
                                                                        const two_packs& y) noexcept {
        return {x.first * y.first, x.second * y.second};
    }
    [[nodiscard, gnu::always_inline]] friend inline two_packs operator*(const two_packs& x, double y) noexcept {
        return {y * x.first, y * x.second};
    }
    [[nodiscard, gnu::always_inline]] friend inline two_packs settled(const two_packs& x) noexcept {
        return {settled(x.first), settled(x.second)};
    }
    [[nodiscard, gnu::always_inline]] friend inline two_packs fused_residual(const two_packs& x, const two_packs& y,
                                                                             const two_packs& p) noexcept {
        return {fused_residual(x.first, y.first, p.first), fused_residual(x.second, y.second, p.second)};
    }
};
template <class T, int Lanes>
[[nodiscard, gnu::always_inline]] inline two_packs<pack<T, Lanes>> both(const pack<T, Lanes>& x) noexcept {
    return {x, x};
}

} // namespace graze::inline v0_1::detail
