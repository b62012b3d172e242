// Pairs in situations in which other programs were reported to be wrong, compared with rational numbers.
#include <graze/classify.hpp>
#include <graze/collide.hpp>
#include <graze/time_of_impact.hpp>

#include <doctest/doctest.h>
#include <gmpxx.h>

#include <cmath>
#include <limits>
#include <random>

namespace {

using graze::encounter;

mpz_class integer(std::int64_t x) { return mpz_class(std::to_string(x)); }

// The smaller root of a t² + 2 h t + c to 2000 bits.
mpf_class root(const mpq_class& a, const mpq_class& h, const mpq_class& c) {
    const mpq_class d = h * h - a * c;
    return (mpf_class(-h, 2000) - sqrt(mpf_class(d, 2000))) / mpf_class(a, 2000);
}
struct motion {
    mpq_class a, h, c;
};
template <int N, class T>
motion motion_of(const graze::ball<N, T>& x, const graze::ball<N, T>& y) {
    motion m{0, 0, 0};
    for (int i = 0; i < N; ++i) {
        const mpq_class dx = mpq_class(x.position[i]) - mpq_class(y.position[i]),
                        du = mpq_class(x.velocity[i]) - mpq_class(y.velocity[i]);
        m.a += du * du;
        m.h += dx * du;
        m.c += dx * dx;
    }
    const mpq_class r = mpq_class(x.radius) + mpq_class(y.radius);
    m.c -= r * r;
    return m;
}
// Whether no float is nearer to x.
bool is_nearest(float f, const mpf_class& x) {
    const auto distance = [&](float g) { return mpf_class(abs(mpf_class(g, 2000) - x)); };
    return distance(f) <= distance(std::nextafter(f, -INFINITY)) &&
           distance(f) <= distance(std::nextafter(f, INFINITY));
}

} // namespace

TEST_CASE("what rests, slides along or just parts recedes, and only what comes closer meets") {
    constexpr double least = std::numeric_limits<double>::denorm_min();
    for (const double apart : {2.0, 1.999, 0.5}) { // touching and overlapping
        const encounter closer = apart == 2 ? encounter::hit : encounter::overlap;
        const graze::ball<2> stands{{{0, 0}}, {{0, 0}}, 1};
        const graze::plane<2> plane{{{1 - apart, 0}}, {{3, 0}}};
        const graze::wall<2> wall{{{1 - apart, -9}}, {{{{0, 18}}}}}; // both at that distance less 1 from the centre
        for (const double along : {0.0, 3.0}) {
            for (const double speed : {0.0, least, 1.0}) {
                const graze::ball<2> other{{{apart, 0}}, {{speed, along}}, 1},
                    here{{{0, 0}}, {{speed, along}}, apart - 1};
                CHECK(graze::classify(other, stands) == encounter::recede);
                if (apart > 1) {
                    CHECK(graze::classify(here, plane) == encounter::recede);
                    CHECK(graze::classify(here, wall) == encounter::recede);
                }
            }
            for (const double speed : {least, 1.0}) {
                const graze::ball<2> other{{{apart, 0}}, {{-speed, along}}, 1};
                CHECK(graze::classify(other, stands) == closer);
                if (apart > 1) {
                    const graze::ball<2> here{{{0, 0}}, {{-speed, along}}, apart - 1};
                    CHECK(graze::classify(here, plane) == encounter::hit);
                    CHECK(graze::classify(here, wall) == encounter::hit);
                }
            }
        }
    }
}

TEST_CASE("an eye above a planet sees it at the nearest float") {
    const graze::ball<3, float> planet{{{0, 0, 0}}, {{0, 0, 0}}, 6.36e6F};
    int seen = 0;
    for (const float up : {0.5F, 10.0F, 1000.0F, 50e3F, 796e3F}) {
        for (int i = 0; i < 28; ++i) {
            const graze::ball<3, float> ray{
                {{0, 6.36e6F + up, 0}}, {{0.125F * static_cast<float>(i), -1, 0.0625F * static_cast<float>(i % 5)}}, 0};
            const auto t = graze::time_of_impact(ray, planet);
            const motion m = motion_of<3>(ray, planet);
            REQUIRE(t.has_value() == (m.h < 0 && m.h * m.h >= m.a * m.c));
            if (t) {
                ++seen;
                CHECK(is_nearest(static_cast<float>(*t), root(m.a, m.h, m.c)));
            }
        }
    }
    CHECK(seen > 60);
}

TEST_CASE("far from the origin a gap of a quarter is a gap of a quarter") {
    for (const float at : {8000.0F, 80'000.0F, 1e6F}) {
        const graze::ball<3, float> a{{{at, -at, at}}, {{2, 0, 0}}, 0.5F},
            b{{{at + 1.25F, -at, at}}, {{0, 0, 0}}, 0.5F};
        const auto t = graze::time_of_impact(a, b);
        REQUIRE(t);
        CHECK(static_cast<float>(*t) == 0.125F);
        const graze::wall<3, float> floor{{{at - 8, -at - 1, at - 8}}, {{{{16, 0, 0}}, {{0, 0, 16}}}}};
        const auto down = graze::time_of_impact(graze::ball<3, float>{{{at, -at, at}}, {{0, -2, 0}}, 0.75F}, floor);
        REQUIRE(down);
        CHECK(static_cast<float>(*down) == 0.125F);
    }
}

TEST_CASE("a ball that is cast on a box meets it at the nearest float, whatever the size of the box") {
    const graze::ball<3, float> ball{{{0.3F, 2, -0.7F}}, {{0, -1, 0}}, 0.5166F};
    for (const float half : {5.0F, 50.0F, 500.0F}) {
        const graze::wall<3, float> top{{{-half, 1, -half}}, {{{{2 * half, 0, 0}}, {{0, 0, 2 * half}}}}};
        const auto c = graze::collide(ball, top);
        REQUIRE(c);
        CHECK(is_nearest(c->time, mpf_class(1 - mpq_class(0.5166F), 2000)));
        CHECK(is_nearest(c->position[1], mpf_class(1 + mpq_class(0.5166F), 2000)));
    }
}

TEST_CASE("a ray of twelve kilometres finds a small sphere, and its place to the last bit") {
    std::mt19937 random(11);
    int hits = 0;
    for (const float radius : {0.05F, 0.25F, 1.0F}) {
        for (int i = 0; i < 60; ++i) {
            const auto aside = [&] { return radius * (static_cast<float>(random() % 2001) - 1000) / 800; };
            const graze::ball<3, float> ray{{{12'000, 3, -5}}, {{-12'000, -3 + aside(), 5 + aside()}}, 0};
            const graze::ball<3, float> sphere{{{0, 0, 0}}, {{0, 0, 0}}, radius};
            const auto c = graze::collide(ray, sphere);
            const motion m = motion_of<3>(ray, sphere);
            REQUIRE(c.has_value() == (m.h * m.h >= m.a * m.c));
            if (c) {
                ++hits;
                const mpf_class t = root(m.a, m.h, m.c);
                for (int k = 0; k < 3; ++k) {
                    CHECK(is_nearest(c->position_a[k], mpf_class(ray.position[k], 2000) + t * ray.velocity[k]));
                }
            }
        }
    }
    CHECK(hits > 50);
    CHECK(hits < 170);
}

TEST_CASE("a sliver is met where it is") {
    // Edges that are an angle of 1e-6 apart.
    const graze::wall<3> sliver{{{0, 0, 0}}, {{{{1, 0, 0}}, {{1, 0, 1e-6}}}}};
    std::mt19937_64 random(13);
    int inside = 0;
    for (int i = 0; i < 2000; ++i) {
        const double x = static_cast<double>(random() % 2049) / 1024,
                     z = static_cast<double>(random() % 1201) * 1e-9 - 1e-7;
        const mpq_class second = mpq_class(z) / mpq_class(1e-6), first = mpq_class(x) - second;
        const bool there = first >= 0 && first <= 1 && second >= 0 && second <= 1;
        inside += there ? 1 : 0;
        CHECK((graze::classify(graze::ball<3>{{{x, 1, z}}, {{0, -1, 0}}, 0}, sliver) == encounter::hit) == there);
    }
    CHECK(inside > 500);
    CHECK(inside < 1500);
}

TEST_CASE("a small sphere meets the ledge first and then the wall behind it") {
    const graze::ball<2> sphere{{{-1, 0.3}}, {{240, -20}}, 0.25};
    const double ledge_end = -0.1, wall_at = 0.8;
    const graze::wall<2> ledge{{{-9, 0}}, {{{{9 + ledge_end, 0}}}}}, wall{{{wall_at, -2}}, {{{{0, 4}}}}};
    const auto first = graze::time_of_impact(sphere, ledge), second = graze::time_of_impact(sphere, wall);
    REQUIRE(first);
    REQUIRE(second);
    CHECK(*first < *second);
    CHECK(static_cast<double>(*first) == doctest::Approx((0.3 - 0.25) / 20).epsilon(1e-14));
    CHECK(static_cast<double>(*second) == doctest::Approx((wall_at - 0.25 + 1) / 240).epsilon(1e-14));
}

TEST_CASE("integers up to the limits of 64 bits decide as big integers do, and ties are equal") {
    std::mt19937_64 random(17);
    const auto draw = [&](int bits) -> std::int64_t {
        const auto any = static_cast<std::int64_t>(random());
        return random() % 16 == 0 ? (any < 0 ? INT64_MIN : INT64_MAX) : any >> (64 - bits);
    };
    using ball = graze::ball<2, std::int64_t>;
    const auto motion_between = [](const ball& x, const ball& y) {
        motion m{0, 0, 0};
        for (int i = 0; i < 2; ++i) {
            const mpz_class dx = integer(x.position[i]) - integer(y.position[i]),
                            du = integer(x.velocity[i]) - integer(y.velocity[i]);
            m.a += du * du;
            m.h += dx * du;
            m.c += dx * dx;
        }
        const mpz_class r = integer(x.radius) + integer(y.radius);
        m.c -= r * r;
        return m;
    };
    int met = 0, ties = 0;
    for (int i = 0; i < 6000; ++i) {
        const int bits = static_cast<int>(random() % 60) + 5;
        const auto any = [&] {
            const std::int64_t r = draw(bits - 1);
            return ball{{{draw(bits), draw(bits)}},
                        {{draw(bits), draw(bits)}},
                        r == INT64_MIN ? INT64_MAX
                        : r < 0        ? -r
                                       : r};
        };
        const ball a = any(), b = any();
        ball c = any(), d = any();
        if (i % 4 == 0) { // mirrored, it is a tie
            c = a;
            d = b;
            for (ball* x : {&c, &d}) {
                std::swap(x->position[0], x->position[1]);
                std::swap(x->velocity[0], x->velocity[1]);
            }
        }
        const motion m = motion_between(a, b), n = motion_between(c, d);
        const auto expected = [](const motion& k) {
            const mpq_class disc = k.h * k.h - k.a * k.c;
            return k.h >= 0    ? encounter::recede
                   : k.c < 0   ? encounter::overlap
                   : disc < 0  ? encounter::miss
                   : disc == 0 ? encounter::graze
                               : encounter::hit;
        };
        CHECK(graze::classify(a, b) == expected(m));
        CHECK(graze::classify(c, d) == expected(n));
        const auto s = graze::time_of_impact(a, b), t = graze::time_of_impact(c, d);
        CHECK(s.has_value() == (expected(m) != encounter::recede && expected(m) != encounter::miss));
        if (s && t) {
            const auto time = [](const motion& k) { return k.c < 0 ? mpf_class(0, 2000) : root(k.a, k.h, k.c); };
            const mpf_class difference = time(m) - time(n);
            const bool tie = abs(difference) < mpf_class("1e-400", 2000);
            ++met;
            ties += tie ? 1 : 0;
            CHECK((*s == *t) == tie);
            CHECK((*s < *t) == (!tie && sgn(difference) < 0));
        }
    }
    CHECK(met > 300);
    CHECK(ties > 100);
}
