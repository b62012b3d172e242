// Values that the compiler may not simplify across, whatever it was allowed by -ffast-math or contraction.
#pragma once

#include <cstdint>
#include <type_traits>

namespace graze::inline v0_1::detail {

// x; what consumes it is not merged with the expression that made it.
[[nodiscard]] inline double fence(double x) noexcept {
#if defined(__clang__) && (defined(__x86_64__) || defined(__i386__) || defined(__aarch64__))
    return __arithmetic_fence(x); // an error on clang's other targets, although __has_builtin knows it there
#elif defined(__clang__) || defined(__GNUC__) && __GNUC__ < 12
    __asm__("" : "+m"(x));
    return x;
#elif defined(__GNUC__)
    return __builtin_assoc_barrier(x);
#else
    return x;
#endif
}

// x as memory holds it. A caller's `p + d` may still be an expression where a predicate is inlined: under -ffast-math,
// contraction or x87 a filter would otherwise see another number than the exact tier, which reads the stored bits. g++
// 12 even forgets a caller's conversion to float when it vectorises the conversion back (-O3), but for a register that
// it has to fill.
template <class T>
[[nodiscard]] constexpr T as_stored(T x) noexcept {
    if constexpr (std::is_floating_point_v<T>) {
        if (!std::is_constant_evaluated()) {
#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0
            __asm__("" : "+m"(x));
#elif defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 12
            if constexpr (std::is_same_v<T, double>) {
                return __builtin_assoc_barrier(x); // also keeps a product from being fused with a sum
            }
#endif
#if defined(__GNUC__) && defined(__SSE2__)
            __asm__("" : "+x"(x)); // clang's fence lets products fuse under -ffp-contract=fast
#elif defined(__GNUC__) && defined(__aarch64__)
            __asm__("" : "+w"(x));
#elif defined(__GNUC__)
            __asm__("" : "+m"(x));
#endif
        }
    }
    return x;
}

// The same integer, of which the compiler no longer knows where it comes from.
[[nodiscard]] constexpr std::uint64_t opaque(std::uint64_t x) noexcept {
    if (!std::is_constant_evaluated()) {
#if defined(__GNUC__) && defined(__i386__)
        __asm__("" : "+m"(x));
#elif defined(__GNUC__)
        __asm__("" : "+r"(x));
#endif
    }
    return x;
}

// Whether all hold, asked by one branch where compilers would make several: those that always go the same way cost
// little by themselves, but what a predictor remembers of the others.
template <class... B>
[[nodiscard, gnu::always_inline]] inline bool all_hold(B... conditions) noexcept {
    unsigned all = (static_cast<unsigned>(conditions) & ...);
#if defined(__GNUC__)
    __asm__("" : "+r"(all));
#endif
    return all != 0;
}

} // namespace graze::inline v0_1::detail
