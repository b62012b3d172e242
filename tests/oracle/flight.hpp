// The encounter of flights, in exact arithmetic: both are moved to the later epoch in rationals, and then treated as
// balls.
#pragma once

#include "contact.hpp"

#include <graze/shape/flight.hpp>

#include <algorithm>
#include <type_traits>

namespace oracle {

template <int N, class V>
graze::vec<N, mpq_class> rationals(const V& v) {
    graze::vec<N, mpq_class> x;
    for (int i = 0; i < N; ++i) {
        x[i] = mpq_class(input(v[i]));
    }
    return x;
}

// The ball that a flight is at time t.
template <int N, class T>
graze::ball<N, mpq_class> ball_at(const graze::flight<N, T>& f, const mpq_class& t) {
    graze::ball<N, mpq_class> b{rationals<N>(f.state.position), rationals<N>(f.state.velocity),
                                mpq_class(input(f.state.radius)), mpq_class(1)};
    const mpq_class elapsed = t - mpq_class(input(f.since));
    for (int i = 0; i < N; ++i) {
        b.position[i] += b.velocity[i] * elapsed;
    }
    return b;
}

template <int N, class T>
graze::plane<N, mpq_class> exact(const graze::plane<N, T>& p) {
    return {rationals<N>(p.point), rationals<N>(p.normal)};
}
template <class T>
graze::triangle<mpq_class> exact(const graze::triangle<T>& t) {
    return {rationals<3>(t.corner), {rationals<3>(t.edge[0]), rationals<3>(t.edge[1])}};
}
template <int N, class T>
graze::wall<N, mpq_class> exact(const graze::wall<N, T>& w) {
    graze::wall<N, mpq_class> r;
    r.corner = rationals<N>(w.corner);
    for (std::size_t i = 0; i < w.edge.size(); ++i) {
        r.edge[i] = rationals<N>(w.edge[i]);
    }
    return r;
}

// A pair at the instant `start`, as balls and shapes of rationals. `met` counts from there, `time` from 0.
template <class Other, int N>
struct flight_answer {
    mpq_class start;
    graze::ball<N, mpq_class> a;
    Other b;
    answer met;
    std::optional<surd> time;
};

template <int N, class Other>
flight_answer<Other, N> meet_from(const mpq_class& start, const graze::ball<N, mpq_class>& a, const Other& b) {
    flight_answer<Other, N> r{start, a, b, meet(a, b), std::nullopt};
    if (r.met.time) {
        r.time = *r.met.time + rational(start);
    }
    return r;
}

template <int N, class T>
auto meet(const graze::flight<N, T>& a, const graze::flight<N, T>& b) {
    const mpq_class start = std::max(mpq_class(input(a.since)), mpq_class(input(b.since)));
    return meet_from(start, ball_at(a, start), ball_at(b, start));
}
template <int N, class T, class Shape>
auto meet(const graze::flight<N, T>& f, const Shape& shape) {
    const mpq_class start(input(f.since));
    return meet_from(start, ball_at(f, start), exact(shape));
}

} // namespace oracle
