// A scene's pairs: all of them, or a sample whose strata have the stated sizes.
#include "exact_doubles.hpp"
#include "families.hpp"
#include "oracle/encounter.hpp"
#include "pairs.hpp"
#include "rounding.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace pairs_test {

using namespace compare;

namespace {

// 60 points on a line, evenly spaced, a third of which fly to the right, and two planes.
exact_scene<2> line_of_balls() {
    exact_scene<2> scene;
    for (int i = 0; i < 60; ++i) {
        exact_ball<2> b;
        b.shape.position = {{exact(10 * i), exact(0)}};
        b.shape.velocity = {{exact(i % 3 == 0 ? 1 : 0), exact(0)}};
        b.shape.radius = exact(1);
        b.inverse_mass = exact(i < 3 ? 0 : 1);
        scene.balls.push_back(b);
    }
    for (const int x : {-100, 1000}) {
        scene.planes.push_back({{{exact(x), exact(0)}}, {{exact(1), exact(0)}}});
    }
    return scene;
}

using key = std::tuple<pair_kind, exact, exact>;

template <int N>
key key_of(const problem<N>& p) {
    return {p.kind, p.a.shape.position[0], p.kind == pair_kind::ball_plane ? p.plane.point[0] : p.b.shape.position[0]};
}

template <int N>
std::map<std::pair<pair_kind, graze::encounter>, std::uint64_t> count(const std::vector<problem<N>>& pairs) {
    std::map<std::pair<pair_kind, graze::encounter>, std::uint64_t> result;
    for (const problem<N>& p : pairs) {
        ++result[{p.kind, encounter_of_pair<N>(p)}];
    }
    return result;
}

} // namespace

TEST_CASE("every pair, but those of two infinite masses") {
    const scene_pairs<2> all = pairs_of<2>(line_of_balls(), "line", every_pair);
    CHECK(all.both_infinite == 3);
    CHECK(all.total == 60 * 59 / 2 - 3 + 60 * 2);
    CHECK(all.pairs.size() == all.total);
    CHECK_FALSE(all.is_sample());
    CHECK(all.pairs[0].group == "line");
    std::set<key> distinct;
    for (const auto& p : all.pairs) {
        distinct.insert(key_of<2>(p));
    }
    CHECK(distinct.size() == all.total);
    // Ball 3i flies at the resting balls on its right (all hits); 20 fly to the plane on the right.
    std::map<std::pair<pair_kind, graze::encounter>, std::uint64_t> expected;
    expected[{pair_kind::ball_plane, graze::encounter::hit}] = 20;
    expected[{pair_kind::ball_plane, graze::encounter::recede}] = 100;
    std::uint64_t hits = 0;
    for (std::uint64_t i = 0; i < 20; ++i) {
        hits += 2 * (20 - i);
    }
    hits -= 2; // between infinite masses
    expected[{pair_kind::ball_ball, graze::encounter::hit}] = hits;
    expected[{pair_kind::ball_ball, graze::encounter::recede}] = all.total - 120 - hits;
    CHECK(count<2>(all.pairs) == expected);
    for (const stratum& s : all.strata) {
        CHECK(s.total == expected.at({s.kind, s.what}));
        CHECK(s.taken == s.total);
    }
    CHECK(all.strata.size() == expected.size());
}

TEST_CASE("a sample takes as many of each stratum as it says, none twice") {
    const exact_scene<2> scene = line_of_balls();
    const scene_pairs<2> sample = pairs_of<2>(scene, "line", 500, 7);
    CHECK(sample.is_sample());
    CHECK(sample.pairs.size() == 500);
    CHECK(sample.total == 60 * 59 / 2 - 3 + 60 * 2);
    const auto counts = count<2>(sample.pairs);
    std::uint64_t taken = 0;
    for (const stratum& s : sample.strata) {
        CHECK(counts.at({s.kind, s.what}) == s.taken);
        CHECK(s.taken <= s.total);
        taken += s.taken;
    }
    CHECK(taken == 500);
    CHECK(counts.at({pair_kind::ball_plane, graze::encounter::hit}) == 20);     // fewer than its share, so all
    CHECK(counts.at({pair_kind::ball_plane, graze::encounter::recede}) == 100); // the same
    CHECK(counts.at({pair_kind::ball_ball, graze::encounter::hit}) == 190);     // an equal part of the rest
    CHECK(counts.at({pair_kind::ball_ball, graze::encounter::recede}) == 190);
    std::set<key> distinct;
    for (const auto& p : sample.pairs) {
        distinct.insert(key_of<2>(p));
    }
    CHECK(distinct.size() == 500);

    std::vector<key> first, again, other;
    for (const auto& p : sample.pairs) {
        first.push_back(key_of<2>(p));
    }
    for (const auto& p : pairs_of<2>(scene, "line", 500, 7).pairs) {
        again.push_back(key_of<2>(p));
    }
    for (const auto& p : pairs_of<2>(scene, "line", 500, 8).pairs) {
        other.push_back(key_of<2>(p));
    }
    CHECK(first == again);
    CHECK(first != other);
}

TEST_CASE_TEMPLATE("encounters, against the oracle", N, std::integral_constant<int, 2>,
                   std::integral_constant<int, 3>) {
    for (const families::family& f : families::all_families) {
        for (std::uint64_t i = 0; i < 100; ++i) {
            const auto pair = f.draw<N::value>(5, i);
            CAPTURE(f.name);
            CAPTURE(i);
            CHECK(static_cast<int>(encounter_of_pair<N::value>(to_problem<N::value>(pair, ""))) ==
                  static_cast<int>(test::meet<N::value>(pair).what));
        }
    }
}

TEST_CASE("problems hold the doubles exactly") {
    const auto pair = families::find_family("masses")->draw<3>(1, 3);
    const problem<3> p = to_problem<3>(pair, "masses");
    const bool a_is_infinite = std::isinf(pair.a.mass);
    CHECK((a_is_infinite ? p.a : p.b).inverse_mass == 0);
    CHECK(nearest_double((a_is_infinite ? p.b : p.a).shape.mass) == (a_is_infinite ? pair.b : pair.a).mass);
    for (int i = 0; i < 3; ++i) {
        CHECK(nearest_double(p.a.shape.position[i]) == pair.a.position[i]);
        CHECK(nearest_double(p.b.shape.velocity[i]) == pair.b.velocity[i]);
    }
    CHECK(nearest_double(p.b.shape.radius) == pair.b.radius);
    CHECK(p.group == "masses");
    CHECK_THROWS_WITH_AS(static_cast<void>(draw_family<2>("gracing", 1, 1)),
                         doctest::Contains("--family: \"gracing\" is not a family; known are generic, grazing,"),
                         input_error);
    CHECK(draw_family<2>("generic", 7, 1).size() == 7);
}

TEST_CASE("a scene with very many pairs is sampled without deciding all, and not taken whole") {
    exact_scene<2> scene; // 100,000 balls on a line: 5 billion pairs, which would take hours
    for (int i = 0; i < 100'000; ++i) {
        exact_ball<2> b;
        b.shape.position = {{exact(10 * i), exact(0)}};
        b.shape.velocity = {{exact(i % 3 == 0 ? 1 : 0), exact(0)}};
        b.shape.radius = exact(1);
        b.inverse_mass = exact(i < 3 ? 0 : 1);
        scene.balls.push_back(b);
    }
    const scene_pairs<2> sample = pairs_of<2>(scene, "line", 300, 3);
    CHECK(sample.total == 100'000ULL * 99'999 / 2 - 3);
    CHECK(sample.classified > 390'000);
    CHECK(sample.classified <= 400'000);
    CHECK(sample.pairs.size() == 300);
    std::set<std::string> names;
    for (const auto& p : sample.pairs) {
        names.insert(p.name);
        CHECK(p.name == "ball " + std::to_string(static_cast<int>(nearest_double(p.a.shape.position[0])) / 10) +
                            " and ball " +
                            std::to_string(static_cast<int>(nearest_double(p.b.shape.position[0])) / 10));
    }
    CHECK(names.size() == 300);
    CHECK_THROWS_WITH_AS(static_cast<void>(pairs_of<2>(scene, "line", every_pair, 3)), doctest::Contains("--all"),
                         input_error);
}

} // namespace pairs_test
