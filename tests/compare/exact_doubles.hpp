// A family's pair in exact arithmetic, for tests: computed by the oracle and GMP, not by the code under test.
#pragma once

#include "oracle/encounter.hpp"

#include "../../examples/families/families.hpp"

namespace test {

template <int N>
[[nodiscard]] oracle::answer meet(const families::pair_of_doubles<N>& pair) {
    switch (pair.kind) {
    case families::pair_kind::ball_plane:
        return oracle::meet(pair.a, pair.plane);
    case families::pair_kind::ball_wall:
        return oracle::meet(pair.a, pair.wall);
    default:
        return oracle::meet(pair.a, pair.b);
    }
}

template <int N>
using rationals = std::array<mpq_class, N>;

template <int N>
[[nodiscard]] mpq_class dot(const rationals<N>& x, const rationals<N>& y) {
    mpq_class sum = 0;
    for (std::size_t i = 0; i < N; ++i) {
        sum += x[i] * y[i];
    }
    return sum;
}

// The numbers on which two balls' encounter rests.
template <int N>
struct relative {
    rationals<N> dx, du;
    mpq_class R, a, h, c, D;

    explicit relative(const families::pair_of_doubles<N>& p) : R(mpq_class(p.a.radius) + mpq_class(p.b.radius)) {
        for (int i = 0; i < N; ++i) {
            const auto at = static_cast<std::size_t>(i);
            dx[at] = mpq_class(p.a.position[i]) - mpq_class(p.b.position[i]);
            du[at] = mpq_class(p.a.velocity[i]) - mpq_class(p.b.velocity[i]);
        }
        a = dot<N>(du, du);
        h = dot<N>(dx, du);
        c = dot<N>(dx, dx) - R * R;
        D = h * h - a * c;
    }
};

// 2^k.
[[nodiscard]] inline mpq_class power(int k) {
    const mpz_class one = 1;
    return k >= 0 ? mpq_class(one << static_cast<unsigned long>(k))
                  : mpq_class(one, one << static_cast<unsigned long>(-k));
}

} // namespace test
