// A batch gives the same answer about every pair as the scalar functions, in whatever form the balls are given. For
// some of the pairs the oracle is asked, too.
#include "../oracle/encounter.hpp"
#include "../property.hpp"
#include "../soak/more_families.hpp"
#include "batch_pairs.hpp"

#include <graze/classify.hpp>
#include <graze/overlaps.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string>

namespace {

using graze::encounter;

// std::vector<bool> holds no bools.
class bools {
  public:
    explicit bools(std::size_t size) : first_(std::make_unique<bool[]>(size)), size_(size) {}
    [[nodiscard]] std::span<bool> all() { return {first_.get(), size_}; }

  private:
    std::unique_ptr<bool[]> first_;
    std::size_t size_;
};

// In the widest registers of graze::compiled, and in those of this unit alone, as without graze::compiled.
template <class A, class B>
std::vector<encounter> classified(const A& a, const B& b, std::size_t size) {
    std::vector<encounter> what(size, encounter{-1});
    graze::batch::classify(a, b, what);
    std::vector<encounter> alone(size, encounter{-1});
    using question = graze::detail::batch_classify;
    graze::detail::decide_all<question, graze::detail::unit_mode, 0>(graze::detail::source_of(a),
                                                                     graze::detail::source_of(b), alone);
    CHECK(alone == what);
    return what;
}
template <class A, class B>
std::vector<int> overlapping(const A& a, const B& b, std::size_t size) {
    bools inside(size), alone(size);
    graze::batch::overlaps(a, b, inside.all());
    using question = graze::detail::batch_overlaps;
    graze::detail::decide_all<question, graze::detail::unit_mode, 0>(graze::detail::source_of(a),
                                                                     graze::detail::source_of(b), alone.all());
    CHECK(std::equal(alone.all().begin(), alone.all().end(), inside.all().begin()));
    return {inside.all().begin(), inside.all().end()};
}

template <class A, class F>
auto one_by_one(const A& a, F f) {
    std::vector<decltype(f(std::size_t{0}))> r;
    for (std::size_t i = 0; i < a.size(); ++i) {
        r.push_back(f(i));
    }
    return r;
}

// In every form in which balls can be given.
template <int N, class T>
void check_balls(const batches::pairs<N, T>& p) {
    const auto& a = p.a.all();
    const auto& b = p.b.all();
    const auto ca = p.a.columns(), cb = p.b.columns();
    const auto what = one_by_one(a, [&](std::size_t i) { return graze::classify(a[i], b[i]); });
    CHECK(classified(ca, cb, a.size()) == what);
    CHECK(classified(a, b, a.size()) == what);
    CHECK(classified(ca, b, a.size()) == what);
    CHECK(classified(a, cb, a.size()) == what);
    const auto inside = one_by_one(a, [&](std::size_t i) { return graze::overlaps(a[i], b[i]) ? 1 : 0; });
    CHECK(overlapping(ca, cb, a.size()) == inside);
    CHECK(overlapping(a, b, a.size()) == inside);

    const auto with_one = one_by_one(a, [&](std::size_t i) { return graze::classify(a[i], b[0]); });
    CHECK(classified(ca, b[0], a.size()) == with_one);
    CHECK(classified(std::span(a), b[0], a.size()) == with_one);
    CHECK(overlapping(ca, b[0], a.size()) ==
          one_by_one(a, [&](std::size_t i) { return graze::overlaps(a[i], b[0]) ? 1 : 0; }));
}

template <int N, class T>
void check_types() {
    check_balls(batches::draw<N, T>(1, 25'000, 60, batches::units::own));
    check_balls(batches::draw<N, T>(2, 4'000, 32, batches::units::any));
    check_balls(batches::draw<N, T>(3, 4'000, 0, batches::units::own));
    for (std::size_t size = 0; size < 40; ++size) {
        check_balls(batches::draw<N, T>(4 + size, size + 1, 32, batches::units::own));
    }
}

// Balls against one plane, wall or triangle.
template <int N, class T, class Shape>
void check_shape(const batches::many_balls<N, T>& balls, const Shape& shape) {
    const auto& a = balls.all();
    const auto what = one_by_one(a, [&](std::size_t i) { return graze::classify(a[i], shape); });
    CHECK(classified(balls.columns(), shape, a.size()) == what);
    CHECK(classified(a, shape, a.size()) == what);
    const auto inside = one_by_one(a, [&](std::size_t i) { return graze::overlaps(a[i], shape) ? 1 : 0; });
    CHECK(overlapping(balls.columns(), shape, a.size()) == inside);
    CHECK(overlapping(a, shape, a.size()) == inside);
}

template <int N, class T, class Shape>
void check_beside(const families::pair_of_doubles<N>& drawn, const Shape& shape, std::uint64_t seed) {
    const auto balls = batches::balls_beside<N, T>(drawn, seed, 19);
    const auto rounded = batches::in_type<T>(shape);
    const auto& all = balls.all();
    if (std::all_of(all.begin(), all.end(), [&](const auto& b) { return batches::is_accepted(b, rounded); })) {
        check_shape(balls, rounded);
    }
}

// Centres in the plane, or velocities along it, except for rounding: the signs of w·n and u·n are then those of
// rounding errors.
template <int N, class T>
void check_in_plane() {
    families::random random(11);
    const auto number = [&random] { return static_cast<T>(random.signed_bits(50)) * T(0x1p-50); };
    for (int trial = 0; trial < 20; ++trial) {
        graze::plane<N, T> p{};
        for (int k = 0; k < N; ++k) {
            p.point[k] = number();
            p.normal[k] = number();
        }
        const auto along = [&] {
            graze::vec<N, T> v{};
            const T size = number();
            v[0] = -p.normal[1] * size;
            v[1] = p.normal[0] * size;
            return v;
        };
        batches::many_balls<N, T> balls;
        for (int i = 0; i < 64; ++i) {
            graze::ball<N, T> b{along(), along(), T(0.01)};
            b.position = p.point + b.position;
            if (i % 3 != 0) {
                (i % 3 == 1 ? b.position : b.velocity)[0] = number();
            }
            balls.add(b);
        }
        check_shape(balls, p);
    }
}

// Balls in their own units and in any units, against planes, walls and triangles of several sizes.
template <int N, class T>
void check_units() {
    const auto own = batches::draw<N, T>(5, 2'000, 64, batches::units::own);
    const auto any = batches::draw<N, T>(6, 2'000, 64, batches::units::any);
    for (const int power : {0, 1, -12, 30, -60}) {
        const auto size = static_cast<T>(std::ldexp(1.0, power));
        graze::plane<N, T> p{};
        graze::wall<N, T> w{};
        for (int k = 0; k < N; ++k) {
            p.point[k] = T(0.25) * static_cast<T>(k + 1);
            p.normal[k] = size / static_cast<T>(2 - k * k);
            w.corner[k] = T(-0.5) * size;
            for (std::size_t e = 0; e < w.edge.size(); ++e) {
                w.edge[e][k] = size * (static_cast<int>(e) == k ? T(1) : T(0.125));
            }
        }
        check_shape(own.a, p);
        check_shape(any.a, p);
        check_shape(own.a, w);
        check_shape(any.a, w);
        if constexpr (N == 3) {
            const graze::triangle<T> t{w.corner, w.edge};
            check_shape(own.a, t);
            check_shape(any.a, t);
        }
    }
}

template <int N, class T>
std::vector<graze::ball<N, T>> whole_balls(std::uint64_t seed, std::size_t count) {
    families::random r(seed);
    std::vector<graze::ball<N, T>> balls(count);
    for (auto& b : balls) {
        for (int k = 0; k < N; ++k) {
            b.position[k] = static_cast<T>(r.in(-20, 20));
            b.velocity[k] = static_cast<T>(r.in(-5, 5));
        }
        b.radius = static_cast<T>(r.in(0, 5));
    }
    return balls;
}

// The message that f throws.
template <class Error, class F>
std::string message_of(F f) {
    try {
        f();
    } catch (const Error& e) {
        return e.what();
    }
    return "nothing";
}

} // namespace

TEST_CASE("A batch says what the scalar functions say, in double") {
    check_types<2, double>();
    check_types<3, double>();
}
TEST_CASE("A batch says what the scalar functions say, in float") {
    check_types<2, float>();
    check_types<3, float>();
}
TEST_CASE("A batch of integers says what the scalar functions say") {
    const auto a = whole_balls<3, std::int64_t>(1, 300), b = whole_balls<3, std::int64_t>(2, 300);
    CHECK(classified(a, b, 300) == one_by_one(a, [&](std::size_t i) { return graze::classify(a[i], b[i]); }));
    const auto c = whole_balls<2, std::int32_t>(1, 300), d = whole_balls<2, std::int32_t>(2, 300);
    CHECK(classified(c, d, 300) == one_by_one(c, [&](std::size_t i) { return graze::classify(c[i], d[i]); }));
}

TEST_CASE_TEMPLATE("Balls against a plane or a wall", dimension, std::integral_constant<int, 2>,
                   std::integral_constant<int, 3>) {
    constexpr int n = dimension::value;
    int planes = 0;
    const auto check_family = [&planes](const families::family& family) {
        for (std::uint64_t i = 0; i < 60; ++i) {
            const auto drawn = family.draw<n>(7, i);
            if (drawn.kind == families::pair_kind::ball_plane) {
                ++planes;
                check_beside<n, double>(drawn, drawn.plane, i);
                check_beside<n, float>(drawn, drawn.plane, i);
            } else if (drawn.kind == families::pair_kind::ball_wall && i < 20) {
                check_beside<n, double>(drawn, drawn.wall, i);
                check_beside<n, float>(drawn, drawn.wall, i);
            }
        }
    };
    std::for_each(families::all_families.begin(), families::all_families.end(), check_family);
    std::for_each(families::more_families.begin(), families::more_families.end(), check_family);
    CHECK(planes > 50);
    check_units<n, double>();
    check_units<n, float>();
    check_in_plane<n, double>();
    check_in_plane<n, float>();
}

TEST_CASE("The oracle says the same of hard pairs") {
    const auto p = batches::draw<3, double>(8, 1'500, 8, batches::units::own);
    const auto& a = p.a.all();
    const auto what = classified(p.a.columns(), p.b.columns(), a.size());
    const auto inside = overlapping(p.a.columns(), p.b.columns(), a.size());
    std::array<int, 5> seen{};
    for (std::size_t i = 0; i < a.size(); ++i) {
        const oracle::answer truth = oracle::meet(a[i], p.b.all()[i]);
        CHECK(static_cast<int>(what[i]) == static_cast<int>(truth.what));
        CHECK((inside[i] != 0) == truth.overlaps);
        ++seen[static_cast<std::size_t>(what[i])];
    }
    CHECK(*std::min_element(seen.begin(), seen.end()) > 0);
}

// No batch accepts what the scalar functions refuse or would convert.
template <class A, class B>
inline constexpr bool is_batch = requires(const A& a, const B& b, std::span<encounter> what) {
    graze::batch::classify(a, b, what);
};
template <int N, class T>
using balls = std::vector<graze::ball<N, T>>;
static_assert(is_batch<balls<2, double>, graze::columns<2>> &&
              is_batch<graze::columns<3, float>, graze::triangle<float>>);
static_assert(!is_batch<balls<2, double>, balls<2, float>> && !is_batch<balls<2, double>, graze::plane<3>>);
static_assert(!is_batch<balls<2, double>, graze::triangle<>> && !is_batch<balls<2, double>, graze::flight<2>>);
static_assert(!is_batch<balls<2, long double>, balls<2, long double>> && !is_batch<balls<2, short>, balls<2, short>>);

TEST_CASE("A part of columns is within them") {
    static constexpr std::array<int, 3> n{1, 2, 3};
    constexpr graze::columns<2, int> c{{n.data(), n.data()}, {n.data(), n.data()}, n.data(), n.size()};
    static_assert(c.part(1, 5).size == 2 && c.part(1, 1).size == 1 && *c.part(2, 9).radius == 3);
    static_assert(c.part(3, 1).size == 0 && c.part(4, 1).size == 0);
    CHECK(graze::columns<2>{}.part(1, 1).size == 0);
}

TEST_CASE("Laws of batches") {
    CHECK(property::check("14. Permutation: a permutation of the pairs permutes the answers", [] {
        const auto p = batches::draw<3, float>(property::any<std::uint64_t>(), property::in_range<std::size_t>(1, 600),
                                               32, batches::units::any);
        const std::size_t size = p.a.all().size();
        std::vector<std::size_t> order(size);
        std::iota(order.begin(), order.end(), std::size_t{0});
        families::random random(property::any<std::uint64_t>());
        for (std::size_t i = size; i > 1; --i) {
            std::swap(order[i - 1], order[random.below(i)]);
        }
        batches::pairs<3, float> q;
        for (const std::size_t i : order) {
            q.a.add(p.a.all()[i]);
            q.b.add(p.b.all()[i]);
        }
        const auto before = classified(p.a.columns(), p.b.columns(), size);
        const auto after = classified(q.a.columns(), q.b.columns(), size);
        for (std::size_t i = 0; i < size; ++i) {
            PROPERTY_ASSERT(after[i] == before[order[i]]);
        }
    }));
    CHECK(property::check("15. Parts: the answers of a part are that part of the answers", [] {
        const auto p = batches::draw<2, double>(property::any<std::uint64_t>(), property::in_range<std::size_t>(1, 600),
                                                32, batches::units::own);
        const std::size_t size = p.a.all().size();
        const auto first = property::in_range<std::size_t>(0, size);
        const auto count = property::in_range<std::size_t>(0, size - first);
        auto what = classified(p.a.all(), p.b.all(), size);
        const auto whole = what;
        std::fill(what.begin() + static_cast<std::ptrdiff_t>(first),
                  what.begin() + static_cast<std::ptrdiff_t>(first + count), encounter{-1});
        graze::batch::classify(p.a.columns().part(first, count), std::span(p.b.all()).subspan(first, count),
                               std::span(what).subspan(first, count));
        PROPERTY_ASSERT(what == whole);
    }));
}

TEST_CASE("Bad input is told with its pair, and what comes before it is written") {
    auto p = batches::draw<3, double>(9, 1'000, 60, batches::units::own);
    auto a = p.a.all();
    const auto& b = p.b.all();
    const auto good = classified(a, b, a.size());
    using limits = std::numeric_limits<double>;
    for (const std::size_t at : {0U, 1U, 255U, 256U, 700U, 999U}) {
        const auto check = [&](const std::string& expected) {
            std::vector<encounter> what(a.size(), encounter{-1});
            CHECK(message_of<std::domain_error>([&] { graze::batch::classify(a, b, what); }) ==
                  "pair " + std::to_string(at) + ": " + expected);
            CHECK(std::equal(what.begin(), what.begin() + static_cast<std::ptrdiff_t>(at), good.begin()));
            bools inside(a.size());
            CHECK(message_of<std::domain_error>([&] { graze::batch::overlaps(a, b, inside.all()); }) ==
                  "pair " + std::to_string(at) + ": " + expected);
        };
        const auto whole = a[at];
        a[at].position[2] = limits::quiet_NaN();
        check("ball a: position is not finite");
        a[at] = whole;
        a[at].velocity[0] = limits::infinity();
        check("ball a: velocity is not finite");
        a[at] = whole;
        a[at].radius = -1e-300;
        check("ball a: radius is negative");
        a[at] = whole;
    }
    std::vector<encounter> what(a.size());
    const graze::plane<3> no_plane{};
    CHECK(message_of<std::domain_error>([&] { graze::batch::classify(a, no_plane, what); }) ==
          "pair 0: plane: normal is zero");
    const graze::wall<3> no_wall{{}, {{{1, 2, 3}, {2, 4, 6}}}};
    CHECK(message_of<std::domain_error>([&] { graze::batch::classify(a, no_wall, what); }) ==
          "pair 0: wall: edges are parallel");
}

TEST_CASE("Sizes that differ are an error before anything is written") {
    const auto p = batches::draw<2, double>(10, 20, 64, batches::units::own);
    const auto a = std::span(p.a.all());
    for (const auto& [size_a, size_b, answers] : {std::array{19, 20, 20}, {20, 19, 20}, {20, 20, 19}, {19, 20, 19}}) {
        std::vector<encounter> what(static_cast<std::size_t>(answers), encounter{-1});
        CHECK(message_of<std::invalid_argument>([&, m = size_a, n = size_b] {
                  graze::batch::classify(a.first(static_cast<std::size_t>(m)),
                                         p.b.columns().part(0, static_cast<std::size_t>(n)), what);
              }) != "nothing");
        CHECK(std::count(what.begin(), what.end(), encounter{-1}) == answers);
    }
}
