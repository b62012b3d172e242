// Each family has the property in its name, in exact arithmetic.
#include "exact_doubles.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <string>

using namespace families;
using oracle::encounter;
using test::power;

namespace {

constexpr std::uint64_t seed = 42;
constexpr std::uint64_t enough = 600;

// Calls f(pair, index) for the first pairs of a family.
template <int N, class F>
void for_pairs(const char* name, F f) {
    const family* drawn = find_family(name);
    REQUIRE(drawn != nullptr);
    for (std::uint64_t i = 0; i < enough; ++i) {
        CAPTURE(std::string(name));
        CAPTURE(N);
        CAPTURE(i);
        f(drawn->draw<N>(seed, i), i);
    }
}

bool within(const mpq_class& x, const mpq_class& low, const mpq_class& high) { return low <= x && x <= high; }

// x² lies between low² and high².
bool root_within(const mpq_class& square, const mpq_class& low, const mpq_class& high) {
    return within(square, mpq_class(low * low), mpq_class(high * high));
}

// The number of significant bits of x; 0 if x is no binary fraction.
std::size_t bits_of(const mpq_class& x) {
    if (mpz_popcount(x.get_den().get_mpz_t()) != 1 || x == 0) {
        return 0;
    }
    const mpz_class& n = x.get_num();
    return mpz_sizeinbase(n.get_mpz_t(), 2) - mpz_scan1(n.get_mpz_t(), 0);
}

int exponent_of(double x) { return x == 0 ? -1074 : std::ilogb(x); }

} // namespace

#define IN_BOTH_DIMENSIONS(name)                                                                                       \
    TEST_CASE_TEMPLATE(name, N, std::integral_constant<int, 2>, std::integral_constant<int, 3>)

IN_BOTH_DIMENSIONS("all pairs are valid input") {
    for (const family& f : all_families) {
        for_pairs<N::value>(f.name.data(), [](const auto& p, std::uint64_t) {
            for (const auto* b : {&p.a, &p.b}) {
                for (int i = 0; i < N::value; ++i) {
                    CHECK(std::isfinite(b->position[i]));
                    CHECK(std::isfinite(b->velocity[i]));
                }
                CHECK(std::isfinite(b->radius));
                CHECK(b->radius >= 0);
                CHECK(b->mass > 0);
            }
            CHECK_FALSE((std::isinf(p.a.mass) && std::isinf(p.b.mass)));
            if (p.kind == pair_kind::ball_plane) {
                CHECK(p.plane.normal[0] != 0);
            }
            if (p.kind == pair_kind::ball_wall) {
                mpq_class square = 0; // of e0 × e1, or of e0
                for (int i = 0; i < N::value; ++i) {
                    const int j = (i + 1) % N::value;
                    const auto& e = p.wall.edge;
                    const mpq_class part =
                        mpq_class(e[0][i]) * (N::value == 2 ? mpq_class(1) : mpq_class(e.back()[j])) -
                        (N::value == 2 ? mpq_class(0) : mpq_class(mpq_class(e[0][j]) * mpq_class(e.back()[i])));
                    square += part * part;
                }
                CHECK(square > 0);
            }
        });
    }
}

IN_BOTH_DIMENSIONS("encounters are mixed") {
    // The least percentages of the encounters that each family is about; nothing is asked of the others.
    const std::map<std::string, std::map<encounter, int>> least{
        {"generic", {{encounter::hit, 20}, {encounter::miss, 10}, {encounter::recede, 20}, {encounter::overlap, 2}}},
        {"grazing", {{encounter::hit, 45}, {encounter::miss, 45}}},
        {"tangent", {{encounter::graze, 50}, {encounter::hit, 20}, {encounter::miss, 20}}},
        {"far", {{encounter::hit, 20}, {encounter::miss, 40}}},
        {"tiny_radii", {{encounter::hit, 30}, {encounter::miss, 30}, {encounter::graze, 3}}},
        {"near_contact", {{encounter::hit, 50}, {encounter::miss, 10}, {encounter::recede, 10}}},
        {"touching", {{encounter::hit, 30}, {encounter::recede, 40}, {encounter::overlap, 2}}},
        {"after_bounce", {{encounter::recede, 70}, {encounter::overlap, 3}, {encounter::miss, 3}}},
        {"rounded_radius_sum", {{encounter::hit, 40}, {encounter::miss, 20}, {encounter::overlap, 20}}},
        {"common_part", {{encounter::hit, 30}, {encounter::miss, 30}, {encounter::recede, 5}}},
        {"almost_equal_velocities", {{encounter::hit, 30}, {encounter::miss, 30}}},
        {"equal_times", {{encounter::hit, 100}}},
        {"ties", {{encounter::hit, 100}}},
        {"edges_and_corners", {{encounter::hit, 40}, {encounter::miss, 40}}},
        {"borders", {{encounter::hit, 100}}},
        {"two_walls", {{encounter::hit, 100}}},
        {"generic_wall",
         {{encounter::hit, 25}, {encounter::miss, 15}, {encounter::recede, 15}, {encounter::overlap, 1}}},
        {"scaled", {{encounter::hit, 20}, {encounter::miss, 10}, {encounter::recede, 20}, {encounter::overlap, 2}}},
        {"subnormal", {{encounter::hit, 20}, {encounter::miss, 20}, {encounter::recede, 20}, {encounter::overlap, 1}}},
        {"own_exponents",
         {{encounter::hit, 1}, {encounter::miss, 20}, {encounter::recede, 40}, {encounter::overlap, 10}}},
        {"masses", {{encounter::hit, 100}}},
    };
    REQUIRE(least.size() == all_families.size());
    for (const auto& [name, shares] : least) {
        std::map<encounter, int> found;
        for_pairs<N::value>(name.c_str(), [&](const auto& p, std::uint64_t) { ++found[test::meet<N::value>(p).what]; });
        for (const auto& [what, share] : shares) {
            CAPTURE(name);
            CAPTURE(N::value);
            CAPTURE(static_cast<int>(what));
            CHECK(found[what] * 100 >= share * static_cast<int>(enough));
        }
    }
}

IN_BOTH_DIMENSIONS("grazing") {
    for_pairs<N::value>("grazing", [](const auto& p, std::uint64_t index) {
        const test::relative<N::value> m(p);
        CHECK(p.hardness == static_cast<int>(1 + index % 53));
        const mpq_class distance = m.c + m.R * m.R - m.h * m.h / m.a; // squared
        const mpq_class margin = abs(mpq_class((m.R * m.R - distance) / (m.R * m.R)));
        CHECK(within(margin, power(-p.hardness - 2), power(-p.hardness + 1)));
        CHECK(m.h < 0);
    });
}

IN_BOTH_DIMENSIONS("tangent") {
    for_pairs<N::value>("tangent", [](const auto& p, std::uint64_t index) {
        CHECK((test::relative<N::value>(p).D == 0) == (index % 2 == 0));
    });
}

IN_BOTH_DIMENSIONS("far and tiny radii") {
    for_pairs<N::value>("far", [](const auto& p, std::uint64_t index) {
        const test::relative<N::value> m(p);
        CHECK(p.hardness == static_cast<int>(index % 49));
        CHECK(root_within(mpq_class(m.c / (m.R * m.R) + 1), power(p.hardness - 2), power(p.hardness + 3)));
    });
    for_pairs<N::value>("tiny_radii", [](const auto& p, std::uint64_t index) {
        const test::relative<N::value> m(p);
        CHECK((p.hardness == -1) == (m.R == 0));
        if (p.hardness != -1) {
            CHECK(p.hardness == static_cast<int>(49 + index % 352));
            CHECK(root_within(mpq_class(m.c / (m.R * m.R) + 1), power(p.hardness - 2), power(p.hardness + 3)));
        }
    });
}

IN_BOTH_DIMENSIONS("near contact, touching and after a bounce") {
    for_pairs<N::value>("near_contact", [](const auto& p, std::uint64_t index) {
        const test::relative<N::value> m(p);
        CHECK(p.hardness == static_cast<int>(4 + index % 53));
        CHECK(root_within(mpq_class(m.c / (m.R * m.R) + 1), 1 + power(-p.hardness - 1), 1 + power(-p.hardness + 1)));
    });
    std::map<int, int> signs;
    for_pairs<N::value>("touching", [&](const auto& p, std::uint64_t index) {
        const test::relative<N::value> m(p);
        if (index % 4 != 3) {
            CHECK(m.c == 0);
            ++signs[sgn(m.h)];
        }
    });
    CHECK(signs[-1] > 100);
    CHECK(signs[0] > 50);
    CHECK(signs[1] > 50);
    int inside = 0;
    for_pairs<N::value>("after_bounce", [&](const auto& p, std::uint64_t) {
        const test::relative<N::value> m(p);
        CHECK(abs(m.c) <= power(-48) * m.R * m.R);
        inside += m.c < 0 ? 1 : 0;
    });
    CHECK(within(inside, 240, 360));
}

IN_BOTH_DIMENSIONS("a rounded sum of radii answers otherwise") {
    for_pairs<N::value>("rounded_radius_sum", [](auto p, std::uint64_t index) {
        const oracle::answer right = test::meet<N::value>(p);
        volatile double sum = p.a.radius + p.b.radius;
        CHECK(mpq_class(sum) != test::relative<N::value>(p).R);
        p.a.radius = sum;
        p.b.radius = 0;
        const oracle::answer rounded = test::meet<N::value>(p);
        if (index % 2 == 0) {
            CHECK(right.what != encounter::graze);
            CHECK(rounded.what == encounter::graze);
        } else { // at once if they overlap, else later
            CHECK((right.what == encounter::overlap || oracle::sign_of(*right.time) > 0));
            CHECK(rounded.what == encounter::hit);
            CHECK(oracle::sign_of(*rounded.time) == 0);
        }
    });
}

IN_BOTH_DIMENSIONS("common part and almost equal velocities") {
    int rounding = 0;
    for_pairs<N::value>("common_part", [&](const auto& p, std::uint64_t index) {
        const test::relative<N::value> m(p);
        if (index % 2 == 0) {
            const mpq_class distance = m.c + m.R * m.R - m.h * m.h / m.a;
            const mpq_class margin = abs(mpq_class((m.R * m.R - distance) / (m.R * m.R)));
            CHECK(within(margin, power(-p.hardness - 2), power(-p.hardness + 1)));
            std::size_t most = 0;
            for (const mpq_class& x : m.dx) {
                most = std::max(most, bits_of(x));
            }
            rounding += most > 53 ? 1 : 0;
        } else {
            mpq_class largest = 0;
            for (const mpq_class& x : m.dx) {
                largest = std::max(largest, mpq_class(abs(x)));
            }
            CHECK(within(largest, power(-p.hardness), power(1 - p.hardness)));
        }
    });
    CHECK(rounding >= static_cast<int>(enough / 2 * 9 / 10));
    for_pairs<N::value>("almost_equal_velocities", [](const auto& p, std::uint64_t) {
        const test::relative<N::value> m(p);
        for (const mpq_class& u : m.du) {
            CHECK(abs(u) <= power(1 - p.hardness)); // velocities are up to 2 or 4
        }
        CHECK(m.a > 0);
    });
}

IN_BOTH_DIMENSIONS("equal times") {
    for (const char* name : {"equal_times", "two_walls"}) {
        oracle::answer before;
        for_pairs<N::value>(name, [&](const auto& p, std::uint64_t index) {
            const oracle::answer now = test::meet<N::value>(p);
            if (index % 2 == 1) {
                const bool moved = index / 2 % 4 == 3;
                const int order = oracle::compare(*before.time, *now.time);
                CHECK((order == 0 || moved));
            }
            before = now;
        });
    }
    int different = 0;
    oracle::answer before;
    for_pairs<N::value>("equal_times", [&](const auto& p, std::uint64_t index) {
        const oracle::answer now = test::meet<N::value>(p);
        different += index % 8 == 7 && oracle::compare(*before.time, *now.time) != 0 ? 1 : 0;
        before = now;
    });
    CHECK(different == static_cast<int>(enough / 8));
}

IN_BOTH_DIMENSIONS("ties") {
    for_pairs<N::value>("ties", [](const auto& p, std::uint64_t index) {
        const test::relative<N::value> m(p);
        if (index % 3 == 2) {
            CHECK_FALSE((mpz_perfect_square_p(m.D.get_num().get_mpz_t()) != 0 && bits_of(mpq_class(m.c / -m.h)) == 54));
            return;
        }
        mpz_class numerator = sqrt(m.D.get_num()), denominator = sqrt(m.D.get_den());
        const mpq_class root(numerator, denominator);
        REQUIRE(root * root == m.D);
        const mpq_class time = (-m.h - root) / m.a;
        CHECK((index % 3 == 0 ? bits_of(time) == 54 : bits_of(time) <= 53));
        CHECK(time > 0);
    });
}

IN_BOTH_DIMENSIONS("edges and corners are grazed") {
    int on_face = 0;
    for_pairs<N::value>("edges_and_corners", [&](const auto& p, std::uint64_t) {
        const auto hits = [&](const mpq_class& factor) {
            const auto q = [](const auto& v) {
                graze::vec<N::value, mpq_class> result;
                for (int i = 0; i < N::value; ++i) {
                    result[i] = v[i];
                }
                return result;
            };
            graze::ball<N::value, mpq_class> b{q(p.a.position), q(p.a.velocity), mpq_class(p.a.radius) * factor, 1};
            graze::wall<N::value, mpq_class> w;
            w.corner = q(p.wall.corner);
            for (std::size_t i = 0; i < w.edge.size(); ++i) {
                w.edge[i] = q(p.wall.edge[i]);
            }
            return oracle::is_collision(oracle::meet(b, w).what);
        };
        CHECK_FALSE(hits(1 - power(-p.hardness + 1)));
        CHECK(hits(1 + power(-p.hardness + 1)));
        CHECK(hits(1 - power(-p.hardness - 2)) == hits(1 + power(-p.hardness - 2)));
        const oracle::answer met = test::meet<N::value>(p);
        on_face += met.what == encounter::hit && met.face ? 1 : 0;
    });
    CHECK(on_face < static_cast<int>(enough / 10));
}

IN_BOTH_DIMENSIONS("borders: two features are touched at once") {
    std::map<std::string, int> met;
    for_pairs<N::value>("borders", [&](const auto& p, std::uint64_t index) {
        const oracle::answer found = test::meet<N::value>(p);
        const std::string features =
            std::string(found.face ? "f" : "") + (found.edges != 0 ? "e" : "") + (found.corners != 0 ? "c" : "");
        if (index % 2 == 0) {
            CHECK(features.size() >= 2);
        }
        ++met[features];
    });
    if (N::value == 2) {
        CHECK(met["fc"] >= 300);
        CHECK(met["f"] >= 50);
        CHECK(met["c"] >= 50);
    } else {
        CHECK(met["fe"] + met["fec"] >= 140);
        CHECK(met["ec"] >= 140);
        CHECK(met["f"] >= 20);
        CHECK(met["e"] >= 40);
        CHECK(met["c"] >= 20);
    }
}

IN_BOTH_DIMENSIONS("ranges") {
    for_pairs<N::value>("scaled", [](const auto& p, std::uint64_t) {
        const int e = exponent_of(p.a.position[0]);
        CHECK((e > 440 || e < -440));
    });
    for_pairs<N::value>("subnormal", [](const auto& p, std::uint64_t index) {
        for (int i = 0; i < N::value; ++i) {
            CHECK(std::fpclassify(p.a.position[i]) != FP_NORMAL);
            CHECK((index % 2 == 0 || std::fpclassify(p.b.velocity[i]) != FP_NORMAL));
        }
        CHECK(std::fpclassify(p.a.radius) != FP_NORMAL);
    });
    int spread = 0;
    for_pairs<N::value>("own_exponents", [&](const auto& p, std::uint64_t) {
        spread += std::abs(exponent_of(p.a.position[0]) - exponent_of(p.b.position[1])) > 100 ? 1 : 0;
    });
    CHECK(spread > static_cast<int>(enough / 4));
    for_pairs<N::value>("masses", [](const auto& p, std::uint64_t index) {
        CHECK((std::isinf(p.a.mass) || std::isinf(p.b.mass)) == (index % 4 == 3));
        if (index % 4 != 3) {
            const int ratio = std::abs(exponent_of(p.a.mass) - exponent_of(p.b.mass));
            CHECK(std::abs(ratio - p.hardness) <= 4);
        }
    });
}

TEST_CASE("seeds and indices are streams of their own") {
    const family& f = *find_family("generic");
    const auto first = f.draw<3>(1, 5).a.position;
    CHECK(f.draw<3>(1, 5).a.position == first);
    CHECK_FALSE(f.draw<3>(2, 5).a.position == first);
    CHECK_FALSE(f.draw<3>(1, 6).a.position == first);
    CHECK(find_family("Generic") == nullptr);
}
