#include "adapter.hpp"

#include <graze/number/adapter/cgal.hpp>

#include <CGAL/Exact_rational.h>

using adapter::kind;

static_assert(adapter::satisfies<CGAL::Gmpq, kind::exact_field, false, false>());
static_assert(adapter::satisfies<CGAL::Lazy_exact_nt<CGAL::Gmpq>, kind::exact_field, false, false>());
static_assert(adapter::satisfies<CGAL::Lazy_exact_nt<CGAL::Exact_rational>, kind::exact_field, false, false>());
static_assert(adapter::satisfies<CGAL::Interval_nt<>, kind::inexact_field, true, false>());
static_assert(adapter::satisfies<CORE::Expr, kind::exact_field, true, false>());

// If CGAL uses Boost, this is Boost's rational with expression templates.
static_assert(!graze::number<CGAL::Exact_rational>);

TEST_CASE("CGAL's exact types") {
    adapter::check<CGAL::Gmpq>("CGAL::Gmpq");
    adapter::check<CGAL::Lazy_exact_nt<CGAL::Gmpq>>("CGAL::Lazy_exact_nt");
    adapter::check<CORE::Expr>("CORE::Expr");
    const CORE::Expr two(2), three(3), six(6);
    using graze::square_root;
    CHECK(square_root(two) * square_root(three) == square_root(six));
}

TEST_CASE("CGAL's interval says when it does not know a sign") {
    adapter::check<CGAL::Interval_nt<>>("CGAL::Interval_nt");
    using interval = CGAL::Interval_nt<>;
    const interval third = interval(1) / interval(3);
    CHECK(third.inf() < third.sup());
    CHECK(graze::sign(third) == 1);
    CHECK_THROWS_AS((void)graze::sign(third - third), CGAL::Uncertain_conversion_exception);
    const interval root = graze::square_root(interval(2));
    CHECK((root * root).inf() <= 2);
    CHECK((root * root).sup() >= 2);
}
