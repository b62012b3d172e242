// The regression itself: figures for answers with known errors, the shrinking of failures, the flag that it blames.
#include "failure.hpp"
#include "shrink.hpp"
#include "which_flag.hpp"

#include <graze/solve.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace suite_test {

// Decimal numbers of three digits, with only the operations that these tests need.
struct decimal {
    double value = 0;
    decimal() = default;
    explicit decimal(int i) : value(i) {}
    friend decimal operator+(decimal x, decimal) { return x; }
    friend decimal operator-(decimal x, decimal) { return x; }
    friend decimal operator*(decimal x, decimal) { return x; }
    decimal operator-() const { return *this; }
};

} // namespace suite_test

template <>
struct graze::number_traits<suite_test::decimal> {
    static constexpr const char* name = "decimal";
    static constexpr bool is_exact = false;
    static constexpr int digits = 7;
    static int sign(suite_test::decimal x) { return x.value < 0 ? -1 : x.value > 0; }
};
template <>
struct std::numeric_limits<suite_test::decimal> {
    static constexpr bool is_specialized = true;
    static constexpr int radix = 10, digits10 = 3;
};
template <>
struct graze::precision::number_access<suite_test::decimal> {
    static suite_test::decimal from(double x) {
        suite_test::decimal d;
        d.value = x;
        return d;
    }
    static reading read(suite_test::decimal d) { return {{std::round(d.value * 1000)}, 0, -3}; }
};

namespace {

using graze::precision::answer;
using graze::precision::quantity;
using precision::any_pair;
using precision::pair;
using suite_test::decimal;

// Answers that D is 16 plus this many quarters of its unit in the last place, 2^-48.
template <int Quarters>
struct beside_16 {
    static constexpr const char* name = "beside";
    static constexpr quantity measures = quantity::discriminant;
    template <int N>
    answer operator()(const graze::ball<N, double>&, const graze::ball<N, double>&) const {
        answer a = graze::precision::answered(quantity::discriminant, 16.0);
        a.values.front().components.front().parts.push_back(Quarters * 0x1p-50);
        return a;
    }
};

// Answers that D is this many thousandths.
template <int Thousandths>
struct thousandths {
    static constexpr const char* name = "thousandths";
    static constexpr quantity measures = quantity::discriminant;
    template <int N>
    answer operator()(const graze::ball<N, decimal>&, const graze::ball<N, decimal>&) const {
        answer a;
        a.values.push_back({quantity::discriminant, {{{static_cast<double>(Thousandths)}, 0, -3}}});
        return a;
    }
};

const pair<2> straight_on{{{-5, 0}, {1, 0}, 1}, graze::ball<2>{{0, 0}, {0, 0}, 3}}; // D = |du|² R² = 16

template <int Quarters>
precision::verdict judged() {
    graze::precision::subjects list;
    graze::precision::add<beside_16<Quarters>, double>(list);
    return precision::judge_one(*list.front(), quantity::discriminant, straight_on).value();
}

} // namespace

TEST_CASE("errors are fractions of a unit in the last place") {
    CHECK(judged<0>().largest() == 0);
    CHECK(judged<1>().largest() == 0.25);
    CHECK(judged<-2>().largest() == 0.5);
    CHECK(judged<2>().misrounded == 0);
    CHECK(judged<3>().largest() == 0.75);
    CHECK(judged<3>().misrounded == 1);
    CHECK_FALSE(judged<3>().wrong);
}

TEST_CASE("a decimal type is judged on what it holds, in its own unit") {
    // D = |du|² R²: 16 (1/10)², exactly 160 thousandths; 0.1 as a double is another number.
    const pair<2> slow{{{-5, 0}, {0.1, 0}, 1}, graze::ball<2>{{0, 0}, {0, 0}, 3}};
    const auto error = [&]<int Digits>(std::integral_constant<int, Digits>) {
        graze::precision::subjects list;
        graze::precision::add<thousandths<Digits>, decimal>(list);
        const auto v = precision::judge_one(*list.front(), quantity::discriminant, slow).value();
        CHECK(v.misrounded == (v.largest() > 0.5 ? 1 : 0));
        return v.largest();
    };
    CHECK(error(std::integral_constant<int, 160>{}) == 0);
    CHECK(error(std::integral_constant<int, 161>{}) == 1); // the unit of 0.160 with three digits is 0.001
    CHECK(error(std::integral_constant<int, 155>{}) == 5);
}

TEST_CASE("each figure that gates is compared, and the median is not") {
    const precision::figures before{100, 1, 50, 10, 2.0, 0.5, false, {}, {}, {}};
    const auto lost = [&](auto change) {
        precision::figures now = before;
        change(now);
        return precision::losses(now, before).size();
    };
    CHECK(lost([](auto&) {}) == 0);
    CHECK(lost([](auto& f) { ++f.wrong; }) == 1);
    CHECK(lost([](auto& f) { ++f.misrounded; }) == 1);
    CHECK(lost([](auto& f) { f.values = 40; }) == 1); // the same number, of fewer values
    CHECK(lost([](auto& f) { f.largest = 2.001; }) == 1);
    CHECK(lost([](auto& f) { --f.pairs; }) == 1);
    CHECK(lost([](auto& f) { f.median = 1; }) == 0);
    CHECK(lost([](auto& f) { f.wrong = 0, f.misrounded = 0, f.largest = 0; }) == 0);
}

namespace {

// A solution whose times are twice as large as they should be, and a discriminant that takes only the motion.
struct late_solution {
    static constexpr const char* name = "late";
    static constexpr auto measures = quantity::time;
    template <int N, class T>
    graze::ball_solution<N, T> operator()(const graze::ball<N, T>& a, const graze::ball<N, T>& b) const {
        auto s = graze::solve(a, b);
        s.time = s.time + s.time;
        return s;
    }
};
struct discriminant_of_motion {
    static constexpr const char* name = "motion";
    static constexpr auto measures = quantity::discriminant;
    template <int N, class T>
    T operator()(const graze::relative_motion<N, T, T, T>& m) const {
        return graze::discriminant_lagrange{}(m);
    }
};

struct odd : discriminant_of_motion {
    static constexpr const char* name = "#h² - a/c !";
};

} // namespace

TEST_CASE("a formula may return what solve does, or be a discriminant of the motion") {
    graze::precision::subjects list;
    graze::precision::add<late_solution, double>(list);
    graze::precision::add<discriminant_of_motion, double>(list);
    const pair<2> p{{{0, 0}, {1, 0}, 1}, graze::ball<2>{{9, 0}, {0, 0}, 1}}; // τ = 7; h = -9, a = 1, c = 77
    const auto late = (*list[0])(p), discriminant = (*list[1])(p);
    REQUIRE(late);
    CHECK(late->what == graze::encounter::hit);
    REQUIRE(late->values.size() == 6);
    CHECK(late->values[0].of == quantity::time);
    CHECK(late->values[0].components[0].parts[0] == 14);
    CHECK(late->values[1].components[0].parts[0] == 7); // of ball a, which is there at that time
    REQUIRE(discriminant);
    CHECK_FALSE(discriminant->what);
    REQUIRE(discriminant->values.size() == 1);
    CHECK(discriminant->values[0].components[0].parts[0] == 4);
    CHECK_FALSE((*list[1])(pair<2>{{{0, 0}, {1, 0}, 1}, graze::plane<2>{{9, 0}, {1, 0}}}));
}

TEST_CASE("whatever a formula is called, its figures are read as they were written") {
    graze::precision::subjects list;
    graze::precision::add<odd, double>(list);
    CHECK(list[0]->variant == "_h²_-_a_c__");
    CHECK(graze::precision::word_of("") == "_");
    CHECK(graze::precision::word_of("lagrange.stable") == "lagrange.stable");
}

TEST_CASE("two formulas of one name are refused") {
    const precision::plan some{{{"some", {pair<2>{{{0, 0}, {1, 0}, 1}, graze::ball<2>{{9, 0}, {0, 0}, 1}}}}}};
    graze::precision::subjects list;
    graze::precision::add<discriminant_of_motion, double>(list);
    graze::precision::add<odd, double>(list);
    CHECK(precision::measure(list, some).size() == 2);
    list.back()->variant = list.front()->variant;
    CHECK_THROWS_WITH_AS(static_cast<void>(precision::measure(list, some)),
                         doctest::Contains("two formulas are called"), std::runtime_error);
}

TEST_CASE("two number types of one name are refused") {
    graze::precision::subjects list;
    graze::precision::add<discriminant_of_motion, double>(list);
    graze::precision::add<odd, double>(list);
    CHECK_NOTHROW(static_cast<void>(precision::measure(list, {})));
    graze::precision::add<discriminant_of_motion, float>(list);
    list.back()->type.name = "double";
    CHECK_THROWS_WITH_AS(static_cast<void>(precision::measure(list, {})),
                         doctest::Contains("two number types are called double"), std::runtime_error);
}

TEST_CASE("what shrinks keeps showing the loss") {
    const any_pair large = pair<2>{{{5.75, -3.3}, {0.1, 7}, 0.3}, graze::plane<2>{{1, 2}, {3, 4}}};
    const any_pair small = precision::shrunk(large, [](const any_pair& p) {
        return precision::is_valid(std::get<0>(p)) && std::get<0>(p).a.velocity[1] >= 5;
    });
    const auto numbers = precision::numbers_of(std::get<0>(small));
    CHECK(std::count(numbers.begin(), numbers.end(), 0.0) >= 7);
    CHECK(std::get<0>(small).a.velocity[1] >= 5);
}

TEST_CASE("a line is the pair that it tells of") {
    const any_pair p = pair<3>{{{0x1p-1074, -0.0, 0.1}, {1e300, 2, 3}, 0.5, std::numeric_limits<double>::infinity()},
                               graze::wall<3>{{1, 2, 3}, {{{1, 0, 0}, {0, 1, 0}}}}};
    const any_pair again = precision::from_line(precision::to_line(p));
    CHECK(precision::numbers_of(std::get<1>(again)) == precision::numbers_of(std::get<1>(p)));
    const any_pair t =
        pair<3>{{{1, 1, 5}, {0, 0, -1}, 1}, graze::triangle<double>{{1, 2, 3}, {{{1, 0, 0}, {0, 1, 0}}}}};
    const any_pair t_again = precision::from_line(precision::to_line(t));
    CHECK(std::holds_alternative<graze::triangle<double>>(std::get<1>(t_again).other));
    CHECK(precision::numbers_of(std::get<1>(t_again)) == precision::numbers_of(std::get<1>(t)));
}

TEST_CASE("the flag is blamed that all losing sets have and no other") {
    const auto write = [](const char* name, const std::string& text) {
        std::ofstream(name) << text;
        return std::filesystem::path(name);
    };
    const auto strict = write("strict.txt", "flags -O2 -g\nmeasured 3\n");
    const auto fast = write("fast.txt", "flags -O2 -ffast-math\nmeasured 3\nlost time/a/double/far\n");
    const auto both = write("both.txt", "flags -O3 -ffast-math -g\nmeasured 3\nlost time/a/double/far\n");
    std::ostringstream out;
    using precision::flag_verdict;
    CHECK(precision::which_flag({strict, fast, both}, out) == flag_verdict::lost);
    CHECK(out.str() == "lost by -ffast-math: 1 figures, such as time/a/double/far\n");
    CHECK(precision::which_flag({strict}, out) == flag_verdict::nothing_lost);
    const auto unknown = write("unknown.txt", "flags -O0\nmeasured 3\nunaccepted 3\n");
    std::ostringstream of_unknown;
    CHECK(precision::which_flag({strict, unknown}, of_unknown) == flag_verdict::unaccepted);
    CHECK(of_unknown.str() == "figures that nobody has accepted yet, with [-O0]\n");
    CHECK(precision::which_flag({unknown, fast}, out) == flag_verdict::lost);
    CHECK_THROWS_AS(precision::which_flag({"none.txt"}, out), std::runtime_error);
}
