// Positions and normal at the contact: Eqs. (5), (13), (19) and (20).
#pragma once

#include <graze/linear/vec.hpp>

namespace graze::inline v0_1 {

// x + u t: (5), (13), (30).
template <int N, class X, class U, class T>
[[nodiscard]] constexpr auto position_at(const vec<N, X>& x, const vec<N, U>& u, const T& t) {
    return make_vec<N>([&](int i) { return x[i] + u[i] * t; });
}

// X̂ of (20): Δx + Δu τ over R. Only at contact is R the distance (errata).
template <int N, class X, class S>
[[nodiscard]] constexpr auto contact_normal(const vec<N, X>& dx_at_contact, const S& R) {
    return dx_at_contact / R;
}

// dx + du·τ by its parts across du and along it, which do not cancel however far away the balls start: with τ = (-h -
// √D)/a it is (du × (dx × du))/a - (√D/a) du. cross: (dx × du)/a, root: √D/a.
template <class U, class X, class W>
[[nodiscard]] constexpr auto separation_at_contact(const vec<3, U>& du, const vec<3, X>& cross, const W& root) {
    return graze::cross(du, cross) - root * du;
}
template <class U, class X, class W>
[[nodiscard]] constexpr auto separation_at_contact(const vec<2, U>& du, const X& cross, const W& root) {
    const auto first = du[1] * cross - root * du[0];
    return vec<2, std::remove_cvref_t<decltype(first)>>{{first, -(du[0] * cross) - root * du[1]}};
}

} // namespace graze::inline v0_1
