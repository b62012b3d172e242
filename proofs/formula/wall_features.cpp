// Face, edges and corners of a wall, which section 2.2 of the source lacks, as identities.
#include <graze/formula/contact.hpp>
#include <graze/formula/discriminant.hpp>
#include <graze/formula/wall_features.hpp>

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

// Lagrange: n·n is the parallelogram's squared area.
static_assert([] {
    const auto m = general<3>();
    const auto n = face_normal(m.e);
    const letters inner = dot(m.e[0], m.e[1]);
    return squared_norm(n) == squared_norm(m.e[0]) * squared_norm(m.e[1]) - inner * inner;
}());

// From a ball and a wall of letters; the face's plane.
static_assert([] {
    const ball<2, letters> b{vector<2, letters>(0), vector<2, letters>(2), letter<letters>(4)};
    const wall<2, letters> w{vector<2, letters>(5), {vector<2, letters>(7)}};
    const auto m = relative_motion_of(b, w);
    const auto f = face_of(m);
    return m.w == b.position - w.corner && m.u == b.velocity && m.e == w.edge && m.r == b.radius && f.w == m.w &&
           f.u == m.u && f.n == face_normal(m.e) && f.r == m.r;
}());

// Seen from another corner and with its edges in another order, the wall is the same.
static_assert([] {
    const auto m = general<2>();
    const auto near = seen_from(m, {0, false});
    const auto far = seen_from(m, {1, false});
    return near.w == m.w && near.e == m.e && far.w == m.w - m.e[0] && far.e[0] == -m.e[0] && far.u == m.u &&
           far.r == m.r;
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
static_assert(
    [] { // edge 2i + far, at λ_i = far, runs along the other edge, and the wall lies along the first of its view
        const auto m = general<3>();
        const auto is = [&](int index, const vec<3, letters>& start, const vec<3, letters>& e,
                            const vec<3, letters>& into) {
            const auto v = seen_from(m, edge_view(index));
            return v.w == m.w - start && (v.e[1] == e || v.e[1] == -e) && v.e[0] == into;
        };
        const vec<3, letters> none = m.w - m.w;
        return is(0, none, m.e[1], m.e[0]) && is(1, m.e[0], m.e[1], -m.e[0]) && is(2, none, m.e[0], m.e[1]) &&
               is(3, m.e[1], m.e[0], -m.e[1]) && is(slanted_edge, m.e[0], m.e[1] - m.e[0], -m.e[0]);
    }());

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
    const auto q = quadratic_of(corner_motion(m));
    return q.a * t() * t() + twice(q.h) * t() + q.c == squared_norm(position_at(m.w, m.u, t())) - m.r * m.r;
}
static_assert(corner<2>() && corner<3>());
// A quantity x + v t at the smaller root (-h - √D)/a, times a: p - v√D.
static_assert([] {
    const auto m = general<3>();
    const letters root = letter<letters>(14);
    using at = value_at_root<edge_a, edge_h, edge_foot<0>, edge_foot_speed>;
    return at{}(m)-edge_foot_speed{}(m)*root ==
           edge_a{}(m)*edge_foot<0>{}(m) + edge_foot_speed{}(m) * (-edge_h{}(m)-root);
}());

} // namespace
