// A value that the compiler may not simplify across, whatever it was allowed by -ffast-math.
#pragma once

namespace graze::detail {

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

} // namespace graze::detail
