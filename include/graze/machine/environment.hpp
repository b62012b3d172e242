// Whether doubles round as error-free transforms need it: to nearest, once each, subnormals kept.
#pragma once

#include <graze/machine/fence.hpp>

#include <cstdint>

namespace graze::inline v0_1::detail {

// Whether this holds as far as compile time can tell: no -ffast-math nor any part of it that a macro shows, no x87
// registers. Clang has no macro for -fassociative-math alone; the transforms are settled against it.
#if defined(__GNUC__) && defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ == 0 && !defined(__FAST_MATH__) &&        \
    !defined(__ASSOCIATIVE_MATH__) && !defined(__RECIPROCAL_MATH__) && !defined(__NO_SIGNED_ZEROS__) &&                \
    !(defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
inline constexpr bool has_error_free_doubles = true;
#else
inline constexpr bool has_error_free_doubles = false;
#endif

// Whether the environment is right, by calculating: 1 + 2^-55 = 1 - 2^-55 only to nearest; and 2^-1023, the difference
// of two normal numbers, is kept, so that twice it is 2^-1022.
[[nodiscard]] inline bool calculates_to_nearest() noexcept {
    const double one = hidden(1);
    const double half_subnormal = hidden(0x1.8p-1022) - 0x1p-1022;
    return (one + 0x1p-55 == one - 0x1p-55) & (half_subnormal + half_subnormal == 0x1p-1022);
}

// Whether sums are rounded to nearest, by two sums in registers: 1 + 2^-55 = 1 - 2^-55 only to nearest. Reading the
// control register would wait for all sums that may still set its flags.
[[nodiscard, gnu::always_inline]] inline bool adds_to_nearest() noexcept {
    double one = 1;
#if defined(__SSE2_MATH__)
    __asm__ volatile("" : "+x"(one));
#else
    one = hidden(one);
#endif
    return one - 0x1p-55 >= one + 0x1p-55; // cheaper than ==
}

// Whether subnormals are read and written as they are.
[[nodiscard, gnu::always_inline]] inline bool keeps_subnormals() noexcept {
#if defined(__SSE2_MATH__)
    return (__builtin_ia32_stmxcsr() & 0x8040U) == 0; // flush-to-zero, denormals-are-zero
#elif defined(__aarch64__)
    std::uint64_t control;
    __asm__ volatile("mrs %0, fpcr" : "=r"(control));
    return (control & 0x1000001U) == 0; // FZ, FIZ
#else
    const double half_subnormal = hidden(0x1.8p-1022) - 0x1p-1022;
    return half_subnormal + half_subnormal == 0x1p-1022;
#endif
}

// Whether the environment is right when the program runs, by reading the control register if the machine has one.
[[nodiscard, gnu::always_inline]] inline bool rounds_to_nearest() noexcept {
#if defined(__SSE2_MATH__)
    return (__builtin_ia32_stmxcsr() & 0xe040U) == 0; // rounding direction, flush-to-zero, denormals-are-zero
#elif defined(__aarch64__)
    std::uint64_t control;
    __asm__ volatile("mrs %0, fpcr" : "=r"(control));
    return (control & 0x1c00001U) == 0; // RMode, FZ, FIZ
#else
    return calculates_to_nearest();
#endif
}

} // namespace graze::inline v0_1::detail
