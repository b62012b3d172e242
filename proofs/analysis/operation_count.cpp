// The costs of formulas, counted at compile time.
#include <graze/analysis/operation_count.hpp>
#include <graze/formula/discriminant.hpp>
#include <graze/formula/roots.hpp>

namespace {

using namespace graze;

template <int N>
constexpr auto motion(const counted_number& x) {
    const auto vector = make_vec<N>([&](int) { return x; });
    return relative_motion{vector, vector, x};
}

constexpr operation_count lagrange =
    operations_of([](const counted_number& x) { return discriminant_lagrange{}(motion<3>(x)); });
constexpr operation_count halved =
    operations_of([](const counted_number& x) { return discriminant_halved{}(quadratic_of(motion<3>(x))); });
constexpr operation_count kahan = operations_of([](const counted_number& x) {
    return discriminant_kahan{}(quadratic{x, x, x});
});
constexpr operation_count stable =
    operations_of([](const counted_number& x) { return root_stable{}(x, x, square_root(x)); });

// R²: 1, |Δu|²: 3 and 2, their product: 1, a cross product: 6 and 3, its square: 3 and 2, the difference: 1.
static_assert(lagrange == operation_count{.sums = 8, .products = 14});
// Three inner products: 9 and 6, R² and a difference, h², ac and a difference.
static_assert(halved == operation_count{.sums = 8, .products = 12});
// A product, two fused multiply-adds and a sum.
static_assert(kahan == operation_count{.sums = 1, .products = 1, .fused = 2});
static_assert(stable == operation_count{.sums = 1, .quotients = 1, .roots = 1});

// A value used twice is computed once. Constants cost nothing; operations with them do.
static_assert(operations_of([](const counted_number& x) {
                  const auto y = x * x;
                  return y + y;
              }) == operation_count{.sums = 1, .products = 1});
static_assert(operations_of([](const counted_number& x) { return counted_number(1) / x; }) ==
              operation_count{.quotients = 1});

} // namespace
