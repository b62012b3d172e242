// Number types of CGAL: Gmpq, Lazy_exact_nt, Interval_nt and CORE::Expr (link gmp and mpfr; compile with
// -frounding-math, as CGAL does).
//
// CGAL::Exact_rational is an alias. In CGAL 5.5 with GMP it is Boost's mpq_rational with expression templates on, which
// is no graze::number: use its et_off form with number/adapter/boost.hpp. Inside a Lazy_exact_nt it works as it is.
#pragma once

#include <graze/number/traits.hpp>

#include <CGAL/CORE_Expr.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Lazy_exact_nt.h>

namespace graze::inline v0_1 {

template <>
struct number_traits<CGAL::Gmpq> {
    static constexpr const char* name = "CGAL::Gmpq";
    static constexpr bool is_exact = true;
    static constexpr int digits = 0;
    static int sign(const CGAL::Gmpq& x) { return static_cast<int>(x.sign()); }
};

// An interval first; the exact type if the interval leaves a comparison open. A value keeps the expression that made
// it, so memory grows with the length of a computation. Reading a value may change it: two threads must not share one.
template <class Exact>
struct number_traits<CGAL::Lazy_exact_nt<Exact>> {
    static constexpr const char* name = "CGAL::Lazy_exact_nt";
    static constexpr bool is_exact = true;
    static constexpr int digits = 0;
    static int sign(const CGAL::Lazy_exact_nt<Exact>& x) { return static_cast<int>(CGAL::sign(x)); }
};

// Two doubles that enclose the value. sign throws CGAL::Uncertain_conversion_exception if both signs, or one sign and
// zero, are possible; so does a comparison when its result is used. Interval_nt<false> needs upward rounding while it
// is used (CGAL::Protect_FPU_rounding).
template <bool Protected>
struct number_traits<CGAL::Interval_nt<Protected>> {
    static constexpr const char* name = Protected ? "CGAL::Interval_nt" : "CGAL::Interval_nt<false>";
    static constexpr bool is_exact = false;
    static constexpr int digits = std::numeric_limits<double>::digits;
    static int sign(const CGAL::Interval_nt<Protected>& x) { return static_cast<int>(CGAL::sign(x).make_certain()); }
    static CGAL::Interval_nt<Protected> sqrt(const CGAL::Interval_nt<Protected>& x) { return CGAL::sqrt(x); }
};

// Exact, with square roots: a sign is computed to as many digits as a separation bound requires. Like a Lazy_exact_nt,
// a value keeps its expression, and two threads must not share one.
template <>
struct number_traits<CORE::Expr> {
    static constexpr const char* name = "CORE::Expr";
    static constexpr bool is_exact = true;
    static constexpr int digits = 0;
    static int sign(const CORE::Expr& x) { return x.sign(); }
    static CORE::Expr sqrt(const CORE::Expr& x) { return CORE::sqrt(x); }
};

} // namespace graze::inline v0_1
