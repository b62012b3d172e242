// The filter's constants, as the compiler derives them from the formulas.
#include <graze/analysis/error_bound.hpp>
#include <graze/analysis/polynomial.hpp>
#include <graze/analysis/range_bound.hpp>
#include <graze/formula/discriminant.hpp>

#include "../variables.hpp"

namespace {

using namespace graze;

template <int N>
constexpr auto exact_motion() {
    return relative_motion{bounded_vector<N>(error_bound::exact_input({1, 0, 0})),
                           bounded_vector<N>(error_bound::exact_input({0, 1, 0})), error_bound::exact_input({1, 0, 0})};
}

// A sum of N products of exact inputs: at most N roundings each.
static_assert(coefficient_h{}(exact_motion<2>()).error >= 2 && coefficient_h{}(exact_motion<2>()).error < 2.0001);
static_assert(coefficient_h{}(exact_motion<3>()).error >= 3 && coefficient_h{}(exact_motion<3>()).error < 3.0001);

// Degrees are dimensions: D is length²·velocity².
static_assert(discriminant_halved{}(quadratic_of(exact_motion<3>())).degree == error_bound::degrees{2, 2, 0});
static_assert(discriminant_lagrange{}(exact_motion<3>()).degree == error_bound::degrees{2, 2, 0});

// Lagrange's form has the smaller bound, in the plane and in space.
static_assert(discriminant_lagrange{}(exact_motion<2>()).error <
              discriminant_halved{}(quadratic_of(exact_motion<2>())).error);
static_assert(discriminant_lagrange{}(exact_motion<3>()).error <
              discriminant_halved{}(quadratic_of(exact_motion<3>())).error);

// A norm is at most √N times the largest component m: N m² - |x|² = Σ (m - x_i)(m + x_i), no term of which is negative.
template <int N>
constexpr bool norm_by_components() {
    using letters = polynomial<>;
    const auto x = proof::vector<N, letters>(0);
    const letters m = proof::letter<letters>(N);
    letters sum(0);
    for (int i = 0; i < N; ++i) {
        sum = sum + (m - x[i]) * (m + x[i]);
    }
    return letters(N) * m * m - squared_norm(x) == sum;
}
static_assert(norm_by_components<2>() && norm_by_components<3>());

// For types with other numbers of bits, the constant is the same up to terms of second order.
template <int Digits>
constexpr double in_bits() {
    using bound = basic_error_bound<Digits>;
    return discriminant_lagrange{}(relative_motion{bounded_vector<3>(bound::exact_input({1, 0, 0})),
                                                   bounded_vector<3>(bound::exact_input({0, 1, 0})),
                                                   bound::exact_input({1, 0, 0})})
        .error;
}
static_assert(basic_error_bound<24>::unit == 0x1p-23 && basic_error_bound<336>::unit == 0x1p-335);
static_assert(in_bits<24>() > in_bits<53>() && in_bits<24>() < in_bits<53>() * (1 + 0x1p-18) &&
              in_bits<53>() >= in_bits<336>());

// A sign is certain if no error can change it.
template <class B>
constexpr int sign_of(double low, double high, double error) {
    return number_traits<B>::sign(B(low, high, error));
}
template <class F>
concept known = requires {
    typename std::integral_constant<int, F{}()>;
};
static_assert(sign_of<range_bound<>>(0.5, 1, 1000) == 1 && sign_of<range_bound<>>(-1, -0x1p-40, 4095) == -1);
static_assert(sign_of<range_bound<>>(0, 0, 0) == 0);
static_assert(known<decltype([] { return sign_of<range_bound<>>(0x1p-40, 1, 4095); })>);
static_assert(!known<decltype([] { return sign_of<range_bound<>>(0x1p-40, 1, 4096); })>);
static_assert(!known<decltype([] { return sign_of<range_bound<>>(-1, 1, 0); })>);
static_assert(!known<decltype([] { return sign_of<range_bound<>>(0, 1, 0); })>);
static_assert(!known<decltype([] { return sign_of<range_bound<>>(-1, 0, 0); })>);
static_assert(known<decltype([] { return sign_of<range_bound<>>(-1, -0x1p-40, 4095); })>);
static_assert(!known<decltype([] { return sign_of<range_bound<>>(-1, -0x1p-40, 4096); })>);
static_assert(!known<decltype([] { return sign_of<range_bound<>>(0, 0, 0.5); })>);

} // namespace
