// Code with products of error-free transforms, for machines with a fused multiply-add and for those without.
#pragma once

#include <graze/machine/error_free.hpp>

#include <type_traits>

namespace graze::inline v0_1::detail {

#if defined(__GNUC__) && defined(__x86_64__) && !defined(__FMA__)
// By value where registers hold it.
template <class F>
using passed = std::conditional_t<sizeof(F) <= 16 && std::is_trivially_copyable_v<F>, F, const F&>;

template <class F>
[[nodiscard, gnu::target("fma"), gnu::noinline]] auto run_fused(passed<F> f) {
    return f(std::true_type{});
}
template <class F>
[[nodiscard, gnu::noinline]] auto run_unfused(passed<F> f) { // beside the code that calls it, which is mostly not used
    return f(std::false_type{});
}
#endif

// f(fused), fused a std::bool_constant for as_factor. Where the compiler may not assume the instruction, which nearly
// every x86-64 machine has, it is asked for when running. What f computes must not depend on the answer; f and what it
// calls is to be inlined, so that it is compiled for the machine with the instruction.
template <class F>
[[nodiscard, gnu::always_inline]] inline auto with_best_products(const F& f) {
#if defined(__GNUC__) && defined(__x86_64__) && !defined(__FMA__)
    return __builtin_cpu_supports("fma") ? run_fused<F>(f) : run_unfused<F>(f);
#else
    return f(std::bool_constant<has_fused_multiply_add>{});
#endif
}

} // namespace graze::inline v0_1::detail
