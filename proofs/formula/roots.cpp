// The smaller root τ in Q(√D), as identities in a, h and S = √D. c stands for (h² - S²)/a, which loses no generality.
#include <graze/formula/discriminant.hpp>
#include <graze/formula/root_order.hpp>
#include <graze/formula/roots.hpp>

#include "../variables.hpp"

namespace {

using namespace graze;
using proof::letter;
using function = rational_function<>;

constexpr function a() { return letter<function>(0); }
constexpr function h() { return letter<function>(1); }
constexpr function S() { return letter<function>(2); }
constexpr function c() { return (h() * h() - S() * S()) / a(); }
constexpr function zero() { return function(0); }
constexpr quadratic<function, function, function> q() { return {a(), h(), c()}; }
constexpr function value(const function& t) { return a() * t * t + twice(h()) * t + c(); }

constexpr function tau() { return root_stable{}(c(), h(), S()); }

static_assert(discriminant_halved{}(q()) == S() * S());
static_assert(discriminant_textbook{}(q()) == twice(S()) * twice(S()));

// τ solves (10) in both forms, computed from D or from 4D.
static_assert(value(tau()) == zero());
static_assert(root_printed{}(a(), twice(h()), twice(S())) == tau());
static_assert(root_stable{}(twice(c()), twice(h()), twice(S())) == tau());

// It is the smaller root: the two roots add up to -2h/a, and the other root is later by 2√D/a.
static_assert([] {
    const function other = -twice(h()) / a() - tau();
    return value(other) == zero() && other - tau() == twice(S()) / a() && other * tau() == c() / a();
}());

// A graze's double root is the same where S = 0.
static_assert([] {
    const function c0 = h() * h() / a();
    return root_of_graze{}(a(), h()) == root_stable{}(c0, h(), zero()) &&
           a() * root_of_graze{}(a(), h()) * root_of_graze{}(a(), h()) + twice(h()) * root_of_graze{}(a(), h()) + c0 ==
               zero();
}());

// The slope at τ: h + aτ = -√D.
static_assert(h() + a() * tau() == -S());

// A time m = n/d against τ: the quadratic and half of its slope there, times d² and d.
static_assert([] {
    const function n = letter<function>(3);
    const function d = letter<function>(4);
    return value_at{}(q(), n, d) == value(n / d) * d * d && slope_at{}(q(), n, d) == (a() * (n / d) + h()) * d;
}());

} // namespace
