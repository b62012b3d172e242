// Barriers: the compiler may not simplify across these values, whatever -ffast-math or contraction allows.
#pragma once

#include <cstdint>
#include <type_traits>

namespace graze::inline v0_1::detail {

// x. The compiler does not merge the expression that uses it with the expression that made it.
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

// x as memory would hold it. Where a predicate is inlined, a caller's argument `p + d` may still be an expression.
// Under -ffast-math, contraction or x87 a filter would then see another number than the integers, which read the stored
// bits. g++ 12 even drops a caller's conversion to float when it vectorises the conversion back (-O3), unless it has to
// fill a register.
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

// x, but the compiler no longer knows where it comes from.
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

// Whether all conditions hold, by one branch where compilers would make several. Branches that always go the same way
// cost little by themselves, but they take room in the predictor from others.
template <class... B>
[[nodiscard, gnu::always_inline]] inline bool all_hold(B... conditions) noexcept {
    unsigned all = (static_cast<unsigned>(conditions) & ...);
#if defined(__GNUC__)
    __asm__("" : "+r"(all));
#endif
    return all != 0;
}

} // namespace graze::inline v0_1::detail
