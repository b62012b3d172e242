// Eqs. (14) to (29): momentum and energy before and after, as identities. X̂ is any vector n; where |n|² = 1 is needed,
// a factor |n|² - 1 remains. formula/contact.cpp proves that it is 0 for X̂.
#include <graze/formula/impulse.hpp>

#include "../variables.hpp"

namespace {

using namespace graze;
using proof::letter;
using proof::vector;
using function = rational_function<1024>;

template <int N>
struct impact {
    vec<N, function> u_a = vector<N, function>(0);
    vec<N, function> u_b = vector<N, function>(N);
    vec<N, function> n = vector<N, function>(2 * N);
    function w_a = letter<function>(3 * N); // inverse masses
    function w_b = letter<function>(3 * N + 1);
    function mu = reduced_mass(w_a, w_b);
    function alpha = impulse(mu, n, u_a - u_b);
    vec<N, function> v_a = velocity_after(u_a, alpha, w_a, n);
    vec<N, function> v_b = velocity_after(u_b, -alpha, w_b, n);
    function excess = squared_norm(n) - function(1);
};

// (14), (15): momentum, identically; each ball's times both inverse masses.
template <int N>
constexpr bool momentum() {
    const impact<N> i;
    return i.w_b * (i.u_a - i.v_a) == -(i.w_a * (i.u_b - i.v_b));
}

// (16), (17): energy, up to |n|² - 1.
template <int N>
constexpr bool energy() {
    const impact<N> i;
    const function along = dot(i.n, i.u_a - i.u_b);
    const function gain =
        i.w_b * (squared_norm(i.v_a) - squared_norm(i.u_a)) + i.w_a * (squared_norm(i.v_b) - squared_norm(i.u_b));
    return gain == function(4) * i.mu * along * along * i.excess * i.w_a * i.w_b;
}

// (18), with the sign that follows from (17): the same, factored. (22): along n, the sums of the velocities before and
// after are equal for both balls. So the balls part as fast as they approached.
template <int N>
constexpr bool along_the_normal() {
    const impact<N> i;
    const function along = dot(i.n, i.u_a - i.u_b);
    return dot(i.n, i.u_a + i.v_a) - dot(i.n, i.u_b + i.v_b) == -twice(along) * i.excess &&
           dot(i.n, i.v_a - i.v_b) == -along - twice(along) * i.excess;
}

// (21): momentum changes along n only, by α.
template <int N>
constexpr bool change_is_along_the_normal() {
    const impact<N> i;
    return i.u_a - i.v_a == (i.alpha * i.w_a) * i.n;
}

// (25), (28): α (1/m_a + 1/m_b) = 2 n·Δu, and μ = m_a m_b/(m_a + m_b).
template <int N>
constexpr bool impulse_by_masses() {
    const impact<N> i;
    const function one(1);
    const function m_a = one / i.w_a;
    const function m_b = one / i.w_b;
    return i.alpha * (i.w_a + i.w_b) == twice(dot(i.n, i.u_a - i.u_b)) && i.mu == m_a * m_b / (m_a + m_b);
}

// (23) with (29), the end of the calculation: v_a = u_a - 2 m_b/(m_a + m_b) ⟨Δu,n⟩ n, and likewise v_b.
template <int N>
constexpr bool completed() {
    const impact<N> i;
    const function one(1);
    const function m_a = one / i.w_a;
    const function m_b = one / i.w_b;
    const function along = twice(dot(i.u_a - i.u_b, i.n)) / (m_a + m_b);
    return i.v_a == i.u_a - (m_b * along) * i.n && i.v_b == i.u_b + (m_a * along) * i.n;
}

// The normal's direction does not matter. An infinite mass does not move; to the other ball it is a wall.
template <int N>
constexpr bool senses_and_walls() {
    const impact<N> i;
    const function alpha = impulse(i.mu, -i.n, i.u_a - i.u_b);
    const function zero(0);
    const function against_rest = impulse(reduced_mass(i.w_a, zero), i.n, i.u_a);
    return velocity_after(i.u_a, alpha, i.w_a, -i.n) == i.v_a && velocity_after(i.u_b, -alpha, zero, i.n) == i.u_b &&
           velocity_after(i.u_a, against_rest, i.w_a, i.n) == reflected(i.u_a, i.n);
}

template <int N>
constexpr bool impacts() {
    static_assert(momentum<N>());
    static_assert(energy<N>());
    static_assert(along_the_normal<N>());
    static_assert(change_is_along_the_normal<N>());
    static_assert(impulse_by_masses<N>());
    static_assert(completed<N>());
    static_assert(senses_and_walls<N>());
    return true;
}
static_assert(impacts<2>() && impacts<3>());

// Reflection: speed is conserved, with a normal of any length identically, with a unit normal up to |n|² - 1.
template <int N>
constexpr bool reflection() {
    const vec<N, function> u = vector<N, function>(0);
    const vec<N, function> n = vector<N, function>(N);
    const function along = dot(u, n);
    const function excess = squared_norm(n) - function(1);
    const auto v = reflected_unnormalised(u, n);
    const auto by_unit = reflected(u, n);
    return squared_norm(v) == squared_norm(u) && dot(v, n) == -along && cross(v, n) == cross(u, n) &&
           reflected_unnormalised(v, n) == u &&
           squared_norm(by_unit) - squared_norm(u) == function(4) * along * along * excess &&
           cross(by_unit, n) == cross(u, n) && dot(by_unit, n) == -along - twice(along) * excess;
}
static_assert(reflection<2>() && reflection<3>());

} // namespace
