// Distances from the border: small examples by hand, and whether the decision changes where they say.
#include "border.hpp"
#include "figures.hpp"

#include <graze/precision/decisions.hpp>
#include <graze/precision/formulas.hpp>

#include <doctest/doctest.h>

#include <cmath>

namespace {

using graze::encounter;
using graze::feature;
using graze::precision::answer;
using graze::precision::answered;
using graze::precision::quantity;

template <int N>
using any = graze::precision::pair<N>;

template <int N>
std::optional<mpq_class> square(const any<N>& p, const answer& given) {
    return search::borders<N>(p).square_to(given);
}
answer on(encounter what, feature where, int index) { return answered(graze::wall_encounter{what, where, index}); }
const answer recedes = answered(encounter::recede), overlaps = answered(encounter::overlap);
const answer misses = answered(encounter::miss), grazes = answered(encounter::graze), hits = answered(encounter::hit);

mpq_class ratio(long x, long y) {
    mpq_class q(x, y);
    q.canonicalize();
    return q;
}
mpq_class squared(const mpq_class& x) { return x * x; }

// The oracle's answer to the same pair with another radius.
template <int N>
encounter met_with(any<N> p, double radius) {
    p.a.radius = radius;
    return static_cast<encounter>(precision::truth<N>(p).met().what);
}

} // namespace

TEST_CASE("two balls") {
    // Δx = (3, 4), Δu = (-1, 0), R = 5: h = -3, c = 0, D = 9, L² = 50.
    const any<2> touching{{{3, 4}, {-1, 0}, 2}, graze::ball<2>{{0, 0}, {0, 0}, 3}};
    CHECK_FALSE(square(touching, hits));
    CHECK(*square(touching, overlaps) == 0);
    CHECK(*square(touching, recedes) == ratio(9, 50));
    CHECK(*square(touching, misses) == squared(ratio(9, 50))); // least distance² 16 against 25
    CHECK(*square(touching, grazes) == squared(ratio(9, 50)));
    // R = 4: D = 0.
    const any<2> grazing{{{3, 4}, {-1, 0}, 1}, graze::ball<2>{{0, 0}, {0, 0}, 3}};
    CHECK(*square(grazing, hits) == 0);
    CHECK(*square(grazing, misses) == 0);
    CHECK(*square(grazing, overlaps) == squared(ratio(9, 41)));
    // Receding: to hit, the balls would have to approach and to be nearer.
    const any<2> receding{{{3, 4}, {1, 0}, 1}, graze::ball<2>{{0, 0}, {0, 0}, 3}};
    CHECK(*square(receding, misses) == ratio(9, 41));
    CHECK(*square(receding, hits) == std::max(ratio(9, 41), squared(ratio(9, 41))));
    // Overlapping: to miss, the balls would have to be smaller than the least distance, 4, and not only than this one.
    const any<2> overlapping{{{3, 4}, {-1, 0}, 3}, graze::ball<2>{{0, 0}, {0, 0}, 3}};
    CHECK(*square(overlapping, hits) == squared(ratio(11, 61)));
    CHECK(*square(overlapping, misses) == squared(ratio(20, 61)));
}

TEST_CASE("a ball and a plane") {
    // Height 4 and speed -1 over the plane y = 0, |w|² = 25, r = 3.
    const any<2> above{{{3, 4}, {2, -1}, 3}, graze::plane<2>{{0, 0}, {0, 7}}};
    CHECK_FALSE(square(above, hits));
    CHECK(*square(above, overlaps) == squared(ratio(7, 34)));
    CHECK(*square(above, recedes) == ratio(16, 34 * 5));
    CHECK(*square(above, misses) == 1);
    const any<3> along{{{3, 4, 0}, {2, 0, 1}, 3}, graze::plane<3>{{0, 0, 0}, {0, 7, 0}}};
    CHECK(*square(along, hits) == 0); // it moves parallel to the plane, so it recedes
    CHECK_FALSE(square(along, recedes));
}

TEST_CASE("a ball and a wall") {
    const graze::wall<2> segment{{0, 0}, {{{8, 0}}}};
    // It comes down beside the end of the segment: least distance 2 from corner 1, |w|² + |e|² + r² = 116 + 64 + 1.
    const any<2> beside{{{10, 4}, {0, -1}, 1}, segment};
    CHECK_FALSE(square(beside, misses));
    CHECK(*square(beside, on(encounter::hit, feature::corner, 1)) == squared(ratio(3, 181)));
    CHECK(*square(beside, recedes) == ratio(16, 181));
    // It goes through, 3 from corner 0, and is touched on the face.
    const any<2> through{{{3, 4}, {0, -1}, 1}, segment};
    CHECK(*square(through, misses) == squared(ratio(10, 90)));
    CHECK_FALSE(square(through, on(encounter::hit, feature::face, 0)));
    CHECK(*square(through, on(encounter::hit, feature::corner, 0)) == ratio(9, 90));
    CHECK(*square(through, on(encounter::hit, feature::corner, 1)) == ratio(25, 90));
    CHECK(*square(through, on(encounter::hit, feature::edge, 0)) == 1); // there is no edge in the plane
    // Touched beyond the end, with r = 1: when the ball touches the corner, its foot on the face's line is 3/5 from the
    // corner, and the centre is 4/5 above that.
    const any<2> corner{{{8.5, 4}, {0, -1}, 1}, segment};
    CHECK_FALSE(square(corner, on(encounter::hit, feature::corner, 1)));
    CHECK(*square(corner, on(encounter::hit, feature::face, 0)) == ratio(1, 4) / (squared(ratio(17, 2)) + 81));

    // Aslant: corner 0 is touched at t = (9 - √7)/4, at x = (1 - √7)/4 before it.
    const any<2> aslant{{{-2, 2.5}, {1, -1}, 1}, segment};
    CHECK_FALSE(square(aslant, on(encounter::hit, feature::corner, 0)));
    CHECK(square(aslant, on(encounter::hit, feature::face, 0))->get_d() ==
          doctest::Approx((8 - 2 * std::sqrt(7.0)) / 16 / (4 + 6.25 + 64 + 1)).epsilon(1e-14));

    const graze::wall<3> square_wall{{0, 0, 0}, {{{8, 0, 0}, {0, 8, 0}}}};
    // Down at (-3/5, 2): edge 0 (λ_0 = 0) is touched at (0, 2), r = 1; L² = 0.36 + 4 + 16 + 128 + 1.
    const any<3> edge{{{-0.5, 2, 4}, {0, 0, -1}, 1}, square_wall};
    const mpq_class length = ratio(1, 4) + 4 + 16 + 128 + 1;
    CHECK_FALSE(square(edge, on(encounter::hit, feature::edge, 0)));
    CHECK(*square(edge, on(encounter::hit, feature::face, 0)) == ratio(1, 4) / length);
    CHECK(*square(edge, on(encounter::hit, feature::corner, 0)) == mpq_class(4) / length);
    CHECK(*square(edge, on(encounter::hit, feature::edge, 2)) == (ratio(1, 4) + 4) / length);
    CHECK(*square(edge, on(encounter::hit, feature::edge, 1)) == mpq_class(64) / length);
    // A point through the middle and one through the rim, which both hit.
    const any<3> point{{{4, 3, 4}, {0, 0, -1}, 0}, square_wall};
    CHECK(*square(point, misses) == squared(mpq_class(9) / (41 + 128)));
    const any<3> rim{{{0, 3, 4}, {0, 0, -1}, 0}, square_wall};
    CHECK_FALSE(square(rim, on(encounter::hit, feature::face, 0)));
    CHECK(*square(rim, misses) == 0);
    // Answers without an encounter, as collide gives them, and without a feature's index.
    CHECK(*square(point, answer{}) == std::min(squared(mpq_class(9) / (41 + 128)), ratio(16, 41 + 128)));
    answer touched = answered(quantity::time, 1.0);
    CHECK_FALSE(square(edge, touched));
    CHECK(*square(beside, touched) == 9 / squared(181));
    touched.where = feature::edge;
    touched.index = graze::precision::index_unknown;
    CHECK_FALSE(square(edge, touched));
    touched.where = feature::corner;
    CHECK(*square(edge, touched) == mpq_class(4) / length);
}

TEST_CASE("logarithms that lead the way are in order, and exact at powers of two") {
    CHECK(search::bits_of_root(ratio(1, 4)) == -1);
    CHECK(search::bits_of_root(mpq_class(4)) == 1);
    CHECK(search::bits_of_root(ratio(3, 8)) > -1);
    CHECK(search::bits_of_root(ratio(3, 8)) < search::bits_of_root(ratio(5, 12)));
    CHECK(search::logarithm_from(search::bits_of_root(ratio(3, 8))) == doctest::Approx(std::log2(0.375) / 2));
    CHECK(search::logarithm_from(search::bits_of_root(ratio(1, 8))) == -1.5);
}

TEST_CASE(
    "on every family: the distance is that at which the oracle decides otherwise, and wrong is what the judge says") {
    graze::precision::subjects formulas;
    graze::precision::add<graze::precision::solution_in<graze::variant::halved, graze::root_form::stable>, float>(
        formulas);
    const auto& formula = *formulas.front();
    std::size_t wrong = 0, wrong_feature = 0, radii = 0;
    for (const auto& family : precision::drawn_families(60, 7)) {
        CAPTURE(family.name);
        for (const auto& drawn : family.pairs) {
            std::visit(
                [&]<int N>(const any<N>& asked) {
                    const auto p = precision::held(asked, formula.type);
                    if (!p) {
                        return;
                    }
                    const search::borders<N> near(*p);
                    const precision::truth<N> right(*p);
                    const auto given = formula(*p);
                    const auto judged = precision::judge_one(formula, quantity::encounter, asked);
                    REQUIRE(given);
                    REQUIRE(judged);
                    const auto distance = near.square_to(*given);
                    CHECK(distance.has_value() == judged->wrong);
                    wrong += judged->wrong ? 1 : 0;
                    const auto met = static_cast<encounter>(right.met().what);
                    if (judged->wrong && given->what == met) {
                        ++wrong_feature;
                        CHECK(*distance > 0);
                    }
                    // From least f/L² follows the radius with which a missed pair would graze.
                    if (met != encounter::miss || p->a.radius == 0) {
                        return;
                    }
                    const double share = std::sqrt(near.square_to(hits)->get_d());
                    double lengths = 0, radius = p->a.radius;
                    const auto add = [&](double x) { lengths += x * x; };
                    std::visit(
                        [&](const auto& other) {
                            if constexpr (requires { other.edge; }) {
                                for (int i = 0; i < N; ++i) {
                                    add(p->a.position[i] - other.corner[i]);
                                    for (const auto& e : other.edge) {
                                        add(e[i]);
                                    }
                                }
                            } else if constexpr (requires { other.radius; }) {
                                radius += other.radius;
                                for (int i = 0; i < N; ++i) {
                                    add(p->a.position[i] - other.position[i]);
                                }
                            }
                        },
                        p->other);
                    add(radius);
                    const double grows = std::sqrt(radius * radius + share * lengths) - radius;
                    // If that radius differs enough from the pair's, in doubles.
                    if (!(grows > 0x1p-20 * radius && lengths < 0x1p900 && lengths > 0x1p-900 && share > 0x1p-20)) {
                        return;
                    }
                    ++radii;
                    CHECK(met_with(*p, p->a.radius + grows * (1 - 0x1p-12)) == encounter::miss);
                    CHECK(met_with(*p, p->a.radius + grows * (1 + 0x1p-12)) != encounter::miss);
                },
                drawn);
        }
    }
    CHECK(wrong > 20);
    CHECK(wrong_feature > 0);
    CHECK(radii > 50);
}

TEST_CASE("graze's own decisions are not found, of balls, planes and walls; naive ones on the border are, last") {
    graze::precision::subjects formulas;
    graze::precision::add<graze::precision::exact_decision_of_balls, double>(formulas);
    graze::precision::add<graze::precision::exact_decision_of_walls, double>(formulas);
    graze::precision::add<graze::precision::solution_in<graze::variant::halved, graze::root_form::stable>, double>(
        formulas);
    const auto families = precision::drawn_families(40, 3);
    std::size_t asked = 0, on_border = 0, found = 0;
    for (const char* const aim : {"nearest", "farthest"}) {
        const auto own = search::goal_of({aim, "encounter/classify/double", {}}, formulas);
        const auto naive = search::goal_of({aim, "encounter/halved.stable/double", {}}, formulas);
        CHECK(own.formulas.size() == 2);
        for (const auto& family : families) {
            CAPTURE(family.name);
            for (const auto& p : family.pairs) {
                const auto score = own.score(p), of_naive = naive.score(p);
                REQUIRE(score);
                CHECK_FALSE(own.is_found(*score));
                ++asked;
                if (of_naive && naive.is_found(*of_naive)) {
                    ++found;
                    if (naive.tell(*of_naive) == "wrong on the border itself") {
                        ++on_border;
                        CHECK(own.tell(*score).starts_with("right at 2^-32767.00")); // it is cut off there
                    } else {
                        CHECK(*of_naive > 0x1p15);
                    }
                }
            }
        }
    }
    CHECK(asked == 2 * 40 * families.size());
    CHECK(on_border > 0);
    CHECK(found > on_border);
}
