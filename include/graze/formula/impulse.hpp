// What an elastic collision does to the velocities: Eqs. (23) to (29). Masses enter as their inverses w = 1/m, so that
// w = 0 is a ball of infinite mass, also in number types without an infinity.
#pragma once

#include <graze/linear/vec.hpp>

namespace graze::inline v0_1 {

// μ of (28).
template <class W>
[[nodiscard]] constexpr auto reduced_mass(const W& inverse_a, const W& inverse_b) {
    return W(1) / (inverse_a + inverse_b);
}

// α of (29), with X̂·Δu an inner product. Negative for balls that approach (errata: not positive), zero for a graze.
template <int N, class M, class X, class U>
[[nodiscard]] constexpr auto impulse(const M& reduced, const vec<N, X>& normal, const vec<N, U>& du) {
    return graze::twice(reduced) * graze::dot(normal, du);
}

// v_a of (23); v_b is the same with -α.
template <int N, class U, class A, class W, class X>
[[nodiscard]] constexpr auto velocity_after(const vec<N, U>& u, const A& alpha, const W& inverse_mass,
                                            const vec<N, X>& normal) {
    const auto change = alpha * inverse_mass;
    return make_vec<N>([&](int i) { return u[i] - change * normal[i]; });
}

// v = u - 2 (u·n̂) n̂ for a unit normal n̂. The source omits this equation.
template <int N, class U, class X>
[[nodiscard]] constexpr auto reflected(const vec<N, U>& u, const vec<N, X>& normal) {
    const auto change = graze::twice(graze::dot(u, normal));
    return make_vec<N>([&](int i) { return u[i] - change * normal[i]; });
}

// The same for a normal n of any length, without a root: u - (2 (u·n)/(n·n)) n.
template <int N, class U, class X>
[[nodiscard]] constexpr auto reflected_unnormalised(const vec<N, U>& u, const vec<N, X>& normal) {
    const auto change = graze::twice(graze::dot(u, normal)) / graze::squared_norm(normal);
    return make_vec<N>([&](int i) { return u[i] - change * normal[i]; });
}

} // namespace graze::inline v0_1
