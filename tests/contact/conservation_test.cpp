// What rounding does to momentum and energy. Every component of a velocity is the exact one times 1 + δ, |δ| <= u =
// 2^-53, or, where it is subnormal, less than 2^-1075 off. With masses and velocities as given and exact ones after:
//   momentum along an axis  is off by at most  Σ (u m |v| + 2^-1075 m),
//   the energy E            is off by at most  (2u + u²) E + what subnormals lose.
#include "answers.hpp"

#include "../soak/soak.hpp"

#include <gmpxx.h>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

namespace contact_conservation_test {

namespace {

const mpq_class u(mpz_class(1), mpz_class(1) << 53U);
const mpq_class least(mpz_class(1), mpz_class(1) << 1075U);

struct largest {
    mpq_class momentum = 0, energy = 0; // of the bound
    int contacts = 0;
};

mpq_class ratio(const mpq_class& error, const mpq_class& bound) {
    return error == 0 ? mpq_class(0) : mpq_class(abs(error) / bound);
}

template <int N>
bool is_finite(const graze::vec<N, double>& v) {
    for (int i = 0; i < N; ++i) {
        if (!std::isfinite(v[i])) {
            return false;
        }
    }
    return true;
}

template <int N>
void look(largest& found, const graze::ball<N>& a, const graze::ball<N>& b) {
    const auto c = answers::of(a, b).contact;
    if (!c || !std::isfinite(a.mass) || !std::isfinite(b.mass) || !is_finite(c->velocity_a) ||
        !is_finite(c->velocity_b)) {
        return;
    }
    const mpq_class mass_a(a.mass), mass_b(b.mass);
    mpq_class gained = 0, energy = 0, subnormal = 0;
    for (int i = 0; i < N; ++i) {
        const mpq_class before_a(a.velocity[i]), before_b(b.velocity[i]);
        const mpq_class after_a(c->velocity_a[i]), after_b(c->velocity_b[i]);
        // |exact| <= |rounded| / (1 - u) + 2^-1075
        const mpq_class size_a = abs(after_a) / (1 - u) + least, size_b = abs(after_b) / (1 - u) + least;
        const mpq_class lost = mass_a * (after_a - before_a) + mass_b * (after_b - before_b);
        const mpq_class bound = mass_a * (u * size_a + least) + mass_b * (u * size_b + least);
        found.momentum = std::max(found.momentum, ratio(lost, bound));
        gained +=
            mass_a * (after_a * after_a - before_a * before_a) + mass_b * (after_b * after_b - before_b * before_b);
        energy += mass_a * before_a * before_a + mass_b * before_b * before_b;
        subnormal += mass_a * least * (2 * size_a + least) + mass_b * least * (2 * size_b + least);
    }
    found.energy = std::max(found.energy, ratio(gained, mpq_class((2 * u + u * u) * energy + subnormal)));
    ++found.contacts;
}

template <int N>
largest look_at_families() {
    largest found;
    for (const families::family& family : soak::families_drawn) {
        for (std::uint64_t index = 0; index < 100; ++index) {
            const auto pair = family.draw<N>(23, index);
            if (pair.kind == families::pair_kind::ball_ball) {
                look(found, pair.a, pair.b);
            }
        }
    }
    return found;
}

void check(const largest& found) {
    CHECK(found.contacts > 500);
    CHECK(found.momentum <= 1);
    CHECK(found.energy <= 1);
    CHECK(found.momentum > mpq_class(1, 2)); // the bounds are nearly reached
    CHECK(found.energy > mpq_class(1, 4));
    MESSAGE(found.contacts << " contacts: momentum " << found.momentum.get_d() << ", energy " << found.energy.get_d()
                           << " of the bound at most");
}

} // namespace

TEST_CASE("rounded velocities keep momentum and energy to within their own rounding") {
    check(look_at_families<2>());
    check(look_at_families<3>());
}

} // namespace contact_conservation_test
