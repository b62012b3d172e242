// Hard pairs of flights: made from hard pairs of balls, and from small numbers, with which touches, grazes and ties are
// frequent.
#pragma once

#include "../soak/more_families.hpp"
#include "../soak/soak.hpp"

#include <graze/formula/flight_motion.hpp>
#include <graze/number/floating.hpp>

#include <cmath>

namespace flight_families {

template <int N>
struct pair {
    graze::flight<N> a, b;
};

// Small numbers over 2^bits.
inline double small(families::random& r, std::int64_t limit, int bits) {
    return std::ldexp(static_cast<double>(r.in(-limit, limit)), -bits);
}

template <int N>
graze::flight<N> on_a_grid(families::random& r) {
    graze::flight<N> f{};
    for (int i = 0; i < N; ++i) {
        f.state.position[i] = small(r, 8, 0);
        f.state.velocity[i] = small(r, 3, 1);
    }
    f.state.radius = r.one_in(6) ? 0 : std::ldexp(static_cast<double>(r.in(0, 8)), -1);
    f.state.mass = r.one_in(5) ? INFINITY : static_cast<double>(r.in(1, 4));
    f.since = small(r, 8, 2);
    return f;
}

inline double full(families::random& r, double size) {
    return size * std::ldexp(static_cast<double>(r.signed_bits(53)), -53);
}

// Flights that pass each other along an axis, at the distance at which they touch or near it.
template <int N>
pair<N> passing(families::random& r) {
    pair<N> p{on_a_grid<N>(r), on_a_grid<N>(r)};
    for (int i = 1; i < N; ++i) {
        p.a.state.velocity[i] = p.b.state.velocity[i] = 0;
        p.a.state.position[i] = p.b.state.position[i];
    }
    p.a.state.velocity[0] = 1.5;
    p.a.state.position[0] = -20;
    p.a.state.position[1] += p.a.state.radius + p.b.state.radius;
    p.a.state.radius += r.one_in(3) ? std::fabs(small(r, 1, 50)) : 0;
    p.b.state.mass = 1;
    return p;
}

// Doubles with all their bits. One flight starts `spread` after the other, both at about `epoch`.
template <int N>
graze::flight<N> generic(families::random& r, double epoch, double spread) {
    graze::flight<N> f{};
    for (int i = 0; i < N; ++i) {
        f.state.position[i] = full(r, 10);
        f.state.velocity[i] = full(r, 1);
    }
    f.state.radius = 1.5 + full(r, 1);
    f.state.mass = 2 + full(r, 1);
    f.since = epoch + full(r, spread);
    return f;
}

// Flights that are a hard pair of balls when both have started: exactly if doubles can hold that, otherwise nearly.
template <int N>
pair<N> of_balls(families::random& r, const families::pair_of_doubles<N>& balls) {
    pair<N> p{{balls.a, 0}, {balls.b, 0}};
    const double epoch = small(r, 1000, 4);
    p.a.since = p.b.since = epoch;
    const double lead = std::ldexp(static_cast<double>(r.in(0, 3)), static_cast<int>(r.in(-3, 3)));
    graze::flight<N>& earlier = r.one_in(2) ? p.a : p.b;
    earlier.since -= lead;
    for (int i = 0; i < N; ++i) {
        earlier.state.position[i] -= earlier.state.velocity[i] * lead;
    }
    return p;
}

template <int N>
bool come_closer(const graze::flight<N>& a, const graze::flight<N>& b) {
    return graze::coefficient_h{}(graze::relative_motion_of(a, b)) < 0;
}

// Any of these, depending on `which` mod 5.
template <int N>
pair<N> draw(unsigned which, std::uint64_t seed, std::uint64_t index) {
    families::random r(seed, index);
    switch (which % 5) {
    case 0:
        if (r.one_in(3)) {
            return passing<N>(r);
        }
        [[fallthrough]];
    case 1:
        for (;;) { // two infinite masses are refused; most others should come closer
            const auto a = on_a_grid<N>(r);
            const auto b = on_a_grid<N>(r);
            const bool finite = !std::isinf(a.state.mass) || !std::isinf(b.state.mass);
            if (finite && (r.one_in(5) || come_closer(a, b))) {
                return {a, b};
            }
        }
    case 2: {
        const auto a = generic<N>(r, 100, 10);
        return {a, generic<N>(r, 100, 10)};
    }
    case 3: { // epochs that are large and far apart
        const double epoch = std::ldexp(1.0, static_cast<int>(r.in(-40, 40)));
        const auto a = generic<N>(r, epoch, epoch);
        auto b = generic<N>(r, -epoch, epoch);
        for (int i = 0; i < N; ++i) { // so that they can meet
            const graze::flight<N>& earlier = a.since < b.since ? a : b;
            const double way = earlier.state.velocity[i] * std::fabs(a.since - b.since);
            b.state.position[i] += a.since < b.since ? way : -way;
        }
        return {a, b};
    }
    default: {
        const auto& family = families::all_families[r.below(families::all_families.size())];
        const auto balls = family.draw<N>(seed, index);
        if (balls.kind != families::pair_kind::ball_ball) {
            const auto a = generic<N>(r, 1, 1);
            return {a, generic<N>(r, 1, 1)};
        }
        return of_balls(r, balls);
    }
    }
}

} // namespace flight_families
