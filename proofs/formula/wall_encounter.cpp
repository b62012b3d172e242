// flat_decision in whole numbers. Over grids of starts and velocities, encounter and feature must follow from the
// distance, whose square is a piecewise quadratic, convex function of time. The oracle takes thousands of signs for
// each case, none of them by a formula of the library.
#include <graze/formula/solve_flat.hpp>

#include "../whole.hpp"

#include <array>

namespace {

using namespace graze;
using proof::whole;
using int64 = std::int64_t;

// The wall lies where the first coordinate is 0 and |x_i| <= half(i) in the others.
constexpr int half(int i) { return i == 1 ? 2 : 3; }

struct thrown {
    std::array<int, 3> x, u;
    int r;
};
// A time n/d, d > 0.
struct fraction {
    int64 n = 0, d = 1;
};
constexpr bool before(fraction s, fraction t) { return s.n * t.d < t.n * s.d; }

template <int N>
struct flight {
    const thrown& b;

    // d times the coordinate at n/d; how far that is beside the wall; on which side: -1, 0 or 1.
    constexpr int64 at(int i, fraction t) const {
        const auto k = static_cast<std::size_t>(i);
        return b.x[k] * t.d + b.u[k] * t.n;
    }
    constexpr int side(int i, fraction t) const {
        return i == 0 ? 0 : at(i, t) > half(i) * t.d ? 1 : at(i, t) < -half(i) * t.d ? -1 : 0;
    }
    constexpr int64 beside(int i, fraction t) const {
        return i == 0 ? at(i, t) : side(i, t) == 0 ? 0 : at(i, t) - side(i, t) * half(i) * t.d;
    }
    // The sign of distance - r.
    constexpr int against_radius(fraction t) const {
        int64 sum = -static_cast<int64>(b.r) * b.r * t.d * t.d;
        for (int i = 0; i < N; ++i) {
            sum += beside(i, t) * beside(i, t);
        }
        return (sum > 0) - (sum < 0);
    }
    // Half the derivative of the squared distance, times d.
    constexpr int64 slope(fraction t) const {
        int64 sum = 0;
        for (int i = 0; i < N; ++i) {
            sum += beside(i, t) * b.u[static_cast<std::size_t>(i)];
        }
        return sum;
    }
    // The feature on which the wall's closest point is. Borders belong to the larger feature.
    constexpr feature where(fraction t) const {
        int beyond = 0;
        for (int i = 1; i < N; ++i) {
            beyond += side(i, t) != 0 ? 1 : 0;
        }
        return beyond == 0 ? feature::face : beyond == 1 && N == 3 ? feature::edge : feature::corner;
    }
};

// The times at which a coordinate passes an end of the wall, in order, between 0 and a late time.
template <int N>
struct passages {
    std::array<fraction, 2 * N> time{};
    std::size_t count = 1;
    constexpr explicit passages(const thrown& b) {
        for (int i = 1; i < N; ++i) {
            const auto k = static_cast<std::size_t>(i);
            for (const int end : {-half(i), half(i)}) {
                const int u = b.u[k];
                const fraction t{u > 0 ? end - b.x[k] : b.x[k] - end, u > 0 ? u : -u};
                if (u != 0 && t.n > 0) {
                    time[count++] = t;
                }
            }
        }
        time[count++] = {100, 1};
        for (std::size_t i = 1; i < count; ++i) {
            for (std::size_t j = i; j > 1 && before(time[j], time[j - 1]); --j) {
                const fraction later = time[j - 1];
                time[j - 1] = time[j];
                time[j] = later;
            }
        }
    }
};

struct expected {
    encounter what;
    feature where; // the feature at the start, or of a hit
};

template <int N>
constexpr expected by_distance(const thrown& b) {
    const flight<N> f{b};
    if (f.slope({}) >= 0) {
        return {encounter::recede, f.where({})};
    }
    if (f.against_radius({}) < 0) {
        return {encounter::overlap, f.where({})};
    }
    const passages<N> p(b);
    for (std::size_t i = 0; i + 1 < p.count; ++i) {
        const fraction from = p.time[i];
        const fraction to = p.time[i + 1];
        const fraction middle{from.n * to.d + to.n * from.d, 2 * from.d * to.d};
        if (f.against_radius(from) == 0 && f.slope(from) < 0) {
            return {encounter::hit, f.where(from)}; // exactly at a passage
        }
        // Between passages the slope is linear: s(from) + (t - from) (s(to) - s(from))/(to - from), zero at t.
        const int64 s = f.slope(from) * to.d;
        const int64 e = f.slope(to) * from.d;
        const bool turns = s < 0 && e >= 0;
        const fraction least = turns ? fraction{from.n * to.d * e - to.n * from.d * s, from.d * to.d * (e - s)} : to;
        const int sign = f.against_radius(least);
        if (sign < 0 || (sign == 0 && !turns)) {
            const bool at_end = f.against_radius(to) == 0 && !(turns && sign < 0);
            return {encounter::hit, f.where(at_end ? to : middle)};
        }
        if (sign == 0) {
            const bool point_meets_it = b.r == 0 && b.u[0] != 0;
            return {point_meets_it ? encounter::hit : encounter::graze, f.where(least)};
        }
        if (turns) {
            return {encounter::miss, feature::face};
        }
    }
    return {encounter::miss, feature::face};
}

constexpr wall<2, whole> segment(bool other_end) {
    return other_end ? wall<2, whole>{{{0, 2}}, {{{{0, -4}}}}} : wall<2, whole>{{{0, -2}}, {{{{0, 4}}}}};
}
// The same rectangle from its corners, its edges in either order.
constexpr wall<3, whole> rectangle(int corner, bool swapped) {
    const int y = (corner & 1) != 0 ? 2 : -2;
    const int z = (corner & 2) != 0 ? 3 : -3;
    const vec<3, whole> e0{{0, -2 * y, 0}};
    const vec<3, whole> e1{{0, 0, -2 * z}};
    return {{{0, y, z}}, {{swapped ? e1 : e0, swapped ? e0 : e1}}};
}

template <int N>
constexpr ball<N, whole> ball_of(const thrown& b) {
    const auto vector = [](const std::array<int, 3>& x) {
        return make_vec<N>([&](int i) { return whole(x[static_cast<std::size_t>(i)]); });
    };
    return {vector(b.x), vector(b.u), b.r};
}

// Where index says that the closest point lies: λ_i < 0, inside, or > 1, as seen from the corner.
template <int N>
constexpr bool index_fits(const flat_answer& w, const thrown& b, const wall<N, whole>& in) {
    const flight<N> f{b};
    std::array<int, 2> beyond{};
    for (std::size_t i = 0; i + 1 < static_cast<std::size_t>(N); ++i) {
        const int k = sign(in.edge[i][1]) != 0 ? 1 : 2;
        beyond[i] = f.side(k, {}) * sign(in.edge[i][k]);
    }
    if (w.where == feature::face) {
        return w.index == 0 && beyond[0] == 0 && beyond[1] == 0;
    }
    if (w.where == feature::edge) {
        return beyond[static_cast<std::size_t>(w.index / 2)] == (w.index % 2 == 0 ? -1 : 1);
    }
    return beyond[0] == (w.index % 2 == 0 ? -1 : 1) && (N == 2 || beyond[1] == (w.index / 2 == 0 ? -1 : 1));
}

template <int N>
constexpr bool right(const thrown& b, const wall<N, whole>& in) {
    const auto m = detail::flat_motion_of(ball_of<N>(b), in);
    const detail::direct_judge<N, whole> judge(m);
    const auto way = way_of(m);
    const flat_decision<N, whole, detail::direct_judge<N, whole>> decide(m, way, judge);
    const flat_answer found = detail::decide_directly(m, judge);
    const expected e = by_distance<N>(b);
    if (!found.certain || found.what != e.what || (decide.clearance() < 0) != (flight<N>{b}.against_radius({}) < 0)) {
        return false;
    }
    // A point meets the rim as part of the face; a ball that slides along the face at the distance r grazes an edge or
    // a corner.
    switch (e.what) {
    case encounter::recede:
    case encounter::overlap:
        return found.where == e.where && index_fits<N>(found, b, in);
    case encounter::hit:
        return found.where == e.where || b.r == 0;
    case encounter::graze:
        return found.where == e.where || found.where != feature::face;
    default:
        return true;
    }
}

template <int N>
constexpr bool right(const thrown& b) {
    if constexpr (N == 2) {
        return right(b, segment(false)) && right(b, segment(true));
    } else {
        const int which = (b.x[1] + 2 * b.x[2] + b.u[0] + 16) & 7;
        return right(b, rectangle(which & 3, which > 3));
    }
}

// What features and their views are called.
static_assert(to_string(feature::face)[0] == 'f' && to_string(feature::edge)[0] == 'e' &&
              to_string(feature::corner)[0] == 'c');

// In the plane: starts on and off a grid, into several directions.
constexpr bool in_the_plane(int x, int r) {
    constexpr std::array<std::array<int, 2>, 4> directions{{{-1, 1}, {-1, -2}, {0, 1}, {0, -1}}};
    for (int y = -5; y <= 4; ++y) {
        for (const auto& u : directions) {
            if (!right<2>({{x, y, 0}, {u[0], u[1], 0}, r})) {
                return false;
            }
        }
    }
    return true;
}
static_assert(in_the_plane(2, 1));
static_assert(in_the_plane(1, 2));
static_assert(in_the_plane(2, 0));
static_assert(right<2>({{-3, 1, 0}, {1, 0, 0}, 1}) && right<2>({{-3, 1, 0}, {-1, 0, 0}, 1}));

// In space.
constexpr bool in_space(int x, int y, int r) {
    constexpr std::array<std::array<int, 3>, 6> directions{
        {{-1, 1, 0}, {-1, -1, 1}, {0, 1, 0}, {0, -1, 1}, {0, 0, -1}, {-1, 0, -1}}};
    for (const int z : {-5, -3, 0, 4}) {
        for (const auto& u : directions) {
            if (!right<3>({{x, y, z}, u, r})) {
                return false;
            }
        }
    }
    return true;
}
static_assert(in_space(2, -4, 1));
static_assert(in_space(2, 3, 2));
static_assert(in_space(0, -3, 1));
static_assert(in_space(1, 2, 0));

// (3, 4, 5) beside edges and corners: exact grazes, and one unit to either side.
constexpr bool beside_the_wall(int by) {
    return right<3>({{9, 7 + by, 1}, {-1, 0, 0}, 5}) && right<3>({{9, 1, -8 - by}, {-2, 0, 1}, 5}) &&
           right<3>({{9, 5, 7 + by}, {-1, 0, 0}, 5}) && right<3>({{-9, -5, -7 - by}, {1, 0, 0}, 5}) &&
           right<2>({{9, -7 - by, 0}, {-2, 0, 0}, 5});
}
static_assert(beside_the_wall(0) && beside_the_wall(1) && beside_the_wall(-1));

} // namespace
