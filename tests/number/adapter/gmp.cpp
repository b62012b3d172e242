#include "adapter.hpp"

#include <graze/number/adapter/gmp.hpp>

using adapter::kind;

static_assert(adapter::satisfies<graze::gmp_rational, kind::exact_field, false, false>());
static_assert(!graze::number<mpq_class>);

// mpq_class's expression templates are no number_value, so no formula can return one.
static_assert(!graze::number_value<decltype(mpq_class() + mpq_class())>);
static_assert(std::is_same_v<decltype(graze::gmp_rational() + graze::gmp_rational()), graze::gmp_rational>);

TEST_CASE("mpq_class in its wrapper") {
    adapter::check<graze::gmp_rational>("mpq_class");
    using graze::gmp_rational;
    const gmp_rational third = gmp_rational(1) / gmp_rational(3);
    CHECK(third * gmp_rational(3) == gmp_rational(1));
    CHECK(third < gmp_rational(0.34));
    CHECK(gmp_rational(0.1) != gmp_rational(1) / gmp_rational(10)); // a double keeps its exact value
    CHECK(gmp_rational(mpq_class(-2, 7)).value() == mpq_class(-2, 7));
    gmp_rational x(1);
    x += third;
    x *= gmp_rational(3);
    x -= gmp_rational(1);
    x /= gmp_rational(2);
    CHECK(x == gmp_rational(3) / gmp_rational(2));
    CHECK((x <=> third) == std::strong_ordering::greater);
}
