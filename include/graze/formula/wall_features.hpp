// A ball against a wall's face, edges and corners: the rectangle test and the rest that section 2.2 of the source
// lacks.
//
// The wall is the set corner + Σ λ_i e_i with 0 <= λ_i <= 1. All tests are signs of numbers p + q√d that are formulas
// in w = x - corner, u, e and r, without a division.
#pragma once

#include <graze/formula/plane_crossing.hpp>
#include <graze/number/sqrt_extension.hpp>
#include <graze/shape/wall.hpp>

namespace graze {

// A ball seen from a wall. n is perpendicular to the wall: e₀ × e₁ in space, the edge turned by 90° in the plane.
// side[i] is the direction in the wall along which only λ_i grows, scaled so that λ_i = w·side[i] / n·n.
template <int N, class X, class U, class E, class S, class NN, class M>
struct wall_motion {
    vec<N, X> w;
    vec<N, U> u;
    std::array<vec<N, E>, N - 1> e;
    S r;
    vec<N, NN> n;
    std::array<vec<N, M>, N - 1> side;
};

template <int N, class X, class U, class E, class S>
[[nodiscard]] constexpr auto wall_motion_of(const vec<N, X>& w, const vec<N, U>& u,
                                            const std::array<vec<N, E>, N - 1>& e, const S& r) {
    if constexpr (N == 2) {
        const vec<2, E> n{{E(-e[0][1]), E(e[0][0])}};
        return wall_motion<2, X, U, E, S, E, E>{w, u, e, r, n, {e[0]}};
    } else {
        const auto n = cross(e[0], e[1]);
        const auto side0 = cross(e[1], n);
        const auto side1 = cross(n, e[0]);
        using NN = std::remove_cvref_t<decltype(n[0])>;
        using M = std::remove_cvref_t<decltype(side0[0])>;
        return wall_motion<3, X, U, E, S, NN, M>{w, u, e, r, n, {side0, side1}};
    }
}

template <int N, class T>
[[nodiscard]] constexpr auto relative_motion_of(const ball<N, T>& b, const wall<N, T>& w) {
    return wall_motion_of(b.position - w.corner, b.velocity, w.edge, b.radius);
}

// The plane in which the wall lies.
template <int N, class X, class U, class E, class S, class NN, class M>
[[nodiscard]] constexpr auto face_of(const wall_motion<N, X, U, E, S, NN, M>& m) {
    return plane_motion<N, X, U, NN, S>{m.w, m.u, m.n, m.r};
}

// w·side_i - far n·n: negative where λ_i < far (far is 0 or 1).
template <int I, int Far>
struct side_height {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        if constexpr (Far == 0) {
            return dot(m.w, m.side[I]);
        } else {
            return dot(m.w, m.side[I]) - squared_norm(m.n);
        }
    }
};

// u·side_i: how fast λ_i grows, times n·n.
template <int I>
struct side_speed {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return dot(m.u, m.side[I]);
    }
};

// The rectangle test at the time t at which the ball touches the face's plane: (λ_i(t) - far) n·n (u·n) is p - σ q√d
// with these, σ the sign of u·n.
template <int I, int Far>
struct face_foot_p {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return plane_speed{}(m)*side_height<I, Far>{}(m)-plane_height{}(m)*dot(m.u, m.side[I]);
    }
};
template <int I>
struct face_foot_q {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return m.r * dot(m.u, m.side[I]);
    }
};
struct face_foot_d {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return squared_norm(m.n);
    }
};

// The ball seen from the edge λ_i = far, which runs along e = the other edge vector: w from the edge's first end. Only
// in space.
template <int I, int Far>
struct edge_view {
    template <class M>
    [[nodiscard]] constexpr const auto& direction(const M& m) const {
        return m.e[1 - I];
    }
    template <class M>
    [[nodiscard]] constexpr auto offset(const M& m) const {
        if constexpr (Far == 0) {
            return m.w;
        } else {
            return m.w - m.e[I];
        }
    }
};

// The ball against an infinite straight line: distances across it are |· × e| / |e|, so that with everything times e·e
// a = |u × e|², h = ⟨w × e, u × e⟩, c = |w × e|² - r² e·e.
template <int I, int Far>
struct edge_a : edge_view<I, Far> {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return squared_norm(cross(m.u, this->direction(m)));
    }
};
template <int I, int Far>
struct edge_h : edge_view<I, Far> {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        const auto& e = this->direction(m);
        return dot(cross(this->offset(m), e), cross(m.u, e));
    }
};
template <int I, int Far>
struct edge_c : edge_view<I, Far> {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        const auto& e = this->direction(m);
        return squared_norm(cross(this->offset(m), e)) - m.r * m.r * squared_norm(e);
    }
};
// D/(e·e) by Lagrange's identity: (w × e) × (u × e) is parallel to e, so that D = e·e (r² a - (e·(w × u))²).
template <int I, int Far>
struct edge_reduced_discriminant : edge_view<I, Far> {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        const auto triple = dot(this->direction(m), cross(this->offset(m), m.u));
        return m.r * m.r * edge_a<I, Far>{}(m)-triple * triple;
    }
};
template <int I, int Far>
struct edge_discriminant : edge_view<I, Far> {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return squared_norm(this->direction(m)) * edge_reduced_discriminant<I, Far>{}(m);
    }
};

template <int I, int Far, class M>
[[nodiscard]] constexpr auto edge_quadratic(const M& m) {
    return quadratic{edge_a<I, Far>{}(m), edge_h<I, Far>{}(m), edge_c<I, Far>{}(m)};
}

// Where along the edge the centre's foot is at t = 0: w·e - end e·e.
template <int I, int Far, int End>
struct edge_foot_now : edge_view<I, Far> {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        const auto& e = this->direction(m);
        if constexpr (End == 0) {
            return dot(this->offset(m), e);
        } else {
            return dot(this->offset(m), e) - squared_norm(e);
        }
    }
};
// The same when the ball touches the edge's line: p - q√D over a, with D = edge_discriminant.
template <int I, int Far, int End>
struct edge_foot_p : edge_view<I, Far> {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return edge_a<I, Far>{}(m)*edge_foot_now<I, Far, End>{}(m)-edge_h<I, Far>{}(m)*dot(m.u, this->direction(m));
    }
};
template <int I, int Far>
struct edge_foot_q : edge_view<I, Far> {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return dot(m.u, this->direction(m));
    }
};
// On which side of the edge, in the wall's plane, the centre is then: (λ_i - far) n·n a is p - q√D.
template <int I, int Far>
struct edge_side_p : edge_view<I, Far> {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return edge_a<I, Far>{}(m)*side_height<I, Far>{}(m)-edge_h<I, Far>{}(m)*dot(m.u, m.side[I]);
    }
};
template <int I, int Far>
struct edge_side_q : edge_view<I, Far> {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return dot(m.u, m.side[I]);
    }
};

// The corner at λ_0 = K & 1, λ_1 = K >> 1, as a ball of radius 0 at rest.
template <int K>
struct corner_view {
    template <class M>
    [[nodiscard]] constexpr auto motion(const M& m) const {
        if constexpr (K == 0) {
            return relative_motion{m.w, m.u, m.r};
        } else if constexpr (K == 1) {
            return relative_motion{m.w - m.e[0], m.u, m.r};
        } else if constexpr (K == 2) {
            return relative_motion{m.w - m.e[1], m.u, m.r};
        } else {
            return relative_motion{m.w - m.e[0] - m.e[1], m.u, m.r};
        }
    }
};
// F applied to that ball and corner: coefficient_a, coefficient_h, coefficient_c, discriminant_lagrange.
template <int K, class F>
struct corner_formula : corner_view<K> {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return F{}(this->motion(m));
    }
};
// Along edge vector i from the corner, at t = 0 and at the touch (p - q√D over a).
template <int K, int I>
struct corner_along_now : corner_view<K> {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return dot(this->motion(m).dx, m.e[I]);
    }
};
template <int K, int I>
struct corner_along_p : corner_view<K> {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        const auto corner = this->motion(m);
        return coefficient_a{}(corner)*dot(corner.dx, m.e[I]) - coefficient_h{}(corner)*dot(m.u, m.e[I]);
    }
};
template <int I>
struct corner_along_q {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return dot(m.u, m.e[I]);
    }
};

} // namespace graze
