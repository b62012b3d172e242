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

} // namespace graze::inline v0_1
