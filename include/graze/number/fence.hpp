// A value that the compiler may not simplify across, whatever it was allowed by -ffast-math.
#pragma once

namespace graze::detail {

[[nodiscard]] inline double fence(double x) noexcept {
#if defined(__has_builtin)
#if __has_builtin(__builtin_assoc_barrier)
    return __builtin_assoc_barrier(x);
#elif __has_builtin(__arithmetic_fence)
    return __arithmetic_fence(x);
#else
    return x;
#endif
#else
    return x;
#endif
}

} // namespace graze::detail
