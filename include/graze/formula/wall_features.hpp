// A ball against a wall's face, edges and corners as numbers from which times and contacts follow, without a division.
//
// The wall is the set corner + Σ λ_i e_i with 0 <= λ_i <= 1, and w = x - corner.
#pragma once

#include <graze/formula/plane_crossing.hpp>
#include <graze/formula/wall_encounter.hpp>
#include <graze/shape/triangle.hpp>
#include <graze/shape/wall.hpp>

namespace graze::inline v0_1 {

// A ball seen from a wall or a triangle.
template <int N, class X, class U, class E, class S>
struct wall_motion {
    vec<N, X> w;
    vec<N, U> u;
    std::array<vec<N, E>, N - 1> e;
    S r;
};

// Perpendicular to the wall: e₀ × e₁ in space, the edge turned by 90° in the plane.
template <int N, class E, std::size_t Edges>
[[nodiscard]] constexpr auto face_normal(const std::array<vec<N, E>, Edges>& e) {
    if constexpr (N == 2) {
        return vec<2, E>{{E(-e[0][1]), E(e[0][0])}};
    } else {
        return graze::cross(e[0], e[1]);
    }
}

template <int N, class X, class U, class E, class S>
[[nodiscard]] constexpr auto wall_motion_of(const vec<N, X>& w, const vec<N, U>& u,
                                            const std::array<vec<N, E>, N - 1>& e, const S& r) {
    return wall_motion<N, X, U, E, S>{w, u, e, r};
}

template <int N, class T>
[[nodiscard]] constexpr auto relative_motion_of(const ball<N, T>& b, const wall<N, T>& w) {
    return wall_motion_of(b.position - w.corner, b.velocity, w.edge, b.radius);
}
template <class T>
[[nodiscard]] constexpr auto relative_motion_of(const ball<3, T>& b, const triangle<T>& t) {
    return wall_motion_of<3>(b.position - t.corner, b.velocity, t.edge, b.radius);
}

// The plane in which it lies.
template <int N, class X, class U, class E, class S>
[[nodiscard]] constexpr auto face_of(const wall_motion<N, X, U, E, S>& m) {
    return plane_motion{m.w, m.u, face_normal(m.e), m.r};
}

// A wall seen from its corner number `corner` (λ_0 + 2 λ_1): that corner is the origin, and the edges run from it along
// the wall, exchanged if `swapped`. So every edge is the edge λ_0 = 0, which runs along e[1], of some view, and every
// corner the corner 0 of some view. slanted: seen from corner 1, the second edge leads to corner 2.
struct wall_view {
    int corner = 0;
    bool swapped = false;
    bool slanted = false;
};
// An edge's number among those of a wall and a triangle: the triangle's slanted edge is number 4.
inline constexpr int slanted_edge = 4;
[[nodiscard]] constexpr int edge_number(int index, bool is_triangle) noexcept {
    return is_triangle && index == 1 ? slanted_edge : index;
}
[[nodiscard]] constexpr int feature_number(feature where, int index, bool is_triangle) noexcept {
    return where == feature::edge ? edge_number(index, is_triangle) : index;
}
// The view in which this edge is the edge λ_0 = 0.
[[nodiscard]] constexpr wall_view edge_view(int number) noexcept {
    return number == slanted_edge ? wall_view{1, false, true}
           : number < 2           ? wall_view{number, false}
                                  : wall_view{(number - 2) << 1, true};
}

// The view's edges, from those of the wall.
template <int N, class E, std::size_t Edges>
[[nodiscard]] constexpr auto edges_seen_from(const std::array<vec<N, E>, Edges>& e, wall_view view) {
    const auto edge = [&](int i) {
        const vec<N, E>& vector = e[static_cast<std::size_t>(i)];
        const bool far = (view.corner >> i & 1) != 0;
        return make_vec<N>([&](int k) { return far ? E(-vector[k]) : vector[k]; });
    };
    if constexpr (N == 2) {
        return std::array<vec<2, E>, 1>{edge(0)};
    } else {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(e[1][0] - e[0][0])>, E>) {
            if (view.slanted) {
                return std::array<vec<3, E>, 2>{edge(0), e[1] - e[0]};
            }
        }
        return view.swapped ? std::array<vec<3, E>, 2>{edge(1), edge(0)} : std::array<vec<3, E>, 2>{edge(0), edge(1)};
    }
}

// The centre seen from the view's corner: w less the edges that lead to that corner.
template <int N, class X, class E, std::size_t Edges>
[[nodiscard]] constexpr auto centre_seen_from(const vec<N, X>& w, const std::array<vec<N, E>, Edges>& e,
                                              wall_view view) {
    const auto offset = [&](int i) {
        const vec<N, E>& vector = e[static_cast<std::size_t>(i)];
        const bool far = (view.corner >> i & 1) != 0;
        return make_vec<N>([&](int k) { return far ? vector[k] : E(0); });
    };
    if constexpr (N == 2) {
        return w - offset(0);
    } else {
        return w - offset(0) - offset(1);
    }
}

template <int N, class X, class U, class E, class S>
[[nodiscard]] constexpr auto seen_from(const wall_motion<N, X, U, E, S>& m, wall_view view) {
    return wall_motion_of(centre_seen_from(m.w, m.e, view), m.u, edges_seen_from(m.e, view), m.r);
}

// The ball against the infinite line along the view's edge e = e[1], in space. Distances across the line are |· × e| /
// |e|. Multiplied by e·e, the coefficients are a = |u × e|², h = ⟨w × e, u × e⟩, c = |w × e|² - r² e·e.
struct edge_a {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return graze::squared_norm(graze::cross(m.u, m.e[1]));
    }
};
struct edge_h {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return graze::dot(graze::cross(m.w, m.e[1]), graze::cross(m.u, m.e[1]));
    }
};
struct edge_c {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return graze::squared_norm(graze::cross(m.w, m.e[1])) - m.r * m.r * graze::squared_norm(m.e[1]);
    }
};
// D/(e·e) by Lagrange's identity: (w × e) × (u × e) is parallel to e, so that D = e·e (r² a - (e·(w × u))²).
struct edge_reduced_discriminant {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        const auto triple = graze::dot(m.e[1], graze::cross(m.w, m.u));
        return m.r * m.r * edge_a{}(m)-triple * triple;
    }
};
struct edge_discriminant {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return graze::squared_norm(m.e[1]) * edge_reduced_discriminant{}(m);
    }
};

template <class M>
[[nodiscard]] constexpr auto edge_quadratic(const M& m) {
    return quadratic{edge_a{}(m), edge_h{}(m), edge_c{}(m)};
}

// The position of the centre's foot along the edge at t = 0: w·e - end e·e.
template <int End>
struct edge_foot {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        if constexpr (End == 0) {
            return graze::dot(m.w, m.e[1]);
        } else {
            return graze::dot(m.w, m.e[1]) - graze::squared_norm(m.e[1]);
        }
    }
};
struct edge_foot_speed {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return graze::dot(m.u, m.e[1]);
    }
};

// The ball against the view's corner, as a ball of radius 0 at rest.
template <class M>
[[nodiscard]] constexpr auto corner_motion(const M& m) {
    return relative_motion{m.w, m.u, m.r};
}
// A quantity x + v t at the smaller root of a t² + 2 h t + c is (p - v√D)/a, with this p.
template <class A, class H, class X, class V>
struct value_at_root {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return A{}(m)*X{}(m)-H{}(m)*V{}(m);
    }
};

} // namespace graze::inline v0_1
