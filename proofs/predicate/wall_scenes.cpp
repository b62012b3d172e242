// A ball and a rectangle, over a few starts and velocities. The encounter is compared with the least distance, whose
// square is rational and a piecewise quadratic function of time; the contact of a collision is compared in Q(√d) with
// its definition. (formula/wall_encounter.cpp has many more starts, for the encounter alone.)
#include <graze/solve.hpp>

#include "../rational.hpp"

#include <array>
#include <optional>

namespace {

using namespace graze;
using proof::rational;
using surd = sqrt_extension<rational>;

template <int N>
using exact_ball = ball<N, rational>;

// The wall lies in the first coordinate's plane: |x_i| <= half(i) in the others.
constexpr int half(int i) { return i == 1 ? 2 : 3; }
constexpr wall<2, rational> flat(const wall<2, rational>*) { return {{{0, -2}}, {{{{0, 4}}}}}; }
constexpr wall<3, rational> flat(const wall<3, rational>*) { return {{{0, -2, -3}}, {{{{0, 4, 0}}, {{0, 0, 6}}}}}; }
template <int N>
constexpr auto rectangle = flat(static_cast<const wall<N, rational>*>(nullptr));

// How far x is beside [-half, half], with its sign.
template <class T>
constexpr T beside(const T& x, int i) {
    if (i == 0) {
        return x;
    }
    const T above = x - T(half(i));
    const T below = x + T(half(i));
    return sign(above) > 0 ? above : sign(below) < 0 ? below : T(0);
}

template <int N>
constexpr rational distance2(const exact_ball<N>& b, const rational& t) {
    rational sum = 0;
    for (int i = 0; i < N; ++i) {
        const rational d = beside(b.position[i] + b.velocity[i] * t, i);
        sum = sum + d * d;
    }
    return sum;
}
// Half of its derivative, which is continuous.
template <int N>
constexpr rational slope(const exact_ball<N>& b, const rational& t) {
    rational sum = 0;
    for (int i = 0; i < N; ++i) {
        sum = sum + beside(b.position[i] + b.velocity[i] * t, i) * b.velocity[i];
    }
    return sum;
}

// The least squared distance for t >= 0. Between the times at which a coordinate passes ±half the slope is linear.
template <int N>
constexpr rational least(const exact_ball<N>& b) {
    std::array<rational, 2 * N> times{};
    std::size_t count = 1; // times[0] is t = 0
    for (int i = 1; i < N; ++i) {
        for (const int end : {-half(i), half(i)}) {
            if (sign(b.velocity[i]) != 0) {
                const rational t = (rational(end) - b.position[i]) / b.velocity[i];
                if (sign(t) > 0) {
                    times[count++] = t;
                }
            }
        }
    }
    times[count++] = 100; // later than any
    for (std::size_t i = 1; i < count; ++i) {
        for (std::size_t j = i; j > 0 && times[j] < times[j - 1]; --j) {
            std::swap(times[j], times[j - 1]);
        }
    }
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const rational from = slope(b, times[i]);
        const rational to = slope(b, times[i + 1]);
        if (sign(from) >= 0) {
            return distance2(b, times[i]);
        }
        if (sign(to) >= 0) {
            return distance2(b, times[i] - from * (times[i + 1] - times[i]) / (to - from));
        }
    }
    return distance2(b, times[count - 1]);
}

template <int N>
constexpr encounter by_distance(const exact_ball<N>& b) {
    if (sign(slope(b, rational(0))) >= 0) {
        return encounter::recede;
    }
    const rational r2 = b.radius * b.radius;
    if (distance2(b, rational(0)) < r2) {
        return encounter::overlap;
    }
    const int against = sign(least(b) - r2);
    if (against != 0) {
        return against > 0 ? encounter::miss : encounter::hit;
    }
    return sign(b.radius) == 0 && sign(b.velocity[0]) != 0 ? encounter::hit : encounter::graze;
}

template <int N>
constexpr bool right(const exact_ball<N>& b) {
    const auto s = solve(b, rectangle<N>);
    if (s.what != by_distance(b)) {
        return false;
    }
    if (!is_collision(s.what)) {
        return true;
    }
    // At τ the ball is where its flight takes it; it touches the wall's closest point, at the distance r, and still
    // gets closer. A graze is of an edge or a corner, even if the ball slides over the face from there.
    surd distance = surd(0);
    surd approach = surd(0);
    int clamped = 0;
    for (int i = 0; i < N; ++i) {
        const surd x = surd(b.position[i]) + surd(b.velocity[i]) * s.time;
        const surd apart = beside(x, i);
        if (x != s.position[i] || x - apart != s.point[i]) {
            return false;
        }
        clamped += i != 0 && sign(apart) != 0 ? 1 : 0;
        distance = distance + apart * apart;
        approach = approach + apart * surd(b.velocity[i]);
    }
    const feature where = clamped == 0 ? feature::face : clamped == 1 && N == 3 ? feature::edge : feature::corner;
    const bool at_its_distance =
        s.what == encounter::overlap ? s.time == surd(0) : distance == surd(b.radius * b.radius);
    const int closer = sign(approach);
    return at_its_distance && (s.what == encounter::graze ? closer == 0 : closer < 0 || sign(b.radius) == 0) &&
           (s.where == where || s.what == encounter::graze || sign(b.radius) == 0) &&
           squared_norm(s.velocity) == surd(squared_norm(b.velocity));
}

template <int N>
constexpr exact_ball<N> thrown(const vec<N, rational>& x, const vec<N, rational>& u, int radius) {
    return {x, u, radius, 1};
}

// In the plane: starts on and off a grid around the segment, into several directions. In space: towards the wall, from
// beside it and over it.
constexpr bool in_the_plane(int x, int radius) {
    for (const int y : {-4, 0, 3}) {
        for (const int v : {-1, 2}) {
            if (!right(thrown<2>({{x, y}}, {{-1, v}}, radius)) || !right(thrown<2>({{x, y}}, {{0, v}}, radius))) {
                return false;
            }
        }
    }
    return right(thrown<2>({{x, 1}}, {{1, 0}}, radius));
}
static_assert(in_the_plane(2, 2) && in_the_plane(-3, 0));

constexpr bool in_space(int x, int y, int radius) {
    for (const int z : {-5, 3, 4}) {
        for (const int v : {-1, 1}) {
            if (!right(thrown<3>({{x, y, z}}, {{-1, v, 0}}, radius)) ||
                !right(thrown<3>({{x, y, z}}, {{-1, v, -1}}, radius))) {
                return false;
            }
        }
    }
    return true;
}
static_assert(in_space(3, -4, 1) && in_space(3, 2, 0));

// Along the plane: into edges and corners from beside, sliding over the face, touching in passing.
constexpr bool along_the_plane(int x, int radius) {
    for (const int y : {-6, 2}) {
        for (const int z : {-7, 1, 4}) {
            const int w = z < 0 ? 1 : -1;
            if (!right(thrown<3>({{x, y, z}}, {{0, 1, w}}, radius)) ||
                !right(thrown<3>({{x, y, z}}, {{0, -1, 0}}, radius)) ||
                !right(thrown<3>({{x, y, z}}, {{0, 0, w}}, radius))) {
                return false;
            }
        }
    }
    return true;
}
static_assert(along_the_plane(0, 1));

// (3, 4, 5) beside edges and corners: exact grazes.
static_assert(right(thrown<3>({{9, 7, 1}}, {{-1, 0, 0}}, 5)) && right(thrown<3>({{9, 5, 7}}, {{-1, 0, 0}}, 5)) &&
              right(thrown<3>({{-9, -5, -7}}, {{1, 0, 0}}, 5)) && right(thrown<2>({{9, -7}}, {{-2, 0}}, 5)));

} // namespace
