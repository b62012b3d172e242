// The encounter of a ball with a ball, a plane, a wall or a triangle, in exact arithmetic, by another method than the
// library's.
//
// The squared distance between a moving centre and a thing is the least of a few parabolas, each of which holds over an
// interval of time: one for a ball, one for a wall's face, and one for each of its edges and corners. Their minima over
// these intervals, and the roots of those that reach r², are all that is needed.
#pragma once

#include "lift.hpp"
#include "piece.hpp"
#include "surd.hpp"

#include <graze/shape/ball.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/triangle.hpp>
#include <graze/shape/wall.hpp>

#include <optional>
#include <stdexcept>

namespace oracle {

enum class encounter { overlap, recede, miss, graze, hit }; // in the library's order

inline bool is_collision(encounter e) { return e != encounter::recede && e != encounter::miss; }

struct answer {
    encounter what = encounter::recede;
    bool overlaps = false;    // nearer than at the contact now, whatever follows
    std::optional<surd> time; // of a collision, in the inputs' unit
    // For walls: the features that are met at that time or, for a recede or an overlap, closest now.
    bool face = false;
    unsigned edges = 0, corners = 0; // bit i: edge or corner i
    std::vector<piece> pieces;

    const piece& piece_of(feature f, int index) const {
        return *std::ranges::find_if(pieces, [&](const piece& p) { return p.where == f && p.index == index; });
    }

    bool has(feature f, int index) const {
        return f == feature::face ? face : ((f == feature::edge ? edges : corners) >> index & 1) != 0;
    }
    // The feature that counts if several are met.
    feature where() const { return face ? feature::face : edges != 0 ? feature::edge : feature::corner; }
    void add(const piece& p) {
        face = face || p.where == feature::face;
        edges |= p.where == feature::edge ? 1u << p.index : 0;
        corners |= p.where == feature::corner ? 1u << p.index : 0;
    }
};

// pieces: all of the thing. is_point: r = 0. crosses: the centre moves towards or from the plane of the face.
inline answer encounter_of(std::vector<piece> all, bool is_point, bool crosses, const mpq_class& unit) {
    answer found;
    found.pieces = std::move(all);
    const std::vector<piece>& pieces = found.pieces;
    const piece* closest = nullptr;
    for (const piece& p : pieces) {
        if (p.holds_now() && (closest == nullptr || p.c * closest->k < closest->c * p.k)) {
            closest = &p;
        }
    }
    if (closest == nullptr) {
        throw std::logic_error("oracle: no piece holds now");
    }
    found.overlaps = closest->c < 0;
    if (closest->h >= 0 || found.overlaps) {
        found.what = closest->h >= 0 ? encounter::recede : encounter::overlap;
        for (const piece& p : pieces) {
            if (p.holds_now() && p.c * closest->k == closest->c * p.k) {
                found.add(p);
            }
        }
        if (found.what == encounter::overlap) {
            found.time = surd{};
        }
        return found;
    }
    int least = 1;
    for (const piece& p : pieces) {
        least = std::min(least, p.sign_of_minimum());
    }
    const bool lands = is_point && crosses && least == 0;
    found.what = least > 0 ? encounter::miss : least == 0 && !lands ? encounter::graze : encounter::hit;
    if (least > 0) {
        return found;
    }
    for (const piece& p : pieces) {
        if (p.sign_of_minimum() <= 0) {
            const std::optional<surd> own = p.root();
            const surd t = own ? *own : rational(p.low.value());
            if (!found.time || compare(t, *found.time) < 0) {
                found.time = t;
            }
        }
    }
    for (const piece& p : pieces) {
        const std::optional<surd> own = p.root();
        if (own && compare(*own, *found.time) == 0) {
            found.add(p);
        }
    }
    if (!found.face && found.edges == 0 && found.corners == 0) {
        throw std::logic_error("oracle: the first touch is on no feature");
    }
    found.time->p *= unit.get_num();
    found.time->q *= unit.get_num();
    found.time->r *= unit.get_den();
    return found;
}

inline mpz_class determinant(const point<2>& x, const point<2>& y) { return x[0] * y[1] - x[1] * y[0]; }
inline mpz_class determinant(const point<3>& x, const point<3>& y, const point<3>& z) {
    return x[0] * (y[1] * z[2] - y[2] * z[1]) - x[1] * (y[0] * z[2] - y[2] * z[0]) + x[2] * (y[0] * z[1] - y[1] * z[0]);
}

template <int N, class T>
answer meet(const graze::ball<N, T>& a, const graze::ball<N, T>& b) {
    groups<T> g;
    collect<N>(g.lengths, a.position);
    collect<N>(g.lengths, b.position);
    g.lengths.collect(input(a.radius));
    g.lengths.collect(input(b.radius));
    collect<N>(g.velocities, a.velocity);
    collect<N>(g.velocities, b.velocity);
    const point<N> xa = next<N>(g.lengths);
    const point<N> xb = next<N>(g.lengths);
    const mpz_class ra = g.lengths.next();
    const mpz_class rb = g.lengths.next();
    const point<N> ua = next<N>(g.velocities);
    const point<N> ub = next<N>(g.velocities);
    return encounter_of({corner_piece<N>(xa - xb, ua - ub, mpz_class(ra + rb), 0)}, false, false, g.time());
}

template <int N, class T>
answer meet(const graze::ball<N, T>& b, const graze::plane<N, T>& p) {
    groups<T> g;
    group<input_type<T>> normal; // its length does not matter
    collect<N>(g.lengths, b.position);
    collect<N>(g.lengths, p.point);
    g.lengths.collect(input(b.radius));
    collect<N>(g.velocities, b.velocity);
    collect<N>(normal, p.normal);
    const point<N> x = next<N>(g.lengths);
    const point<N> from = next<N>(g.lengths);
    const mpz_class r = g.lengths.next();
    const point<N> u = next<N>(g.velocities);
    const point<N> n = next<N>(normal);
    const mpz_class height = dot<N>(x - from, n);
    const mpz_class speed = dot<N>(u, n);
    return encounter_of({plane_piece(height, speed, dot<N>(n, n), r)}, r == 0, speed != 0, g.time());
}

// A ball relative to the corner of a wall or a triangle.
template <int N>
struct seen_from_corner {
    point<N> w, u;
    mpz_class r;
    std::array<point<N>, N - 1> e;
    mpq_class unit;
};
template <int N, class T, class Shape>
seen_from_corner<N> seen(const graze::ball<N, T>& b, const Shape& shape) {
    groups<T> g;
    collect<N>(g.lengths, b.position);
    collect<N>(g.lengths, shape.corner);
    g.lengths.collect(input(b.radius));
    for (const auto& e : shape.edge) {
        collect<N>(g.lengths, e);
    }
    collect<N>(g.velocities, b.velocity);
    seen_from_corner<N> s;
    const point<N> x = next<N>(g.lengths);
    s.w = x - next<N>(g.lengths);
    s.r = g.lengths.next();
    for (auto& edge : s.e) {
        edge = next<N>(g.lengths);
    }
    s.u = next<N>(g.velocities);
    s.unit = g.time();
    return s;
}

// The face of a wall or a triangle in space; in a triangle, λ_0 + λ_1 ends at 1, too. λ_i by Gram's determinants.
inline piece face_piece(const seen_from_corner<3>& s, bool is_triangle) {
    const auto& e = s.e;
    const mpz_class e00 = dot<3>(e[0], e[0]), e01 = dot<3>(e[0], e[1]), e11 = dot<3>(e[1], e[1]);
    const mpz_class gram = e00 * e11 - e01 * e01;
    const auto along0 = [&](const point<3>& v) { return mpz_class(dot<3>(v, e[0]) * e11 - dot<3>(v, e[1]) * e01); };
    const auto along1 = [&](const point<3>& v) { return mpz_class(dot<3>(v, e[1]) * e00 - dot<3>(v, e[0]) * e01); };
    piece face = plane_piece(determinant(s.w, e[0], e[1]), determinant(s.u, e[0], e[1]), gram, s.r);
    face.only_within(along0(s.w), along0(s.u), gram);
    face.only_within(along1(s.w), along1(s.u), gram);
    if (is_triangle) {
        face.only_within(along0(s.w) + along1(s.w), along0(s.u) + along1(s.u), gram);
    }
    return face;
}

template <int N, class T>
answer meet(const graze::ball<N, T>& b, const graze::wall<N, T>& wall) {
    const auto s = seen(b, wall);
    const auto& [w, u, r, e, unit] = s;
    std::vector<piece> pieces;
    if constexpr (N == 2) {
        pieces.push_back(plane_piece(determinant(w, e[0]), determinant(u, e[0]), dot<2>(e[0], e[0]), r));
        pieces.back().only_within(dot<2>(w, e[0]), dot<2>(u, e[0]), dot<2>(e[0], e[0]));
        pieces.push_back(corner_piece<2>(w, u, r, 0));
        pieces.push_back(corner_piece<2>(w - e[0], u, r, 1));
    } else {
        pieces.push_back(face_piece(s, false));
        for (std::size_t i = 0; i < 2; ++i) {
            pieces.push_back(edge_piece<3>(w, u, e[1 - i], r, static_cast<int>(2 * i)));
            pieces.push_back(edge_piece<3>(w - e[i], u, e[1 - i], r, static_cast<int>(2 * i + 1)));
        }
        pieces.push_back(corner_piece<3>(w, u, r, 0));
        pieces.push_back(corner_piece<3>(w - e[0], u, r, 1));
        pieces.push_back(corner_piece<3>(w - e[1], u, r, 2));
        pieces.push_back(corner_piece<3>(w - e[0] - e[1], u, r, 3));
    }
    const bool crosses = pieces.front().a != 0;
    return encounter_of(std::move(pieces), r == 0, crosses, unit);
}

template <class T>
answer meet(const graze::ball<3, T>& b, const graze::triangle<T>& triangle) {
    const auto s = seen<3>(b, triangle);
    const auto& [w, u, r, e, unit] = s;
    std::vector<piece> pieces{face_piece(s, true),
                              edge_piece<3>(w, u, e[1], r, 0),
                              edge_piece<3>(w - e[0], u, e[1] - e[0], r, 1),
                              edge_piece<3>(w, u, e[0], r, 2),
                              corner_piece<3>(w, u, r, 0),
                              corner_piece<3>(w - e[0], u, r, 1),
                              corner_piece<3>(w - e[1], u, r, 2)};
    const bool crosses = pieces.front().a != 0;
    return encounter_of(std::move(pieces), r == 0, crosses, unit);
}

} // namespace oracle
