// Exact ties and pairs that miss one by a few units of their last place: where words leave a number open, it is said to
// be 0 only if it is. The truth is computed here, in integers.
#include "answers.hpp"

#include <graze/overlaps.hpp>
#include <graze/pair/open_number.hpp>
#include <graze/predicate/refined_balls.hpp>

#include <doctest/doctest.h>
#include <gmpxx.h>

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <random>
#include <type_traits>

namespace {

using graze::detail::open_number;

// Integers: a with regard to b, and the sum of their radii.
struct relative {
    std::int64_t x[2], u[2], R;
};

mpz_class whole(std::int64_t x) { return mpz_class(static_cast<long>(x)); }

struct truth {
    graze::encounter what;
    bool overlaps;
};
truth truth_of(const relative& m) {
    const mpz_class x = whole(m.x[0]), y = whole(m.x[1]), u = whole(m.u[0]), v = whole(m.u[1]), R = whole(m.R);
    const mpz_class h = x * u + y * v, c = x * x + y * y - R * R;
    const mpz_class discriminant = h * h - (u * u + v * v) * c;
    const bool inside = c < 0;
    if (h >= 0) {
        return {graze::encounter::recede, inside};
    }
    return {inside              ? graze::encounter::overlap
            : discriminant < 0  ? graze::encounter::miss
            : discriminant == 0 ? graze::encounter::graze
                                : graze::encounter::hit,
            inside};
}

struct random_integers {
    std::mt19937_64 engine{20261130};
    std::int64_t in(std::int64_t low, std::int64_t high) {
        return std::uniform_int_distribution<std::int64_t>(low, high)(engine);
    }
};

// The pair, its radii divided somehow, in a frame and in units of its own; in the plane and in space.
void check(const relative& m, random_integers& random) {
    const truth t = truth_of(m);
    const auto in_units = [](std::int64_t x, int unit) { return std::ldexp(static_cast<double>(x), unit); };
    for (const bool unusual : {false, true}) {
        const int length = static_cast<int>(unusual ? random.in(-900, 900) : random.in(-60, 60));
        const int velocity = static_cast<int>(unusual ? random.in(-900, 900) : random.in(-60, 60));
        const std::int64_t of_b = random.in(0, m.R);
        graze::ball<2, double> a{}, b{};
        graze::ball<3, double> c{}, d{};
        for (int i = 0; i < 2; ++i) {
            const std::int64_t moved = random.in(-8, 8), faster = random.in(-8, 8);
            a.position[i] = c.position[i] = in_units(m.x[i] + moved, length);
            b.position[i] = d.position[i] = in_units(moved, length);
            a.velocity[i] = c.velocity[i] = in_units(m.u[i] + faster, velocity);
            b.velocity[i] = d.velocity[i] = in_units(faster, velocity);
        }
        a.radius = c.radius = in_units(m.R - of_b, length);
        b.radius = d.radius = in_units(of_b, length);
        auto by = graze::stage::filter;
        const bool right = answers::encounter_of(a, b, by) == t.what && answers::encounter_of(d, c, by) == t.what &&
                           answers::overlap_of(b, a, by) == t.overlaps && answers::overlap_of(c, d, by) == t.overlaps;
        CAPTURE(m.x[0]);
        CAPTURE(m.x[1]);
        CAPTURE(m.u[0]);
        CAPTURE(m.u[1]);
        CAPTURE(m.R);
        CHECK(right);
    }
}

std::int64_t gcd(std::int64_t a, std::int64_t b) { return b == 0 ? a : gcd(b, a % b); }

// x and y with x v - y u = 1.
void solve(std::int64_t u, std::int64_t v, std::int64_t& x, std::int64_t& y) {
    if (u == 0) {
        x = v; // ±1
        y = 0;
        return;
    }
    std::int64_t s = 0, t = 0; // s (v mod u) - t u with the arguments exchanged
    solve(v % u, u, s, t);     // s u - t (v mod u) = 1
    x = -t;
    y = -(s + t * (v / u));
}

} // namespace

// |u|² R² - X² is a small number k ≠ 0 if X/R is a convergent of |u|: D is then k units of its last place.
TEST_CASE("Pairs that miss a graze by a few units") {
    random_integers random;
    int ties = 0, others = 0;
    for (int round = 0; round < 300; ++round) {
        const std::int64_t u = random.in(1, 40), v = random.in(1, 40);
        if (gcd(u, v) != 1) {
            continue;
        }
        const std::int64_t a = u * u + v * v;
        const auto root = static_cast<std::int64_t>(std::sqrt(static_cast<double>(a)));
        std::int64_t x = 0, y = 0;
        solve(u, v, x, y);
        REQUIRE(x * v - y * u == 1);
        std::int64_t p0 = 1, p1 = root, q0 = 0, q1 = 1, m = 0, d = 1, k = root;
        while (p1 < std::int64_t{1} << 51) {
            relative pair{{0, 0}, {u, v}, q1}; // (x, y) p1, moved along the way so that it is near and ahead
            const mpz_class along = (whole(x) * whole(u) + whole(y) * whole(v)) * whole(p1) / whole(a);
            const mpz_class back = along + 1 + whole(random.in(q1 / 8, q1 + 8));
            pair.x[0] = mpz_class(whole(x) * whole(p1) - back * whole(u)).get_si();
            pair.x[1] = mpz_class(whole(y) * whole(p1) - back * whole(v)).get_si();
            if (std::llabs(pair.x[0]) < std::int64_t{1} << 52 && std::llabs(pair.x[1]) < std::int64_t{1} << 52) {
                check(pair, random);
                const auto what = truth_of(pair).what;
                (what == graze::encounter::graze ? ties : others) += 1;
            }
            if (root * root == a) { // ties, of any length
                p1 *= 3;
                q1 *= 3;
                continue;
            }
            m = d * k - m;
            d = (a - m * m) / d;
            k = (root + m) / d;
            const std::int64_t p = k * p1 + p0, q = k * q1 + q0;
            p0 = p1, q0 = q1, p1 = p, q1 = q;
        }
    }
    CHECK(ties > 50);
    CHECK(others > 1000);
}

// 3, 4, 5 and a unit more or less.
TEST_CASE("Pairs that nearly touch, or nearly move across the line between them") {
    random_integers random;
    for (int bits = 1; bits < 49; ++bits) {
        for (const std::int64_t off : {-1, 0, 1}) {
            const std::int64_t size = random.in(std::int64_t{1} << (bits - 1), (std::int64_t{1} << bits) - 1);
            const std::int64_t x = 3 * size, y = 4 * size;
            check({{x, y}, {random.in(-9, -1), random.in(-9, -1)}, 5 * size + off}, random);
            check({{x, y + off}, {random.in(-9, -1), random.in(-9, -1)}, 5 * size}, random);
            check({{x, y}, {-4 * (size - off), 3 * size}, size}, random);
            check({{x, y}, {-4 * size + off, 3 * size}, size}, random);
        }
    }
}

TEST_CASE("An open number is 0 if it is below one unit") {
    CHECK(!open_number{}.is_zero(0, 0)); // nothing is known
    for (const int unit : {-300, -1, 0, 7, 500}) {
        CHECK(open_number{open_number::h, std::ldexp(1.0, unit)}.is_zero(unit - 3, 3));
        CHECK(!open_number{open_number::h, std::nextafter(std::ldexp(1.0, unit), 2e300)}.is_zero(unit - 3, 3));
        CHECK(open_number{open_number::c, std::ldexp(1.0, 2 * unit)}.is_zero(unit, 999));
        CHECK(!open_number{open_number::c, std::ldexp(1.1, 2 * unit)}.is_zero(unit, 999));
        CHECK(open_number{open_number::discriminant, std::ldexp(1.0, 2 * unit)}.is_zero(unit - 3, 3));
        CHECK(!open_number{open_number::discriminant, std::ldexp(1.1, 2 * unit)}.is_zero(unit - 3, 3));
        CHECK(open_number{open_number::discriminant, 1, unit, 5}.is_zero(unit + 2, 3)); // in scaled units
        CHECK(!open_number{open_number::discriminant, 1.1, unit, 5}.is_zero(unit + 2, 3));
    }
    CHECK(!open_number{open_number::c, 1e-300}.is_zero(-1074, 0));
    CHECK(!open_number{open_number::c, std::nan("")}.is_zero(0, 0));
}

// A velocity above 2^996 overflows when it is split.
TEST_CASE("Where Dekker's product is out of its range, words know no limit") {
    using flight = graze::flight<2, double>;
    const flight a{{{0, 0}, {0x1p1000, 0}, 0x1p99}, 0};
    const flight b{{{0x1p100, 0}, {0x1p1000, 0}, 0}, 0x1p-900};
    const auto words = graze::detail::distance_in_words<flight>{&a, &b}(std::false_type{});
    CHECK(words.sign == graze::detail::open);
    CHECK(words.limit == 0);
    CHECK(graze::overlaps(a, b)); // a then is where b is
}
