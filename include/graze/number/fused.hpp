// Code with products of error-free transforms, for machines with a fused multiply-add and for those without.
#pragma once

#include <graze/number/error_free.hpp>

#include <type_traits>

namespace graze::detail {

#if defined(__GNUC__) && defined(__x86_64__) && !defined(__FMA__)
template <class F>
[[nodiscard, gnu::target("fma"), gnu::noinline]] auto run_fused(const F& f) noexcept {
    return f(std::true_type{});
}
#endif

// f(fused), fused a std::bool_constant for as_factor. Where the compiler may not assume the instruction, which nearly
// every x86-64 machine has, it is asked for when running. What f computes must not depend on the answer; f and what it
// calls is to be inlined, so that it is compiled for the machine with the instruction.
template <class F>
[[nodiscard, gnu::always_inline]] inline auto with_best_products(const F& f) noexcept {
#if defined(__GNUC__) && defined(__x86_64__) && !defined(__FMA__)
    if (__builtin_cpu_supports("fma")) {
        return run_fused(f);
    }
#endif
    return f(std::bool_constant<has_fused_multiply_add>{});
}

} // namespace graze::detail
