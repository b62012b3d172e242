// The filter's constants, as the compiler derives them from the formulas.
#include <graze/analysis/error_bound.hpp>
#include <graze/formula/discriminant.hpp>

namespace {

using namespace graze;

template <int N>
constexpr auto exact_motion() {
    return relative_motion{bounded_vector<N>(error_bound::exact_input({1, 0, 0})),
                           bounded_vector<N>(error_bound::exact_input({0, 1, 0})), error_bound::exact_input({1, 0, 0})};
}

// N products of exact inputs: N roundings each.
static_assert(coefficient_h{}(exact_motion<2>()).error >= 2 && coefficient_h{}(exact_motion<2>()).error < 2.0001);
static_assert(coefficient_h{}(exact_motion<3>()).error >= 3 && coefficient_h{}(exact_motion<3>()).error < 3.0001);

// Degrees are dimensions: D is length²·velocity².
static_assert(discriminant_halved{}(quadratic_of(exact_motion<3>())).degree == error_bound::degrees{2, 2, 0});
static_assert(discriminant_lagrange{}(exact_motion<3>()).degree == error_bound::degrees{2, 2, 0});

// Lagrange's form is the tighter one, in the plane and in space.
static_assert(discriminant_lagrange{}(exact_motion<2>()).error <
              discriminant_halved{}(quadratic_of(exact_motion<2>())).error);
static_assert(discriminant_lagrange{}(exact_motion<3>()).error <
              discriminant_halved{}(quadratic_of(exact_motion<3>())).error);

} // namespace
