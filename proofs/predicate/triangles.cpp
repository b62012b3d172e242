// Triangles in whole numbers. The closest feature is compared with the distances to all corners and sides. For a ball
// that flies perpendicularly to the plane, the encounter is compared with its distance from the point that it stays
// beside.
#include <graze/classify.hpp>
#include <graze/formula/solve_flat.hpp>

#include "../whole.hpp"

#include <array>

namespace {

using namespace graze;
using ::proof::whole;

struct point {
    int y, z;
    constexpr point operator-() const { return {-y, -z}; }
    friend constexpr point operator+(point a, point b) { return {a.y + b.y, a.z + b.z}; }
    friend constexpr point operator-(point a, point b) { return a + -b; }
};
constexpr int inner(point a, point b) { return a.y * b.y + a.z * b.z; }
constexpr int outer(point a, point b) { return a.y * b.z - a.z * b.y; }

// Its corners, in the plane where the first coordinate is 0.
using corners = std::array<point, 3>;

// The squared distance is over/under. Borders belong to the larger feature.
struct closest {
    int over, under;
    feature where;
    int index;
};
constexpr closest closest_to(const corners& t, point p) {
    const int sense = outer(t[1] - t[0], t[2] - t[0]) < 0 ? -1 : 1;
    constexpr std::array<std::array<std::size_t, 2>, 3> ends{{{0, 2}, {1, 2}, {0, 1}}}; // of edges 0, 1 and 2
    bool inside = true;
    closest best{1000000, 1, feature::face, 0};
    const auto offer = [&](const closest& c) {
        if (c.over * best.under < best.over * c.under) {
            best = c;
        }
    };
    for (int k = 0; k < 3; ++k) {
        const auto [i, j] = ends[static_cast<std::size_t>(k)];
        const point from = p - t[i], e = t[j] - t[i];
        inside = inside && outer(e, from) * sense * (k == 0 ? -1 : 1) >= 0;
        if (inner(from, e) >= 0 && inner(from, e) <= inner(e, e)) {
            offer({outer(from, e) * outer(from, e), inner(e, e), feature::edge, k});
        }
    }
    for (std::size_t i = 0; i < 3; ++i) {
        offer({inner(p - t[i], p - t[i]), 1, feature::corner, static_cast<int>(i)});
    }
    return inside ? closest{0, 1, feature::face, 0} : best;
}

template <class T>
constexpr vec<3, T> in_space(point p) {
    return {{T(0), T(p.y), T(p.z)}};
}
constexpr bool right(const corners& t, point p) {
    const closest c = closest_to(t, p);
    const triangle<whole> shape{in_space<whole>(t[0]), {{in_space<whole>(t[1] - t[0]), in_space<whole>(t[2] - t[0])}}};
    const auto meets = [&](int speed, int radius) {
        const auto m = detail::flat_motion_of(ball<3, whole>{{{7, p.y, p.z}}, {{speed, 0, 0}}, radius}, shape);
        return detail::decide_directly(m, detail::direct_judge<3, whole>(m));
    };
    const auto is_there = [&](const flat_answer& found) { return found.where == c.where && found.index == c.index; };
    const int beside = c.over - 25 * c.under;
    const flat_answer met = meets(-1, 5);
    const flat_answer inside = meets(-1, 9); // 7² + beside² against 9²
    const flat_answer deep = meets(-1, 100);
    return met.what == (beside > 0    ? encounter::miss
                        : beside == 0 ? encounter::graze
                                      : encounter::hit) &&
           (beside > 0 || is_there(met)) && (inside.what == encounter::overlap) == (c.over < (81 - 49) * c.under) &&
           deep.what == encounter::overlap && is_there(deep) && meets(0, 1).what == encounter::recede &&
           meets(1, 1).what == encounter::recede;
}

// With sides along (3, 4)/5 and (4, -3)/5, from each corner and in either sense, at points in each feature's region and
// on borders between them; and with an obtuse corner, beyond which one λ is within [0, 1].
constexpr bool around(const corners& t, int turn) {
    const auto at = [&](int i) { return t[static_cast<std::size_t>((turn < 3 ? i + turn : turn + 3 - i) % 3)]; };
    for (int y = -7; y <= 13; y += 4) {
        for (int z = -9; z <= 6; z += 3) {
            if (!right({at(0), at(1), at(2)}, {y, z})) {
                return false;
            }
        }
    }
    return true;
}
constexpr corners right_angled{{{0, 0}, {3, 4}, {8, -6}}}, obtuse{{{0, 0}, {9, 0}, {-3, 3}}};
static_assert(around(right_angled, 0));
static_assert(around(right_angled, 1));
static_assert(around(right_angled, 5));
static_assert(around(obtuse, 2));
static_assert(around(obtuse, 3));
static_assert(around(obtuse, 4));
// At exactly 5 from an edge, from a corner, and from where they meet.
static_assert(right({{{0, 0}, {3, 4}, {8, -6}}}, {0, -5}) && right({{{0, 0}, {3, 4}, {8, -6}}}, {-4, 3}) &&
              right({{{0, 0}, {8, 0}, {0, 8}}}, {4, -5}) && right({{{0, 0}, {8, 0}, {0, 8}}}, {0, -5}) &&
              right({{{0, 0}, {8, 0}, {0, 8}}}, {-3, -4}));

// In doubles, at compile time; and seen from the other side.
constexpr triangle<double> table{{0, 0, 0}, {{{4, 0, 0}, {0, 4, 0}}}};
constexpr bool meets(const ball<3, double>& b, const wall_encounter& expected) {
    return classify_feature(b, table) == expected && classify_feature(table, b) == expected;
}
static_assert(meets({{1, 1, 5}, {0, 0, -1}, 1}, {encounter::hit, feature::face, 0}) &&
              meets({{2.5, 2.5, 5}, {0, 0, -1}, 1}, {encounter::hit, feature::edge, 1}) &&
              meets({{-1, 2, -5}, {0, 0, 1}, 1}, {encounter::graze, feature::edge, 0}) &&
              meets({{-3, -4, 5}, {0, 0, -1}, 5}, {encounter::graze, feature::corner, 0}) &&
              meets({{2.5, 2.5, 0.5}, {-1, 0, 0}, 1}, {encounter::overlap, feature::edge, 1}));
static_assert(classify(ball<3, double>{{3, 3, 5}, {0, 0, -1}, 1}, table) == encounter::miss);

} // namespace
