#include "border.hpp"

#include "wide_vec.hpp"

#include <algorithm>
#include <optional>
#include <vector>

namespace compare {

namespace {

// The squared distance from a feature while the nearest point of its line or plane lies on it: a t² + 2 h t + c.
struct piece {
    wide a, h, c;
    std::optional<wide> low = std::nullopt, high = std::nullopt; // bounds of t; unbounded without
    bool never = false;
    bool is_rim = false, is_face = false;

    // Restricts it to the times t at which 0 <= at + t by <= 1.
    void restrict_to(const wide& at, const wide& by) {
        if (by == 0) {
            never = never || at < 0 || at > 1;
            return;
        }
        wide from = -at / by, to = (1 - at) / by;
        if (by < 0) {
            std::swap(from, to);
        }
        low = low ? std::max(*low, from) : from;
        high = high ? std::min(*high, to) : to;
    }
    [[nodiscard]] bool holds_at(const wide& t) const { return !never && !(low && t < *low) && !(high && t > *high); }
    [[nodiscard]] wide at(const wide& t) const { return (a * t + 2 * h) * t + c; }
    // The time, not below 0, at which the distance is least.
    [[nodiscard]] std::optional<wide> least_at() const {
        const wide from = low && *low > 0 ? *low : wide(0);
        if (never || (high && *high < from)) {
            return std::nullopt;
        }
        wide t = a > 0 ? std::max(from, wide(-h / a)) : from;
        return high ? std::min(t, *high) : t;
    }
};

// The distance from a point.
template <int N>
piece from_point(const wide_vec<N>& w, const wide_vec<N>& u) {
    return {graze::dot(u, u), graze::dot(w, u), graze::dot(w, w)};
}
// The distance from the segment along e.
template <int N>
piece from_segment(const wide_vec<N>& w, const wide_vec<N>& u, const wide_vec<N>& e) {
    const wide ee = graze::dot(e, e), we = graze::dot(w, e), ue = graze::dot(u, e);
    piece p{graze::dot(u, u) - ue * ue / ee, graze::dot(w, u) - we * ue / ee, graze::dot(w, w) - we * we / ee};
    p.restrict_to(wide(we / ee), wide(ue / ee));
    return p;
}
// The distance from the plane of normal n.
template <int N>
piece from_plane(const wide_vec<N>& w, const wide_vec<N>& u, const wide_vec<N>& n) {
    const wide nn = graze::dot(n, n), wn = graze::dot(w, n), un = graze::dot(u, n);
    return {un * un / nn, wn * un / nn, wn * wn / nn};
}

// The features of a wall or a triangle, the face first: in the plane, that is the segment itself.
template <int N>
std::vector<piece> features(const wide_vec<N>& w, const wide_vec<N>& u, const std::array<wide_vec<N>, N - 1>& edge,
                            bool is_triangle) {
    std::vector<piece> all;
    if constexpr (N == 2) {
        all.push_back(from_segment<2>(w, u, edge[0]));
    } else {
        const wide_vec<3> n = graze::cross(edge[0], edge[1]);
        all.push_back(from_plane<3>(w, u, n));
        wide at = 0, by = 0; // the sum of the coordinates along the edges
        for (std::size_t i = 0; i < 2; ++i) {
            const wide_vec<3> side = i == 0 ? graze::cross(edge[1], n) : graze::cross(n, edge[0]);
            const wide length = graze::dot(edge[i], side);
            const wide here = graze::dot(w, side) / length, speed = graze::dot(u, side) / length;
            all.front().restrict_to(here, speed);
            at += here;
            by += speed;
        }
        const auto add_rim = [&](const wide_vec<3>& from, const wide_vec<3>& along) {
            all.push_back(from_segment<3>(from, u, along));
            all.back().is_rim = true;
        };
        add_rim(w, edge[0]);
        add_rim(w, edge[1]);
        if (is_triangle) {
            all.front().restrict_to(at, by);
            add_rim(w - edge[0], edge[1] - edge[0]);
        } else {
            add_rim(w - edge[0], edge[1]);
            add_rim(w - edge[1], edge[0]);
        }
    }
    all.front().is_face = true;
    const std::size_t corners = is_triangle ? 3 : std::size_t{1} << edge.size();
    for (std::size_t corner = 0; corner < corners; ++corner) {
        wide_vec<N> from = w;
        for (std::size_t i = 0; i < edge.size(); ++i) {
            from = (corner >> i & 1U) != 0 ? from - edge[i] : from;
        }
        all.push_back(from_point<N>(from, u));
        all.back().is_rim = N == 2;
    }
    return all;
}

double share_of(const wide& x, const wide& by) { return by == 0 ? 0.0 : scaled(wide(abs(x) / by), 0); }

// If the centre goes through the face: the squared distance from there to the rim.
std::optional<wide> depth_of_crossing(const std::vector<piece>& pieces, const wide& speed_square) {
    const piece& face = pieces.front();
    const auto t = face.is_face ? face.least_at() : std::nullopt;
    // At the crossing the distance is 0, but for the last bits of a wide number.
    if (!t || *t <= 0 || face.a == 0 || face.at(*t) > ldexp(wide(face.c + speed_square * *t * *t), -700)) {
        return std::nullopt;
    }
    std::optional<wide> least;
    for (const piece& p : pieces) {
        if (p.is_rim && p.holds_at(*t)) {
            const wide square = p.at(*t);
            least = least ? std::min(*least, square) : square;
        }
    }
    return least;
}

border_distances distances(const std::vector<piece>& pieces, const wide& r, const wide& length_square,
                           const wide& speed_square, bool is_plane) {
    const piece* closest = nullptr;
    for (const piece& p : pieces) {
        if (p.holds_at(0) && (closest == nullptr || p.c < closest->c)) {
            closest = &p;
        }
    }
    border_distances result;
    result.receding = share_of(closest->h, wide(sqrt(length_square * speed_square)));
    result.overlapping = share_of(closest->c - r * r, length_square);
    if (is_plane) {
        return result;
    }
    if (const auto depth = depth_of_crossing(pieces, speed_square)) {
        result.hitting = share_of(*depth + r * r, length_square);
        return result;
    }
    std::optional<wide> least;
    for (const piece& p : pieces) {
        if (const auto t = p.least_at()) {
            const wide square = p.at(*t);
            least = least ? std::min(*least, square) : square;
        }
    }
    result.hitting = share_of(*least - r * r, length_square);
    return result;
}

} // namespace

template <int N>
border_distances border_distances_of(const problem<N>& pair) {
    const auto& a = pair.a.shape;
    if (pair.kind == pair_kind::ball_ball) {
        const auto& b = pair.b.shape;
        const wide_vec<N> w = widened<N>(a.position - b.position), u = widened<N>(a.velocity - b.velocity);
        const wide R = to_wide(exact(a.radius + b.radius));
        const piece apart = from_point<N>(w, u);
        return distances({apart}, R, wide(apart.c + R * R), apart.a, false);
    }
    const wide_vec<N> u = widened<N>(a.velocity);
    const wide r = to_wide(a.radius), speed_square = graze::dot(u, u);
    if (pair.kind == pair_kind::ball_plane) {
        const wide_vec<N> w = widened<N>(a.position - pair.plane.point);
        return distances({from_plane<N>(w, u, widened<N>(pair.plane.normal))}, r, wide(graze::dot(w, w) + r * r),
                         speed_square, true);
    }
    const wide_vec<N> w = widened<N>(a.position - pair.wall.corner);
    std::array<wide_vec<N>, N - 1> edge;
    wide length_square = graze::dot(w, w) + r * r;
    for (std::size_t i = 0; i < edge.size(); ++i) {
        edge[i] = widened<N>(pair.wall.edge[i]);
        length_square += graze::dot(edge[i], edge[i]);
    }
    return distances(features<N>(w, u, edge, pair.kind == pair_kind::ball_triangle), r, length_square, speed_square,
                     false);
}

double nearest_border(graze::encounter what, const border_distances& d) {
    switch (what) {
    case graze::encounter::recede:
        return d.receding;
    case graze::encounter::overlap:
        return std::min(d.receding, d.overlapping);
    default:
        return std::min({d.receding, d.overlapping, d.hitting});
    }
}

template border_distances border_distances_of(const problem<2>&);
template border_distances border_distances_of(const problem<3>&);

} // namespace compare
