// Face, edges and corners of a wall, which section 2.2 of the source lacks, as identities.
#include <graze/formula/contact.hpp>
#include <graze/formula/discriminant.hpp>
#include <graze/formula/wall_encounter.hpp>

#include "../variables.hpp"

namespace {

using namespace graze;
using proof::letter;
using proof::vector;
using letters = polynomial<4096>;
using function = rational_function<4096>;

// w, u, the edges and r as letters: 13 in space.
template <int N, class T = letters>
constexpr auto general() {
    std::array<vec<N, T>, N - 1> e{};
    for (int i = 0; i + 1 < N; ++i) {
        e[static_cast<std::size_t>(i)] = vector<N, T>((2 + i) * N);
    }
    return wall_motion_of(vector<N, T>(0), vector<N, T>(N), e, letter<T>((N + 1) * N));
}
template <class T = letters>
constexpr T t() {
    return letter<T>(15);
}
template <class M>
constexpr letters nn(const M& m) {
    return squared_norm(m.n);
}

// A wall's own coordinates.
static_assert(
    [] {
        const auto m = general<3>();
        const letters zero(0);
        return dot(m.n, m.e[0]) == zero && dot(m.n, m.e[1]) == zero && dot(m.side[0], m.n) == zero &&
               dot(m.side[1], m.n) == zero && dot(m.side[0], m.e[0]) == nn(m) && dot(m.side[0], m.e[1]) == zero &&
               dot(m.side[1], m.e[0]) == zero && dot(m.side[1], m.e[1]) == nn(m);
    }(),
    "w·side_i = λ_i n·n");
static_assert([] {
    const auto m = general<2>();
    return dot(m.n, m.e[0]) == letters(0) && dot(m.side[0], m.e[0]) == nn(m) && dot(m.side[0], m.n) == letters(0) &&
           nn(m) == squared_norm(m.e[0]);
}());
static_assert([] { // Lagrange: n·n is the parallelogram's squared area
    const auto m = general<3>();
    const letters inner = dot(m.e[0], m.e[1]);
    return nn(m) == squared_norm(m.e[0]) * squared_norm(m.e[1]) - inner * inner;
}());

// From a ball and a wall of letters; the face's plane.
static_assert([] {
    const ball<2, letters> b{vector<2, letters>(0), vector<2, letters>(2), letter<letters>(4)};
    const wall<2, letters> w{vector<2, letters>(5), {vector<2, letters>(7)}};
    const auto m = relative_motion_of(b, w);
    const auto f = face_of(m);
    return m.w == b.position - w.corner && m.u == b.velocity && m.e == w.edge && m.r == b.radius && f.w == m.w &&
           f.u == m.u && f.n == m.n && f.r == m.r;
}());

// λ_i against 0 and 1, and how it grows.
template <int N, int I>
constexpr bool heights() {
    const auto m = general<N>();
    const auto later = wall_motion_of(position_at(m.w, m.u, t()), m.u, m.e, m.r);
    return side_height<I, 0>{}(m) == dot(m.w, m.side[I]) && side_height<I, 1>{}(m) == dot(m.w, m.side[I]) - nn(m) &&
           side_height<I, 0>{}(later) == side_height<I, 0>{}(m) + side_speed<I>{}(m)*t() &&
           side_height<I, 1>{}(later) == side_height<I, 1>{}(m) + side_speed<I>{}(m)*t();
}
static_assert(heights<2, 0>() && heights<3, 0>() && heights<3, 1>());

// Seen from another corner and with its edges in another order, the wall is the same. λ_i becomes 1 - λ_i if that
// corner is at its far end.
template <int I, class V, class M>
constexpr bool same_side(const V& v, const M& m, bool far) {
    return far ? side_height<0, 0>{}(v) == -side_height<I, 1>{}(m) && side_height<0, 1>{}(v) == -side_height<I, 0>{}(m)
               : side_height<0, 0>{}(v) == side_height<I, 0>{}(m) && side_height<0, 1>{}(v) == side_height<I, 1>{}(m);
}
static_assert([] {
    const auto m = general<2>();
    const auto near = seen_from(m, {0, false});
    const auto far = seen_from(m, {1, false});
    return near.w == m.w && near.e == m.e && far.w == m.w - m.e[0] && far.e[0] == -m.e[0] && far.u == m.u &&
           far.r == m.r && same_side<0>(near, m, false) && same_side<0>(far, m, true);
}());
constexpr bool view_is_the_same_wall(int corner, bool swapped) {
    const auto m = general<3>();
    const auto v = seen_from(m, {corner, swapped});
    const bool far0 = (corner & 1) != 0;
    const bool far1 = (corner & 2) != 0;
    vec<3, letters> origin = m.w;
    origin = far0 ? origin - m.e[0] : origin;
    origin = far1 ? origin - m.e[1] : origin;
    const vec<3, letters> e0 = far0 ? -m.e[0] : m.e[0];
    const vec<3, letters> e1 = far1 ? -m.e[1] : m.e[1];
    return v.w == origin && v.u == m.u && v.r == m.r && v.e[0] == (swapped ? e1 : e0) && v.e[1] == (swapped ? e0 : e1);
}
static_assert([] {
    for (int corner = 0; corner < 4; ++corner) {
        if (!view_is_the_same_wall(corner, false) || !view_is_the_same_wall(corner, true)) {
            return false;
        }
    }
    return true;
}());
static_assert([] { // edge 2i + far is λ_0 = 0 of its view
    const auto m = general<3>();
    return same_side<0>(seen_from(m, edge_view(0)), m, false) && same_side<0>(seen_from(m, edge_view(1)), m, true) &&
           same_side<1>(seen_from(m, edge_view(2)), m, false) && same_side<1>(seen_from(m, edge_view(3)), m, true);
}());

// The rectangle test: where the ball touches the plane, (λ_i - far) n·n (u·n) = p - σ q√d, for both senses σ of u·n.
template <int N, int I, int Far>
constexpr bool foot() {
    const auto m = general<N>();
    const letters L = letter<letters>(14); // √d = |n|
    const letters speed = dot(m.u, m.n);
    for (const int sense : {1, -1}) {
        // The time, times u·n: when the height is r|n| against the motion's sense.
        const letters time = -(letters(sense) * m.r * L) - dot(m.w, m.n);
        if (side_height<I, Far>{}(m)*speed + side_speed<I>{}(m)*time !=
            face_foot_p<I, Far>{}(m)-letters(sense) * face_foot_q<I>{}(m)*L) {
            return false;
        }
    }
    return face_foot_d{}(m) == nn(m);
}
static_assert(foot<2, 0, 0>() && foot<2, 0, 1>());
static_assert(foot<3, 0, 0>() && foot<3, 0, 1>() && foot<3, 1, 0>() && foot<3, 1, 1>());

// An edge: |(w + u t) × e|² - r² e·e = a t² + 2 h t + c, and its D by Lagrange's identity.
static_assert([] {
    const auto m = general<3>();
    const auto q = edge_quadratic(m);
    const letters ee = squared_norm(m.e[1]);
    return q.a * t() * t() + twice(q.h) * t() + q.c ==
           squared_norm(cross(position_at(m.w, m.u, t()), m.e[1])) - m.r * m.r * ee;
}());
static_assert([] {
    const auto m = general<3>();
    return discriminant_halved{}(edge_quadratic(m)) == edge_discriminant{}(m) &&
           edge_discriminant{}(m) == squared_norm(m.e[1]) * edge_reduced_discriminant{}(m);
}());
static_assert([] {
    const auto m = general<3>();
    const auto later = wall_motion_of(position_at(m.w, m.u, t()), m.u, m.e, m.r);
    return edge_foot<0>{}(m) == dot(m.w, m.e[1]) && edge_foot<1>{}(m) == dot(m.w, m.e[1]) - squared_norm(m.e[1]) &&
           edge_foot<0>{}(later) == edge_foot<0>{}(m) + edge_foot_speed{}(m)*t();
}());

// A corner: |w + u t|² - r².
template <int N>
constexpr bool corner() {
    const auto m = general<N>();
    return corner_formula<coefficient_a>{}(m)*t() * t() + twice(corner_formula<coefficient_h>{}(m)) * t() +
                   corner_formula<coefficient_c>{}(m) ==
               squared_norm(position_at(m.w, m.u, t())) - m.r * m.r &&
           corner_formula<discriminant_lagrange>{}(m) == discriminant_halved{}(quadratic_of(corner_motion(m)));
}
static_assert(corner<2>() && corner<3>());
template <int N, int I>
constexpr bool along_an_edge() {
    const auto m = general<N>();
    const auto later = wall_motion_of(position_at(m.w, m.u, t()), m.u, m.e, m.r);
    return coordinate_along<I>{}(m) == dot(m.w, m.e[I]) &&
           coordinate_along<I>{}(later) == coordinate_along<I>{}(m) + speed_along<I>{}(m)*t();
}
static_assert(along_an_edge<2, 0>() && along_an_edge<3, 0>() && along_an_edge<3, 1>());

// A quantity x + v t at the smaller root (-h - √D)/a, times a: p - v√D.
static_assert([] {
    const auto m = general<2>();
    const letters root = letter<letters>(14);
    using at = value_at_root<corner_formula<coefficient_a>, corner_formula<coefficient_h>, coordinate_along<0>,
                             speed_along<0>>;
    return at{}(m)-speed_along<0>{}(m)*root == coefficient_a{}(corner_motion(m)) * coordinate_along<0>{}(m) +
                                                   speed_along<0>{}(m) * (-coefficient_h{}(corner_motion(m)) - root);
}());

// p² - q²d = (p + q√d)(p - q√d).
static_assert([] {
    const auto m = general<2>();
    const letters root = letter<letters>(14);
    const letters p = face_foot_p<0, 1>{}(m);
    const letters q = face_foot_q<0>{}(m);
    const letters norm = root_norm<face_foot_p<0, 1>, face_foot_q<0>, face_foot_d>{}(m);
    return ((p + q * root) * (p - q * root)).with_square(14, nn(m)) == norm;
}());

} // namespace
