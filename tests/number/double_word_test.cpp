// Error-free transforms and double words, compared with GMP: exact, or within the published bounds.
#include "adapter/adapter.hpp"

#include <graze/number/bounded_word.hpp>
#include <graze/number/double_word.hpp>
#include <graze/solve.hpp>

#include <families/random.hpp>

#include <gmpxx.h>

#include <cmath>

using graze::double_word;

static_assert(adapter::satisfies<double_word, adapter::kind::inexact_field, true, false>());

namespace {

mpq_class exact(double x) { return mpq_class(x); }
mpq_class exact(const double_word& x) { return exact(x.high()) + exact(x.low()); }

const mpq_class u(1, mpz_class(1) << 53);

// Significands with long runs of equal bits, or random; exponents near each other.
double draw(families::random& r) {
    auto significand = static_cast<std::int64_t>(r.next() >> 11U) | (std::int64_t{1} << 52);
    switch (r.below(4)) {
    case 0:
        significand = (std::int64_t{1} << 52) + r.in(0, 3);
        break;
    case 1:
        significand = (std::int64_t{1} << 53) - 1 - r.in(0, 3);
        break;
    case 2:
        significand = (std::int64_t{1} << 52) + (std::int64_t{1} << r.in(0, 52)) - r.in(0, 1);
        break;
    default:
        break;
    }
    const auto exponent = static_cast<int>(r.in(-60, -44));
    return std::ldexp(static_cast<double>(r.either_sign(significand)), exponent);
}

// With a low part of up to half a unit in the last place, ties included.
double_word draw_word(families::random& r) {
    const double high = draw(r);
    const double half = std::ldexp(1.0, std::ilogb(high) - 53);
    const double low = r.one_in(4) ? half : half * std::fabs(draw(r)) / 512; // draws are less than 2^9
    const double part = r.one_in(16) ? 0.0 : low;
    return double_word::sum(high, r.one_in(2) ? part : -part);
}

bool is_normal_form(const double_word& x) { return x.high() + x.low() == x.high(); }

// |x - truth| <= bound |truth|
bool is_within(const double_word& x, const mpq_class& truth, const mpq_class& bound) {
    return abs(exact(x) - truth) <= bound * abs(truth);
}

} // namespace

TEST_CASE("sums and products lose nothing") {
    for (std::uint64_t i = 0; i < 20000; ++i) {
        families::random r(1, i);
        const double a = draw(r);
        const auto shift = static_cast<int>(r.in(-70, 70));
        const double b = std::ldexp(draw(r), shift);
        const auto s = graze::two_sum(a, b);
        CHECK(s.value == a + b);
        CHECK(exact(s.value) + exact(s.error) == exact(a) + exact(b));
        const auto d = graze::two_difference(a, b);
        CHECK(exact(d.value) + exact(d.error) == exact(a) - exact(b));
        const auto f = std::fabs(a) < std::fabs(b) ? graze::fast_two_sum(b, a) : graze::fast_two_sum(a, b);
        CHECK(f.error == s.error);
        const auto p = graze::two_product(a, b);
        CHECK(p.value == a * b);
        CHECK(exact(p.value) + exact(p.error) == exact(a) * exact(b));
        const auto q = graze::two_square(graze::detail::as_factor(a));
        CHECK(exact(q.value) + exact(q.error) == exact(a) * exact(a));
        const auto h = graze::detail::veltkamp_split(a);
        CHECK(h.high + h.low == a);
        CHECK(std::ldexp(h.high, 25 - std::ilogb(a)) == std::nearbyint(std::ldexp(h.high, 25 - std::ilogb(a))));
    }
}

TEST_CASE("each operation keeps its published bound") {
    const mpq_class u2 = u * u;
    const mpq_class u3 = u2 * u;
    for (std::uint64_t i = 0; i < 20000; ++i) {
        families::random r(2, i);
        const double_word x = draw_word(r);
        double_word y = draw_word(r);
        if (r.one_in(4)) { // cancels nearly all of x
            y = double_word::sum(-x.high(), std::ldexp(draw(r), -53));
        }
        const mpq_class a = exact(x);
        const mpq_class b = exact(y);
        const double_word sum = x + y;
        CHECK(is_within(sum, a + b, 3 * u2 + 13 * u3));
        CHECK(is_within(x - y, a - b, 3 * u2 + 13 * u3));
        const double_word product = x * y;
        CHECK(is_within(product, a * b, 7 * u2));
        const double_word quotient = x / y;
        CHECK(is_within(quotient, a / b, 15 * u2 + 56 * u3));
        CHECK(exact(x.doubled()) == 2 * a);
        const double_word square = x * x;
        const mpq_class c = exact(square);
        const mpq_class root = exact(sqrt(square));
        const mpq_class bound = 25 * u2 / 8;
        CHECK(root * root <= (1 + bound) * (1 + bound) * c);
        CHECK(root * root >= (1 - bound) * (1 - bound) * c);
        CHECK((is_normal_form(sum) && is_normal_form(product) && is_normal_form(quotient)));
        CHECK(graze::sign(x) == sgn(a));
        CHECK((x < y) == (a < b));
    }
}

TEST_CASE("double words are numbers") {
    adapter::check<double_word>("double_word");
    adapter::check_root<double_word>(0x1.9p-105);
    CHECK(std::isnan(sqrt(double_word(-1)).high()));
    CHECK(sqrt(double_word(0)) == double_word(0));
}

TEST_CASE("constants are the same numbers") {
    constexpr double_word third = double_word(1) / double_word(3);
    constexpr double_word root = sqrt(double_word(2));
    static_assert(third.low() != 0 && root.low() != 0);
    const double_word one = 1, two = 2, three = 3;
    CHECK(third == one / three);
    CHECK(root == sqrt(two));
    constexpr auto product = double_word::product(0x1.921fb54442d18p1, 0x1.5bf0a8b145769p1);
    CHECK(product == double_word::product(0x1.921fb54442d18p1, 0x1.5bf0a8b145769p1));
}

TEST_CASE("bounded words know how wrong they can be") {
    using graze::detail::bounded_word;
    const auto holds = [](const bounded_word& x, const mpq_class& truth) {
        return std::isfinite(x.error()) && abs(exact(x.value()) - truth) <= exact(x.error());
    };
    const auto is_close = [](const bounded_word& x) { return x.error() <= 0x1p-80 * std::fabs(x.value().high()); };
    int close = 0;
    for (std::uint64_t i = 0; i < 20000; ++i) {
        families::random r(4, i);
        const double p = draw(r), q = draw(r), s = draw(r), t = draw(r);
        const auto a = bounded_word(p) - bounded_word(q);
        const mpq_class x = exact(p) - exact(q);
        const bounded_word b(s), c(t);
        const bounded_word sum = a * b + c;
        const mpq_class y = x * exact(s) + exact(t);
        CHECK(holds(sum, y));
        const bounded_word lost = sum - a * b - c; // cancels
        CHECK(holds(lost, 0));
        CHECK((lost.error() == 0 || !lost.has_certain_sign()));
        const bounded_word product = sum * sum;
        CHECK(holds(product, y * y));
        if (y != 0) {
            CHECK(holds(a / sum, x / y));
            CHECK(holds(c / product, exact(t) / (y * y)));
            const bounded_word root = sqrt(product);
            CHECK(holds(root, abs(y)));
            close += is_close(c / root) ? 1 : 0;
        }
        const bounded_word none = b * (c - c);
        CHECK(none.is_zero());
        // Results that are doubles have no error.
        const double small = std::floor(std::ldexp(s, 10)), other = std::floor(std::ldexp(std::fabs(t), 10)) + 1;
        CHECK((bounded_word(small) * bounded_word(other)).error() == 0);
        CHECK((bounded_word(small * other) / bounded_word(other)).error() == 0);
        CHECK(sqrt(bounded_word(other * other)).error() == 0);
        CHECK(holds(bounded_word(small) / bounded_word(other), exact(small) / exact(other)));
    }
    CHECK(close > 19000);
    CHECK(!std::isfinite((bounded_word(1) / bounded_word(0)).error()));
    CHECK(!std::isfinite(sqrt(bounded_word(-1)).error()));
}

// The formulas unchanged: |Δx + Δu τ| = R to 2^-95 of the lengths, where doubles only get to 2^-45.
TEST_CASE("solve runs in double words") {
    int hits = 0;
    for (std::uint64_t i = 0; i < 4000; ++i) {
        families::random r(3, i);
        const auto vector = [&](double size) {
            return graze::make_vec<3>([&](int) { return double_word(size * draw(r) / 256); });
        };
        graze::ball<3, double_word> a{vector(4), {}, 0};
        a.velocity = vector(1);
        a.radius = std::fabs(draw(r)) / 256;
        graze::ball<3, double_word> b{vector(0.1), {}, 1};
        b.velocity = vector(0.1);
        const auto s = graze::solve(a, b);
        if (s.what != graze::encounter::hit) {
            continue;
        }
        ++hits;
        const mpq_class tau = exact(s.time);
        mpq_class square = 0, scale = 0, momentum = 0, energy = 0;
        for (int k = 0; k < 3; ++k) {
            const mpq_class dx = exact(a.position[k]) - exact(b.position[k]);
            const mpq_class du = exact(a.velocity[k]) - exact(b.velocity[k]);
            square += (dx + du * tau) * (dx + du * tau);
            scale += dx * dx;
            const mpq_class va = exact(s.velocity_a[k]), vb = exact(s.velocity_b[k]);
            momentum += abs(va + vb - exact(a.velocity[k]) - exact(b.velocity[k]));
            energy += va * va + vb * vb - exact(a.velocity[k]) * exact(a.velocity[k]) -
                      exact(b.velocity[k]) * exact(b.velocity[k]);
        }
        const mpq_class R = exact(a.radius) + exact(b.radius);
        CHECK(abs(square - R * R) <= mpq_class(1, mpz_class(1) << 95) * scale);
        CHECK(momentum.get_d() < 0x1p-95);
        CHECK(std::fabs(energy.get_d()) < 0x1p-92);
    }
    CHECK(hits > 100);
}
