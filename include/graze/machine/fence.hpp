// Optimisation barriers. Each returns its argument. After it a compiler may no longer
//
//   settled      fuse, reorder or simplify across x, even under -fassociative-math and contraction: for error-free
//                transforms
//   as_stored    see more of x than memory would hold: a caller's expression, a register of more precision, a
//                conversion to float that it has dropped
//   opaque       know where these bits come from: a comparison of bits stays one of bits
//   hidden       know the value of x: what a program asks of its floating-point environment is computed when it runs
//   read_alone   read x together with its neighbour in memory
//   all_hold     make several branches of one
#pragma once

#include <bit>
#include <cstdint>
#include <type_traits>

namespace graze::inline v0_1::detail {

// x. The compiler fuses, reorders or simplifies nothing across it.
template <class V>
[[nodiscard, gnu::always_inline]] constexpr inline V settled(V x) noexcept {
    if (std::is_constant_evaluated()) {
        return x;
    }
#if defined(__GNUC__)
    if constexpr (std::is_class_v<V>) { // fits no register, as lanes where there are no vectors
        __asm__("" : "+m"(x));
        return x;
    } else
#endif
    {
#if defined(__clang__) && defined(__x86_64__)
        __asm__("" : "+x"(x)); // __arithmetic_fence leaves products free to be fused
        return x;
#elif defined(__clang__) && defined(__aarch64__)
        __asm__("" : "+w"(x));
        return x;
#elif defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 12
        return __builtin_assoc_barrier(x);
#elif defined(__GNUC__)
        __asm__("" : "+m"(x));
        return x;
#else
        return x;
#endif
    }
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

// x, but the compiler knows nothing of its value.
[[nodiscard]] inline double hidden(double x) noexcept {
#if defined(__GNUC__)
    __asm__ volatile("" : "+m"(x));
    return x;
#else
    volatile double y = x;
    return y;
#endif
}

// Infinity. A compiler does not see that it is one: under -ffast-math it would assume that there is none.
[[nodiscard, gnu::always_inline]] constexpr inline double hidden_infinity() noexcept {
    return std::bit_cast<double>(opaque(std::uint64_t{0x7ff} << 52));
}

// x, read by itself. If a compiler sees its neighbour in memory, it would read both at once, and that would wait until
// both had been written, one by one.
[[nodiscard, gnu::always_inline]] inline double read_alone(double x) noexcept {
#if defined(__GNUC__) && defined(__SSE2_MATH__)
    __asm__("" : "+x"(x));
#endif
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
