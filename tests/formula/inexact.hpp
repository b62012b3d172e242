// The results of graze::solve in an inexact number type T: every value is within the bound that running error analysis
// derives for that very pair, and no decision is wrong where no sign was in doubt.
#pragma once

#include "../oracle/contact.hpp"
#include "tracked.hpp"

#include <graze/number/floating.hpp>
#include <graze/solve.hpp>

#include <doctest/doctest.h>

#include <cstdint>
#include <random>
#include <string>

namespace inexact {

// x exactly, for a binary type of any length: its leading doubles, one after the other.
template <class T>
mpq_class exact_value(T x) {
    mpq_class sum = 0;
    while (graze::sign(x) != 0) {
        const double part = static_cast<double>(x);
        sum += mpq_class(part);
        x = x - T(part);
    }
    return sum;
}

template <class T>
struct counts {
    long values = 0, outside = 0; // outside: values outside their bound
    long unbounded = 0;           // values with an infinite bound
    long untrue = 0;              // values that differ from what T gives without the tracking
    long pairs = 0, doubtful = 0; // doubtful: pairs with an uncertain sign
    long wrong = 0;               // wrong decisions although no sign was uncertain

    void compare(const tracked<T>& x, const oracle::surd& truth, const T& untracked) {
        ++values;
        untrue += x.value == untracked ? 0 : 1;
        if (!(x.error <= std::numeric_limits<double>::max())) {
            ++unbounded;
            return;
        }
        const mpq_class value = exact_value(x.value);
        const mpq_class error(x.error);
        outside += oracle::compare(truth, value - error) < 0 || oracle::compare(truth, value + error) > 0 ? 1 : 0;
    }
    template <int N>
    void compare(const graze::vec<N, tracked<T>>& x, const oracle::surd_vector<N>& truth,
                 const graze::vec<N, T>& untracked) {
        for (int i = 0; i < N; ++i) {
            compare(x[i], truth[i], untracked[i]);
        }
    }
};

// A double converted to T, which holds it exactly.
template <class T>
struct to {
    static T convert(double x) { return static_cast<T>(x); }
};
template <class T>
struct to<tracked<T>> {
    static tracked<T> convert(double x) { return tracked<T>(to<T>::convert(x)); }
};

template <class T, int N>
graze::vec<N, T> in(const graze::vec<N, double>& x) {
    return graze::make_vec<N>([&](int i) { return to<T>::convert(x[i]); });
}
template <class T, int N>
graze::ball<N, T> in(const graze::ball<N, double>& b) {
    return {in<T>(b.position), in<T>(b.velocity), to<T>::convert(b.radius), to<T>::convert(b.mass)};
}
template <class T, int N>
graze::plane<N, T> in(const graze::plane<N, double>& p) {
    return {in<T>(p.point), in<T>(p.normal)};
}
template <class T, int N>
graze::wall<N, T> in(const graze::wall<N, double>& w) {
    graze::wall<N, T> wall{in<T>(w.corner), {}};
    for (std::size_t i = 0; i < w.edge.size(); ++i) {
        wall.edge[i] = in<T>(w.edge[i]);
    }
    return wall;
}
// Numbers that every type holds exactly: multiples of 2^-20 of at most 24 bits, with all of these bits or few.
class draws {
  public:
    explicit draws(std::uint64_t seed) : engine_(seed) {}

    double coordinate(double limit) {
        const auto steps = static_cast<std::int64_t>(limit * 0x1p20);
        const auto any = static_cast<std::int64_t>(engine_() >> 1) % (2 * steps + 1) - steps;
        return static_cast<double>(any) * 0x1p-20;
    }
    template <int N>
    graze::vec<N, double> point(double limit) {
        return graze::make_vec<N>([&](int) { return coordinate(limit); });
    }
    double radius() { return std::abs(coordinate(2)); }
    double small() { return std::round(1 + std::abs(coordinate(1)) * 0x1p16) * 0x1p-16; } // at most 17 bits
    double mass() { return 1 + std::abs(coordinate(7)); }
    bool one_in(std::uint64_t n) { return engine_() % n == 0; }

  private:
    std::mt19937_64 engine_;
};

// Two balls. One pair in four grazes exactly (a multiple of a tangent of whole numbers), one in four nearly, and one in
// four nearly touches already.
template <int N>
struct ball_pair {
    graze::ball<N, double> a, b;
};
template <int N>
ball_pair<N> draw_balls(draws& d) {
    ball_pair<N> p{{d.point<N>(7), d.point<N>(2), d.radius(), d.mass()}, {{}, {}, d.radius(), d.mass()}};
    const auto set = [](graze::vec<N, double>& v, double x, double y) {
        v = graze::make_vec<N>([&](int i) { return i == 0 ? x : i == 1 ? y : 0.0; });
    };
    if (d.one_in(4)) {
        const double along = d.small(), across = d.small(), speed = d.small();
        set(p.a.velocity, 4 * speed, 3 * speed);
        set(p.a.position, -4 * along + 3 * across, -3 * along - 4 * across);
        p.a.radius = across * 2;
        p.b.radius = across * 3;
    } else if (d.one_in(3)) {
        set(p.a.velocity, 1, d.coordinate(0x1p-10));
        set(p.a.position, -7, 3);
        p.a.position[N - 1] += d.coordinate(0x1p-10);
        p.a.radius = 1;
        p.b.radius = 2;
    } else if (d.one_in(2)) {
        set(p.a.position, -4 + d.coordinate(0x1p-10), 3);
        p.a.radius = 2;
        p.b.radius = 3;
    }
    return p;
}

template <class T, int N, graze::variant V, graze::root_form F>
void try_balls(const ball_pair<N>& p, const oracle::answer& met, counts<T>& count) {
    sign_was_uncertain = false;
    const auto s = graze::solve<V, F>(in<tracked<T>>(p.a), in<tracked<T>>(p.b));
    const auto plain = graze::solve<V, F>(in<T>(p.a), in<T>(p.b));
    ++count.pairs;
    count.untrue += s.what == plain.what ? 0 : 1;
    const bool right = static_cast<int>(s.what) == static_cast<int>(met.what);
    count.doubtful += sign_was_uncertain ? 1 : 0;
    count.wrong += !right && !sign_was_uncertain ? 1 : 0;
    if (right && graze::is_collision(s.what)) {
        const auto c = oracle::contact(p.a, p.b, 1 / mpq_class(p.a.mass), 1 / mpq_class(p.b.mass), met);
        count.compare(s.time, c.time, plain.time);
        count.compare(s.position_a, c.position_a, plain.position_a);
        count.compare(s.position_b, c.position_b, plain.position_b);
        count.compare(s.normal, c.normal, plain.normal);
        count.compare(s.velocity_a, c.velocity_a, plain.velocity_a);
        count.compare(s.velocity_b, c.velocity_b, plain.velocity_b);
    }
}

template <class T, int N>
void try_balls_by_each_variant(const ball_pair<N>& p, counts<T>& count) {
    using enum graze::variant;
    using graze::root_form;
    const oracle::answer met = oracle::meet(p.a, p.b);
    try_balls<T, N, lagrange, root_form::stable>(p, met, count);
    try_balls<T, N, textbook, root_form::printed>(p, met, count);
    try_balls<T, N, halved, root_form::stable>(p, met, count);
    if constexpr (graze::has_fma<T>) {
        try_balls<T, N, kahan, root_form::printed>(p, met, count);
    }
}

template <class T, int N, class S>
void try_wall(const graze::ball<N, double>& ball, const S& wall, counts<T>& count) {
    const oracle::answer met = oracle::meet(ball, wall);
    sign_was_uncertain = false;
    const auto s = graze::solve(in<tracked<T>>(ball), in<tracked<T>>(wall));
    const auto plain = graze::solve(in<T>(ball), in<T>(wall));
    ++count.pairs;
    count.doubtful += sign_was_uncertain ? 1 : 0;
    count.untrue += s.what == plain.what && s.where == plain.where && s.index == plain.index ? 0 : 1;
    constexpr bool has_features = requires { wall.edge; };
    const auto where = static_cast<oracle::feature>(s.where);
    const bool right = static_cast<int>(s.what) == static_cast<int>(met.what) &&
                       (!has_features || s.what == graze::encounter::miss || met.has(where, s.index));
    count.wrong += !right && !sign_was_uncertain ? 1 : 0;
    if (right && graze::is_collision(s.what)) {
        oracle::wall_contact<N> c;
        if constexpr (has_features) {
            c = oracle::contact(ball, wall, met, where, s.index);
        } else {
            c = oracle::contact(ball, wall, met);
        }
        count.compare(s.time, c.time, plain.time);
        count.compare(s.position, c.position, plain.position);
        count.compare(s.point, c.point, plain.point);
        count.compare(s.normal, c.normal, plain.normal);
        count.compare(s.velocity, c.velocity, plain.velocity);
    }
}

template <class T, int N>
counts<T> try_all(int times) {
    counts<T> count;
    draws d(20230607);
    for (int i = 0; i < times; ++i) {
        try_balls_by_each_variant<T, N>(draw_balls<N>(d), count);
        const graze::ball<N, double> ball{d.point<N>(4), d.point<N>(2), d.radius(), d.mass()};
        try_wall<T, N>(ball, graze::plane<N, double>{d.point<N>(2), d.point<N>(3)}, count);
        graze::wall<N, double> wall{d.point<N>(2), {}};
        for (auto& e : wall.edge) {
            e = d.point<N>(3);
        }
        try_wall<T, N>(ball, wall, count);
    }
    return count;
}

template <class T, int N>
void check_dimension(int times) {
    const counts<T> count = try_all<T, N>(times);
    CAPTURE(N);
    CHECK(count.outside == 0);
    CHECK(count.wrong == 0);
    CHECK(count.untrue == 0);
    // Enough was tested.
    CHECK(count.values > 10 * times);
    CHECK(count.unbounded * 100 <= count.values);
    CHECK(count.doubtful * 3 <= count.pairs); // a sixth of them graze exactly
    MESSAGE(std::string(graze::number_traits<T>::name), ": ", count.values, " values of ", count.pairs, " pairs, ",
            count.unbounded, " without a bound, ", count.doubtful, " doubtful pairs");
}

template <class T>
void check_all(int times) {
    static_assert(graze::field_number<T> && graze::has_sqrt<T> && !graze::exact_number<T>);
    check_dimension<T, 2>(times);
    check_dimension<T, 3>(times);
}

} // namespace inexact
