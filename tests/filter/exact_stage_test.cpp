// The integers in which a formula runs are as wide as its inputs need, and hold their values exactly.
#include <graze/filter/exact_stage.hpp>
#include <graze/formula/quadratic.hpp>
#include <graze/pair/pair.hpp>

#include <doctest/doctest.h>
#include <gmpxx.h>

#include <cmath>
#include <limits>

namespace {

using ball = graze::ball<2, double>;

mpz_class value(const graze::detail::big_integer& x) {
    mpz_class sum;
    for (int i = 0; i < x.count(); ++i) {
        sum += mpz_class(static_cast<long>(x.digit(i))) << static_cast<unsigned long>(64 * (x.low() + i));
    }
    return x.is_negated() ? mpz_class(-sum) : sum;
}

struct seen {
    int width; // of the lifted inputs
    mpq_class dx, du, R;
};

mpq_class scaled(const mpz_class& x, int exponent) {
    const mpz_class power = mpz_class(1) << static_cast<unsigned long>(std::abs(exponent));
    return exponent < 0 ? mpq_class(x, power) : mpq_class(x * power);
}

// Two balls in the exact stage: the first component of each difference, and R.
seen look(const ball& a, const ball& b) {
    using pair = graze::detail::two_balls<2>;
    const auto in = graze::detail::lift_row<pair>(graze::detail::packed<pair>(a, b));
    return graze::detail::with_exact_motion<pair>(in, [&](const auto& m) {
        seen s{in.width(), scaled(value(m.dx[0]), in.length.exponent), scaled(value(m.du[0]), in.velocity.exponent),
               scaled(value(m.R), in.length.exponent)};
        s.dx.canonicalize();
        s.du.canonicalize();
        s.R.canonicalize();
        return s;
    });
}

void check(const ball& a, const ball& b, int width) {
    const seen s = look(a, b);
    CHECK(s.width == width);
    CHECK(s.dx == mpq_class(a.position[0]) - mpq_class(b.position[0]));
    CHECK(s.du == mpq_class(a.velocity[0]) - mpq_class(b.velocity[0]));
    CHECK(s.R == mpq_class(a.radius) + mpq_class(b.radius));
}

constexpr ball rest{{0, 0}, {0, 0}, 1};

} // namespace

TEST_CASE("Integers are as wide as the spread of the inputs' bits") {
    check({{5, 1}, {-1, 0}, 1}, rest, 5); // zeros that all numbers share do not count
    check({{0x1.fffffffffffffp7, 1}, {-1, 0}, 1}, rest, 60);
    check({{0x1.fffffffffffffp60, 0x1.fffffffffffffp0}, {-1, 0}, 1}, rest, 113);
    check({{1, 1}, {0x1.fffffffffffffp75, 0x1.fffffffffffffp0}, 1}, rest, 128);
    const double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
    check({{most, least}, {-most, least}, most}, {{-most, -least}, {most, -least}, most}, graze::detail::full_width);
}

TEST_CASE("Zeros have no exponent and subnormals are as wide as they may be") {
    check({{0x1p1000, 0}, {0x1p-1000, 0}, 0}, {{0, 0x1p990}, {0, 0}, 0}, 11);
    check({{0x1p-1074, 0}, {0x1p1023, 0}, 0}, {{0x1p-1070, 0}, {0, -0.0}, 0}, 53);
    check({{0, 0}, {0, 0}, 0}, {{0, 0}, {0, 0}, 0}, 0);
}
