// Two doubles side by side, worked on together where the machine can.
#pragma once

namespace graze::detail {

// GNU's vector extension, which g++ and clang have on every target: arithmetic goes lane by lane.
typedef double lanes __attribute__((vector_size(16)));

[[nodiscard, gnu::always_inline]] inline lanes both(double x) noexcept { return lanes{x, x}; }

[[nodiscard, gnu::always_inline]] inline lanes absolute(const lanes& x) noexcept {
    return lanes{__builtin_fabs(x[0]), __builtin_fabs(x[1])};
}
[[nodiscard, gnu::always_inline]] inline double absolute(double x) noexcept { return __builtin_fabs(x); }

} // namespace graze::detail
