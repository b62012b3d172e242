// Eqs. (5), (13), (19) and (20): where two balls are at τ, as identities in Q(√D).
#include <graze/formula/contact.hpp>
#include <graze/formula/discriminant.hpp>
#include <graze/formula/roots.hpp>

#include "../variables.hpp"

namespace {

using namespace graze;
using proof::letter;
using proof::vector;
using function = rational_function<2048>;

// The centres' difference at any time t is Δx + Δu t, wherever the balls are.
template <int N>
constexpr bool positions_differ_as_they_move() {
    using letters = proof::letters;
    const ball<N, letters> a{vector<N>(0), vector<N>(N), letter(4 * N)};
    const ball<N, letters> b{vector<N>(2 * N), vector<N>(3 * N), letter(4 * N)};
    const letters t = letter(15);
    const auto m = relative_motion_of(a, b);
    return position_at(a.position, a.velocity, t) - position_at(b.position, b.velocity, t) ==
           position_at(m.dx, m.du, t);
}
static_assert(positions_differ_as_they_move<2>() && positions_differ_as_they_move<3>());

// Δx, Δu, R as letters; S = √D a letter of which the square is D.
template <int N>
struct impact {
    relative_motion<N, function, function, function> m{vector<N, function>(0), vector<N, function>(N),
                                                       letter<function>(2 * N)};
    function S = letter<function>(2 * N + 1);
    function tau = root_stable{}(coefficient_c{}(m), coefficient_h{}(m), S);
    vec<N, function> normal = contact_normal(position_at(m.dx, m.du, tau), m.R);

    [[nodiscard]] constexpr bool is_zero(const function& f) const {
        return f.numerator().with_square(2 * N + 1, discriminant_lagrange{}(m).numerator()) ==
               typename function::polynomial(0);
    }
};

// At τ the distance is R, so that X̂ is a unit vector; and ⟨Δu,X̂⟩ = -√D/R.
template <int N>
constexpr bool unit_normal() {
    const impact<N> i;
    return i.is_zero(squared_norm(i.normal) - function(1));
}
template <int N>
constexpr bool speed_of_approach() {
    const impact<N> i;
    return i.is_zero(dot(i.m.du, i.normal) * i.m.R + i.S);
}
static_assert(unit_normal<2>() && unit_normal<3>());
static_assert(speed_of_approach<2>() && speed_of_approach<3>());

// The difference at τ, computed from its parts across Δu and along it, is the same as with τ = (-h - √D)/a.
template <int N>
constexpr bool same_by_parts() {
    const impact<N> i;
    const function a = coefficient_a{}(i.m);
    const auto difference = position_at(i.m.dx, i.m.du, (-coefficient_h{}(i.m) - i.S) / a);
    const auto over_a = [&] {
        const auto product = cross(i.m.dx, i.m.du);
        if constexpr (N == 2) {
            return product / a;
        } else {
            return vec<3, function>{{product[0] / a, product[1] / a, product[2] / a}};
        }
    }();
    const auto parts = separation_at_contact(i.m.du, over_a, i.S / a);
    for (int k = 0; k < N; ++k) {
        if (!i.is_zero(parts[k] - difference[k])) {
            return false;
        }
    }
    return true;
}
static_assert(same_by_parts<2>() && same_by_parts<3>());

} // namespace
