// A contact's bounded components, compared with the oracle's.
#pragma once

#include "../oracle/contact.hpp"

#include <graze/time/certain_rounding.hpp>

#include <array>
#include <cmath>
#include <cstddef>

namespace bounds {

inline constexpr std::size_t components = 16;

// A contact's components in the order in which they are numbered; in the plane the third ones are not used.
template <int N>
std::array<oracle::surd, components> listed(const oracle::ball_contact<N>& c) {
    std::array<oracle::surd, components> list;
    list[0] = c.time;
    const oracle::surd_vector<N>* const vectors[] = {&c.position_a, &c.position_b, &c.normal, &c.velocity_a,
                                                     &c.velocity_b};
    for (std::size_t k = 0; k < 5; ++k) {
        for (std::size_t i = 0; i < N; ++i) {
            list[1 + 3 * k + i] = (*vectors[k])[static_cast<int>(i)];
        }
    }
    return list;
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
