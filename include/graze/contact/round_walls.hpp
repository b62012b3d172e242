// All components of a ball's contact with a plane or a wall, from its motion in integers.
#pragma once

#include <graze/contact/components.hpp>
#include <graze/contact/contact.hpp>
#include <graze/contact/exact_walls.hpp>
#include <graze/formula/encounter.hpp>

namespace graze::inline v0_1::detail {

// 1 and 2 as integers of the kind of I.
template <template <int> class Integer, int Bits>
[[nodiscard]] constexpr Integer<1> one_like(const Integer<Bits>&) noexcept {
    return Integer<1>(1);
}
template <template <int> class Integer, int Bits>
[[nodiscard]] constexpr Integer<2> two_like(const Integer<Bits>&) noexcept {
    return Integer<2>(2);
}

[[nodiscard]] constexpr big_integer one_like(const big_integer&) noexcept { return 1; }
[[nodiscard]] constexpr big_integer two_like(const big_integer&) noexcept { return 2; }

template <int N, class T, class M, class I>
constexpr void round_face(wall_contact<N, T>& c, component_set wanted, encounter what, const M& m, const vec<N, I>& x,
                          scales units) {
    const bool inside = what == encounter::overlap;
    const exact_plane<T, N, M, I> exact(m, x, inside, units);
    if (!inside) {
        if (has_time(wanted)) {
            c.time = exact.time();
        }
        fill(c.position, wanted, wall_component::position, units.room, [&](int i) { return exact.position(i); });
    }
    fill(c.point, wanted, wall_component::point, units.room, [&](int i) { return exact.point(i); });
    fill(c.normal, wanted, wall_component::normal, units.room, [&](int i) { return exact.normal(i); });
    fill(c.velocity, wanted, wall_component::velocity, units.room, [&](int i) { return exact.velocity(i); });
}

// Normal and velocity of a ball that overlaps an edge or a corner, from which `apart` points to its centre.
template <int N, class T, class X, class U, class S>
constexpr void round_overlap(wall_contact<N, T>& c, component_set wanted, const vec<N, X>& apart, const vec<N, U>& u,
                             const S& r, scales units) {
    const relative_motion m{apart, u, r};
    const exact_overlap<T, std::remove_cvref_t<decltype(m)>> exact(m, units);
    fill(c.normal, wanted, wall_component::normal, units.room, [&](int i) { return exact.normal(i); });
    const auto divisor = exact.velocity_divisor(one_like(r));
    fill(c.velocity, wanted, wall_component::velocity, units.room,
         [&](int i) { return exact.velocity(u[i], i, two_like(r), divisor); });
}

// m: seen from the view in which the edge is the edge λ_0 = 0.
template <class T, class M, class I>
constexpr void round_edge(wall_contact<3, T>& c, component_set wanted, encounter what, const M& m, const vec<3, I>& x,
                          scales units) {
    const auto corner = x - m.w;
    if (what == encounter::overlap) {
        const auto square = graze::squared_norm(m.e[1]);
        using Z = root_sum_integer_for<M>;
        fill(c.point, wanted, wall_component::point, units.room, [&](int i) {
            return round_to<T>(square * corner[i] + edge_foot<0>{}(m)*m.e[1][i], Z(0), radicand<Z>(), square,
                               units.length);
        });
        round_overlap(c, wanted, graze::cross(m.e[1], graze::cross(m.w, m.e[1])), m.u, m.r, units);
        return;
    }
    const exact_edge<T, M> exact(m, units);
    if (has_time(wanted)) {
        c.time = exact.path.time();
    }
    fill(c.position, wanted, wall_component::position, units.room,
         [&](int i) { return exact.path.position(x[i], m.u[i]); });
    fill(c.point, wanted, wall_component::point, units.room, [&](int i) { return exact.point(corner[i], i); });
    if (graze::sign(m.r) != 0) {
        fill(c.normal, wanted, wall_component::normal, units.room, [&](int i) { return exact.normal(i); });
    }
    if (what == encounter::hit) {
        fill(c.velocity, wanted, wall_component::velocity, units.room, [&](int i) { return exact.velocity(i); });
    }
}

// m: seen from the corner.
template <int N, class T, class M, class I>
constexpr void round_corner(wall_contact<N, T>& c, component_set wanted, encounter what, const M& m, const vec<N, I>& x,
                            scales units) {
    using Z = root_sum_integer_for<M>;
    fill(c.point, wanted, wall_component::point, units.room,
         [&](int i) { return round_to<T>(x[i] - m.w[i], Z(0), radicand<Z>(), Z(1), units.length); });
    if (what == encounter::overlap) {
        round_overlap(c, wanted, m.w, m.u, m.r, units);
        return;
    }
    const auto relative = corner_motion(m);
    const exact_contact<T, std::remove_cvref_t<decltype(relative)>> exact(relative, units);
    if (has_time(wanted)) {
        c.time = exact.time();
    }
    fill(c.position, wanted, wall_component::position, units.room,
         [&](int i) { return exact.path.position(x[i], m.u[i]); });
    if (graze::sign(m.r) != 0) {
        fill(c.normal, wanted, wall_component::normal, units.room, [&](int i) { return exact.normal(i); });
    }
    if (what == encounter::hit) {
        const auto divisor = exact.velocity_divisor(one_like(m.r));
        fill(c.velocity, wanted, wall_component::velocity, units.room,
             [&](int i) { return exact.velocity(m.u[i], i, two_like(m.r), divisor); });
    }
}

} // namespace graze::inline v0_1::detail
