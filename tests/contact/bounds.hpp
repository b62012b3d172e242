// A contact's bounded components, compared with the oracle's.
#pragma once

#include "../oracle/contact.hpp"

#include <graze/time/certain_rounding.hpp>

#include <families/random.hpp>

#include <array>
#include <cmath>
#include <cstddef>

namespace bounds {

inline constexpr std::size_t components = 16;

// A contact's components in the order in which they are numbered; in the plane the third ones are not used.
template <int N, class... Vectors>
std::array<oracle::surd, components> listed(const oracle::surd& time, const Vectors&... vectors) {
    std::array<oracle::surd, components> list;
    list[0] = time;
    std::size_t at = 1;
    for (const oracle::surd_vector<N>* vector : {&vectors...}) {
        for (int i = 0; i < N; ++i) {
            list[at + static_cast<std::size_t>(i)] = (*vector)[i];
        }
        at += 3;
    }
    return list;
}
template <int N>
std::array<oracle::surd, components> listed(const oracle::ball_contact<N>& c) {
    return listed<N>(c.time, c.position_a, c.position_b, c.normal, c.velocity_a, c.velocity_b);
}
template <int N>
std::array<oracle::surd, components> listed(const oracle::wall_contact<N>& c) {
    return listed<N>(c.time, c.position, c.point, c.normal, c.velocity);
}

inline mpq_class exact(double x) { return mpq_class(x); }

inline double lane(double x, int) { return x; }
inline double lane(const graze::detail::lanes& x, int i) { return x[i]; }

// |x - (high + low)| <= error
template <class V>
bool holds(const graze::detail::bounded<V>& x, int i, const oracle::surd& truth) {
    const double high = lane(x.high, i), low = lane(x.low, i), error = lane(x.error, i);
    if (!std::isfinite(high) || !std::isfinite(low) || !std::isfinite(error)) {
        return true; // an infinite bound, which is never certain
    }
    const mpq_class middle = exact(high) + exact(low);
    return oracle::compare(truth, mpq_class(middle + exact(error))) <= 0 &&
           oracle::compare(truth, mpq_class(middle - exact(error))) >= 0;
}

// The time rounded, and then off by 2^-10 to 2^-70 of it.
inline double rough_time(families::random& r, const oracle::surd& time) {
    const double off = std::ldexp(1.0, -static_cast<int>(r.in(10, 70)));
    return oracle::approximate(time).get_d() * (1 + (r.one_in(2) ? off : -off));
}

template <int N, class T>
graze::vec<N, T> to(const graze::vec<N, double>& x) {
    return graze::make_vec<N>([&](int i) { return static_cast<T>(x[i]); });
}
template <class T, int N>
graze::ball<N, T> to(const graze::ball<N, double>& b) {
    return {to<N, T>(b.position), to<N, T>(b.velocity), static_cast<T>(b.radius), static_cast<T>(b.mass)};
}
template <int N, class T>
bool is_finite(const graze::ball<N, T>& b) {
    bool finite = std::isfinite(b.radius) && b.mass > 0;
    for (int i = 0; i < N; ++i) {
        finite = finite && std::isfinite(b.position[i]) && std::isfinite(b.velocity[i]);
    }
    return finite;
}

} // namespace bounds
