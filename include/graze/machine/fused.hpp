// Runs code with error-free products, compiled both with and without fused multiply-adds.
#pragma once

#include <graze/machine/error_free.hpp>

#include <type_traits>

namespace graze::inline v0_1::detail {

#if defined(__GNUC__) && defined(__x86_64__) && !defined(__FMA__)
// By value if it fits in registers.
template <class F>
using passed = std::conditional_t<sizeof(F) <= 16 && std::is_trivially_copyable_v<F>, F, const F&>;

template <class F>
[[nodiscard, gnu::target("fma"), gnu::noinline, gnu::flatten]] auto run_fused(passed<F> f) {
    return f(std::true_type{});
}
template <class F>
[[nodiscard, gnu::noinline, gnu::cold]] auto run_unfused(passed<F> f) { // seldom used: small rather than fast
    return f(std::false_type{});
}
#endif

// f(fused), with fused a std::bool_constant for as_factor. Nearly every x86-64 machine has the instruction; where the
// compiler may not assume it, the program checks for it when it runs. The result of f must not depend on the answer. f
// and the functions that it calls must be inlined, so that they are compiled for a machine with the instruction.
template <class F>
[[nodiscard, gnu::always_inline]] inline auto with_best_products(const F& f) {
#if defined(__GNUC__) && defined(__x86_64__) && !defined(__FMA__)
    return __builtin_cpu_supports("fma") ? run_fused<F>(f) : run_unfused<F>(f);
#else
    return f(std::bool_constant<has_fused_multiply_add>{});
#endif
}

// The same if a further stage can take over: `otherwise` makes the answer on a machine that turns out not to have the
// instruction. This spares every unit the code for such machines.
template <class F, class G>
[[nodiscard, gnu::always_inline]] inline auto with_fused_products_or(const F& f, [[maybe_unused]] const G& otherwise) {
#if defined(__GNUC__) && defined(__x86_64__) && !defined(__FMA__)
    return __builtin_cpu_supports("fma") ? run_fused<F>(f) : otherwise();
#else
    return f(std::bool_constant<has_fused_multiply_add>{});
#endif
}
template <class F, class R>
[[nodiscard, gnu::always_inline]] inline R with_fused_products(const F& f, const R& otherwise) {
    return with_fused_products_or(f, [&] { return otherwise; });
}

} // namespace graze::inline v0_1::detail
