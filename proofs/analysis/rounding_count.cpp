// Roundings, counted at compile time, and the sizes of terms.
#include <graze/analysis/rounding_count.hpp>
#include <graze/formula/discriminant.hpp>

namespace {

using namespace graze;

template <int N, class V>
constexpr auto motion(const V& x) {
    const auto vector = make_vec<N>([&](int) { return x; });
    return relative_motion{vector, vector, x};
}
constexpr auto exact = rounding_count::exact_input();
constexpr auto rounded = rounding_count::rounded_input();

// A product, and two sums of three products.
static_assert(coefficient_h{}(motion<3>(exact)).total() == 3);
static_assert(coefficient_h{}(motion<2>(exact)).total() == 2);
// Six differences that may be multiplied out, one product, two sums.
static_assert(coefficient_h{}(motion<3>(rounded)).total() == 9);
// R R a takes two products beside that of a. Sums in the plane: that of a, the difference of Δx × Δu twice, since it is
// squared, and the last one.
static_assert(discriminant_lagrange{}(motion<2>(exact)).products == 3);
static_assert(discriminant_lagrange{}(motion<2>(exact)).sums == 4);

static_assert(exact.bound(0x1p-52) == 0);
static_assert(rounded.bound(0x1p-52) > 0x1p-52 && rounded.bound(0x1p-52) < 0x1.001p-52);
static_assert((exact * exact + exact).bound(0x1p-52) > 0x1p-51);

// 3·4 - 2·(-5) with all terms taken by magnitude: the signs do not matter.
static_assert((term_size(3) * term_size(-4) - term_size(2.0) * term_size(-5.0)).value == 22);
static_assert((-term_size(-3)).value == 3);

} // namespace
