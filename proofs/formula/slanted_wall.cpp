// A wall whose edges are not at right angles, in whole numbers. The closest feature is compared with the distances to
// all corners and sides. For a ball that flies perpendicularly to the wall's plane, and so stays beside one point of
// the wall, the encounter is compared with its distance from that point.
#include <graze/formula/solve_flat.hpp>

#include "../whole.hpp"

#include <array>

namespace {

using namespace graze;
using proof::whole;

struct point {
    int y, z;
    constexpr point operator-() const { return {-y, -z}; }
    friend constexpr point operator+(point a, point b) { return {a.y + b.y, a.z + b.z}; }
    friend constexpr point operator-(point a, point b) { return a + -b; }
};
constexpr int inner(point a, point b) { return a.y * b.y + a.z * b.z; }
constexpr int outer(point a, point b) { return a.y * b.z - a.z * b.y; }

// In the plane where the first coordinate is 0.
struct parallelogram {
    point corner;
    std::array<point, 2> e;
};

// The squared distance is over/under.
struct closest {
    int over, under;
    feature where;
    int index;
};
// Borders belong to the larger feature: a point beside the end of a side counts as beside the side.
constexpr closest closest_to(const parallelogram& w, point p) {
    const int area = outer(w.e[0], w.e[1]);
    const int along0 = outer(p - w.corner, w.e[1]) * (area < 0 ? -1 : 1); // λ_0 |area|
    const int along1 = outer(w.e[0], p - w.corner) * (area < 0 ? -1 : 1);
    const int all = area < 0 ? -area : area;
    if (along0 >= 0 && along0 <= all && along1 >= 0 && along1 <= all) {
        return {0, 1, feature::face, 0};
    }
    closest best{1000000, 1, feature::face, 0};
    const auto offer = [&](const closest& c) {
        if (c.over * best.under < best.over * c.under) {
            best = c;
        }
    };
    for (int i = 0; i < 4; ++i) { // the side at λ_(i/2) = i % 2, along the other edge
        const auto across = static_cast<std::size_t>(i / 2);
        const point e = w.e[1 - across];
        const point from = p - (i % 2 == 0 ? w.corner : w.corner + w.e[across]);
        if (inner(from, e) >= 0 && inner(from, e) <= inner(e, e)) {
            offer({outer(from, e) * outer(from, e), inner(e, e), feature::edge, i});
        }
    }
    for (int i = 0; i < 4; ++i) {
        const point from = p - w.corner - (i % 2 == 0 ? point{0, 0} : w.e[0]) - (i / 2 == 0 ? point{0, 0} : w.e[1]);
        offer({inner(from, from), 1, feature::corner, i});
    }
    return best;
}

constexpr wall<3, whole> in_space(const parallelogram& w) {
    const auto vector = [](point p) { return vec<3, whole>{{0, p.y, p.z}}; };
    return {vector(w.corner), {{vector(w.e[0]), vector(w.e[1])}}};
}
constexpr bool right(const parallelogram& w, point p) {
    const closest c = closest_to(w, p);
    const auto meets = [&](int speed, int radius) {
        const auto m = detail::flat_motion_of(ball<3, whole>{{{7, p.y, p.z}}, {{speed, 0, 0}}, radius}, in_space(w));
        return detail::decide_directly(m, detail::direct_judge<3, whole>(m));
    };
    const flat_answer deep = meets(-1, 100);
    if (meets(0, 1).what != encounter::recede || deep.what != encounter::overlap || deep.where != c.where ||
        deep.index != c.index) {
        return false;
    }
    const int beside = c.over - 25 * c.under;
    const flat_answer met = meets(-1, 5);
    if (met.what != (beside > 0    ? encounter::miss
                     : beside == 0 ? encounter::graze
                                   : encounter::hit) ||
        (beside <= 0 && (met.where != c.where || met.index != c.index))) {
        return false;
    }
    const flat_answer inside = meets(-1, 9); // 7² + beside² against 9²
    return (inside.what == encounter::overlap) == (c.over < (81 - 49) * c.under) &&
           (inside.what != encounter::overlap || (inside.where == c.where && inside.index == c.index));
}

// A parallelogram with a side along (4, 3)/5, from each corner and with its edges in either order.
constexpr parallelogram seen_from_corner(int corner, bool swapped) {
    const std::array<point, 2> e{{{6, 0}, {4, 3}}};
    const point e0 = (corner & 1) != 0 ? -e[0] : e[0];
    const point e1 = (corner & 2) != 0 ? -e[1] : e[1];
    const point start = ((corner & 1) != 0 ? e[0] : point{0, 0}) + ((corner & 2) != 0 ? e[1] : point{0, 0});
    return {start, {swapped ? e1 : e0, swapped ? e0 : e1}};
}
// In each feature's region and on borders between them; at (-2, 1), (-2, -2), (12, 2) and (12, 5) a corner is closest
// though one λ is within [0, 1]. Five have a distance of exactly 5.
constexpr bool around(int corner, bool swapped) {
    for (const point p : {point{-2, 1},
                          {-2, -2},
                          {12, 2},
                          {12, 5},
                          {3, -5},
                          {7, 6},
                          {1, 3},
                          {9, 0},
                          {1, 7},
                          {-5, 0},
                          {8, -4},
                          {2, 7},
                          {14, 6},
                          {-5, -5},
                          {5, 1},
                          {3, 0},
                          {4, 3}}) {
        if (!right(seen_from_corner(corner, swapped), p)) {
            return false;
        }
    }
    return true;
}
static_assert(around(0, false));
static_assert(around(1, true));
static_assert(around(2, false));
static_assert(around(3, true));

} // namespace
