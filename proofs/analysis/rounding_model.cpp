// Compares each operation of error_bound and range_bound with the worst possible result: computed operands at the ends
// of their ranges, exact operands as far from them as allowed, the result rounded to either side. The types have so few
// bits that all of this is exact in doubles, including terms of second order.
#include <graze/analysis/error_bound.hpp>
#include <graze/analysis/polynomial.hpp>
#include <graze/analysis/range_bound.hpp>

#include "../variables.hpp"

#include <array>

namespace {

using namespace graze;

constexpr double magnitude(double x) { return x < 0 ? -x : x; }
constexpr double larger(double x, double y) { return x > y ? x : y; }
constexpr double noise = 1 + 0x1p-40; // allows for the rounding of quotients and roots, which are not exact here
// Whether `bound` holds for `worst`, the largest possible value, and exceeds it by no more than a factor.
constexpr bool bounds_closely(double bound, double worst, double factor) {
    return bound * noise >= worst && bound <= worst * factor * noise;
}
template <class F>
concept known = requires {
    typename std::integral_constant<int, F{}()>;
};

// ---- error_bound: |ẑ| <= magnitude, |ẑ - z| <= error u.

// The largest error of op(x, y, z) rounded `roundings` times, in units u.
template <int Digits>
struct worst_case {
    using bound = basic_error_bound<Digits>;
    double of_error = 0;
    double of_magnitude = 0;

    template <class Op>
    constexpr worst_case(const std::array<bound, 3>& in, int roundings, Op op) {
        const double u = bound::unit;
        // All signs: of the operands except the first (changing all three changes only the result's sign), of each
        // error and of the rounding.
        for (int choice = 0; choice < 128; choice += 2) {
            const auto sign = [&](int bit) { return (choice >> bit & 1) != 0 ? -1.0 : 1.0; };
            double computed[3], exact[3];
            for (std::size_t i = 0; i < 3; ++i) {
                computed[i] = sign(static_cast<int>(i)) * in[i].magnitude;
                exact[i] = computed[i] + sign(static_cast<int>(i) + 3) * in[i].error * u;
            }
            double result = op(computed[0], computed[1], computed[2]);
            for (int i = 0; i < roundings; ++i) {
                result *= 1 + sign(6) * u;
            }
            of_error = larger(of_error, magnitude(result - op(exact[0], exact[1], exact[2])) / u);
            of_magnitude = larger(of_magnitude, magnitude(result));
        }
    }
    // n roundings count as n/(1 - n u).
    constexpr bool is_bounded_by(const bound& b, int roundings) const {
        const double factor = 1 / (1 - roundings * bound::unit);
        return bounds_closely(b.error, of_error, factor) && bounds_closely(b.magnitude, of_magnitude, factor);
    }
};

using degrees = error_bound::degrees;
constexpr degrees of_x{1, 2, 3}, of_y{3, 1, 2}, of_both{4, 3, 5};

template <int Digits>
constexpr bool error_bounds(double m, double e, double n, double f) {
    using bound = basic_error_bound<Digits>;
    using worst = worst_case<Digits>;
    using traits = number_traits<bound>;
    const bound x{m, e, of_x};
    const bound y{n, f, of_y};
    const bound t{n, f, of_x};
    const bound z{f, m, of_both};
    const auto plus = [](double a, double b, double) { return a + b; };
    const auto times = [](double a, double b, double) { return a * b; };
    const auto same = [](double a, double, double) { return a; };
    const auto twofold = [](double a, double, double) { return 2 * a; };
    const auto muladd = [](double a, double b, double c) { return a * b + c; };
    const bound fused = traits::fma(x, y, z);
    return worst({x, t, z}, 1, plus).is_bounded_by(x + t, 1) && (x + t).degree == of_x &&
           worst({x, t, z}, 1, plus).is_bounded_by(x - t, 1) && (x - t).degree == of_x &&
           worst({x, y, z}, 1, times).is_bounded_by(x * y, 1) && (x * y).degree == of_both &&
           worst({x, y, z}, 1, muladd).is_bounded_by(fused, 1) && fused.degree == of_both &&
           worst({x, y, z}, 0, twofold).is_bounded_by(traits::twice(x), 0) && traits::twice(x).degree == of_x &&
           worst({x, y, z}, 0, same).is_bounded_by(-x, 0) && (-x).degree == of_x;
}
// N roundings of the first product, which may be the only one that is not 0.
template <int N, int Digits>
constexpr bool products_of_vectors(double m, double e, double n, double f) {
    using bound = basic_error_bound<Digits>;
    using traits = number_traits<bound>;
    const bound x{m, e, of_x};
    const bound y{n, f, of_y};
    const auto times = [](double a, double b, double) { return a * b; };
    const bound inner = traits::dot(bounded_vector<N>(x), bounded_vector<N>(y));
    const bound square = traits::squared_norm(bounded_vector<N>(x));
    return worst_case<Digits>({x, y, y}, N, times).is_bounded_by(inner, N) && inner.degree == of_both &&
           worst_case<Digits>({x, x, y}, N, times).is_bounded_by(square, N) && square.degree == degrees{2, 4, 6};
}
// The effect of two roundings on a component and, in space, on the vector: √2 times that, see below.
template <int Digits>
constexpr bool cross_products(double m, double e, double n, double f) {
    using bound = basic_error_bound<Digits>;
    using traits = number_traits<bound>;
    const bound x{m, e, of_x};
    const bound y{n, f, of_y};
    const auto times = [](double a, double b, double) { return a * b; };
    const bound in_plane = traits::cross(bounded_vector<2>(x), bounded_vector<2>(y));
    const vec<3, bound> in_space = traits::cross(bounded_vector<3>(x), bounded_vector<3>(y));
    const double inherited = worst_case<Digits>({x, y, y}, 0, times).of_error;
    const double plane_part = in_plane.error - inherited;
    for (int i = 0; i < 3; ++i) {
        const double space_part = in_space[i].error - inherited;
        if (!bounds_closely(space_part * space_part, 2 * plane_part * plane_part, 1 + 0x1p-20) ||
            !bounds_closely(in_space[i].magnitude, m * n + bound::unit * space_part, 1) ||
            in_space[i].degree != of_both) {
            return false;
        }
    }
    return worst_case<Digits>({x, y, y}, 2, times).is_bounded_by(in_plane, 2) && in_plane.degree == of_both;
}
template <int Digits>
constexpr bool all_error_bounds() {
    constexpr std::array<std::array<double, 4>, 3> operands{{{1, 0, 2.5, 0}, {3, 2, 1, 0}, {0.5, 1.5, 2.5, 3}}};
    for (const auto& [m, e, n, f] : operands) {
        if (!error_bounds<Digits>(m, e, n, f) || !products_of_vectors<2, Digits>(m, e, n, f) ||
            !products_of_vectors<3, Digits>(m, e, n, f) || !cross_products<Digits>(m, e, n, f)) {
            return false;
        }
    }
    return true;
}
static_assert(all_error_bounds<5>(), "in which terms of second order count");
static_assert(all_error_bounds<11>(), "in which a bound has little to spare");
// More roundings than these formulas have: (17/16)^8 - 1 in units of 1/16.
constexpr double eighth_power = 17. * 17 * 17 * 17 * 17 * 17 * 17 * 17 / 0x1p32;
static_assert(bounds_closely(detail::rounded<5>(1, 0, 1, 8, of_x).error, (eighth_power - 1) * 16, 2));

static_assert(error_bound().magnitude == 0 && error_bound().error == 0);
static_assert(error_bound_slack - 1 >= 0x1p12 * 0x1p-53, "the compiler's own roundings, of 2^12 operations");
static_assert(error_bound(-3).magnitude == 3 && error_bound(2).magnitude == 2 && error_bound(2).error == 0);
static_assert(number_traits<error_bound>::sign(error_bound(0)) == 0);
static_assert(number_traits<error_bound>::sign(error_bound::exact_input(of_x)) == 1);
static_assert(bounds_closely(basic_error_bound<5>::rounded_input(of_y).error * (1 - 0x1p-4), 1, 1) &&
              basic_error_bound<5>::rounded_input(of_y).magnitude == 1 &&
              basic_error_bound<5>::rounded_input(of_y).degree == of_y &&
              error_bound::exact_input(of_y).degree == of_y && error_bound::exact_input(of_y).error == 0);
static_assert(known<decltype([] { return (error_bound(1, 1, of_y) + error_bound(1, 1, of_y)).degree[2]; })>);
static_assert(!known<decltype([] { return (error_bound(1, 1, of_y) + error_bound(1, 1, of_both)).degree[2]; })>);

// The norms of products of vectors with components that are not negative. |x||y| bounds Σ x_i y_i, and in the plane
// also Σ|x_j y_k| + |x_k y_j|; √2 |x||y| bounds the vector of these sums in space. The omitted terms
// show it.
static_assert([] {
    using letters = polynomial<>;
    const auto x = proof::vector<3, letters>(0);
    const auto y = proof::vector<3, letters>(3);
    const letters norms = squared_norm(x) * squared_norm(y);
    letters left(0);
    letters sums(0);
    for (int i = 0; i < 3; ++i) {
        const letters p = x[(i + 1) % 3] * y[(i + 2) % 3];
        const letters q = x[(i + 2) % 3] * y[(i + 1) % 3];
        sums = sums + (p + q) * (p + q);
        left = left + (p - q) * (p - q) + twice(x[i] * x[i] * y[i] * y[i]);
    }
    return twice(norms) - sums == left && norms - dot(x, y) * dot(x, y) == squared_norm(cross(x, y));
}());
static_assert([] {
    using letters = polynomial<>;
    const auto x = proof::vector<2, letters>(0);
    const auto y = proof::vector<2, letters>(2);
    const letters sum = x[0] * y[1] + x[1] * y[0];
    const letters difference = x[0] * y[0] - x[1] * y[1];
    return squared_norm(x) * squared_norm(y) - sum * sum == difference * difference;
}());

// ---- range_bound: low <= z <= high, |ẑ - z| <= error u.

template <int Digits, class Op>
constexpr bool is_range_of(const range_bound<Digits>& got, const std::array<range_bound<Digits>, 3>& in, int roundings,
                           double factor, Op op) {
    const double u = range_bound<Digits>::unit;
    range_bound<Digits> worst{1e300, -1e300, 0};
    for (int choice = 0; choice < 128; ++choice) {
        const auto bit = [&](int i) { return (choice >> i & 1) != 0; };
        double computed[3], exact[3];
        for (std::size_t i = 0; i < 3; ++i) {
            const int k = static_cast<int>(i);
            exact[i] = bit(k) ? in[i].low : in[i].high;
            computed[i] = exact[i] + (bit(k + 3) ? in[i].error : -in[i].error) * u;
        }
        const double z = op(exact[0], exact[1], exact[2]);
        double result = op(computed[0], computed[1], computed[2]);
        for (int i = 0; i < roundings; ++i) {
            result *= bit(6) ? 1 + u : 1 - u;
        }
        worst.low = z < worst.low ? z : worst.low;
        worst.high = larger(worst.high, z);
        worst.error = larger(worst.error, magnitude(result - z) / u);
    }
    return magnitude(got.low - worst.low) <= 0x1p-48 && magnitude(got.high - worst.high) <= 0x1p-48 &&
           bounds_closely(got.error, worst.error, factor);
}

template <int Digits>
constexpr bool ranges(const range_bound<Digits>& x, const range_bound<Digits>& y, const range_bound<Digits>& z) {
    using traits = number_traits<range_bound<Digits>>;
    const auto right = [&](const range_bound<Digits>& got, int roundings, auto op) {
        return is_range_of(got, {x, y, z}, roundings, 1, op);
    };
    return right(x + y, 1, [](double a, double b, double) { return a + b; }) &&
           right(x - y, 1, [](double a, double b, double) { return a - b; }) &&
           right(x * y, 1, [](double a, double b, double) { return a * b; }) &&
           right(-x, 0, [](double a, double, double) { return -a; }) &&
           right(traits::twice(x), 0, [](double a, double, double) { return 2 * a; }) &&
           right(traits::fma(x, y, z), 1, [](double a, double b, double c) { return a * b + c; });
}
// Ranges of either sign, and ranges across 0. The largest product and the largest sum are at one end.
template <int Digits>
constexpr bool all_ranges() {
    using range = range_bound<Digits>;
    return ranges<Digits>({1, 3, 2}, {0.5, 2, 3}, {1, 2, 1}) && ranges<Digits>({-3, -1, 2}, {0.5, 2, 3}, {-2, -1, 1}) &&
           ranges<Digits>({-3, -1, 2}, {-2, -0.5, 1}, {1, 2, 3}) &&
           ranges<Digits>({-1, 3, 2}, {-1, 2, 3}, {-1, 2, 0}) && ranges<Digits>({-3, 1, 0.5}, {-2, 2, 1}, {-2, 2, 1}) &&
           ranges<Digits>(range::exact_input(), range::exact_input(), range::exact_input());
}
static_assert(all_ranges<5>() && all_ranges<11>());

template <int Digits>
constexpr bool quotients() {
    using range = range_bound<Digits>;
    const auto divide = [](double a, double b, double) { return a / b; };
    for (const range x : {range{1, 3, 2}, range{-3, -1, 2}, range{-2, 3, 1}, range{-3, 2, 0}}) {
        for (const range y : {range{1, 4, 2}, range{2, 4, 3}, range{-4, -1, 2}, range{-2, -1, 0}}) {
            if (!is_range_of(x / y, {x, y, y}, 1, 1, divide)) {
                return false;
            }
        }
    }
    return true;
}
static_assert(quotients<5>() && quotients<11>());

// A root's error is largest where the root is least, its rounding where it is largest.
template <int Digits>
constexpr bool roots() {
    using range = range_bound<Digits>;
    const auto root = [](double a, double, double) { return detail::constant_sqrt(a); };
    const double u = range::unit;
    for (const range x : {range{4, 4, 3}, range{1, 1, 2}, range{2.25, 2.25, 0}}) {
        if (!is_range_of(number_traits<range>::sqrt(x), {x, x, x}, 1, 1 + 2 * u, root)) {
            return false;
        }
    }
    const range wide{1, 16, 2};
    return is_range_of(number_traits<range>::sqrt(wide), {wide, wide, wide}, 1, 1.25, root);
}
static_assert(roots<5>() && roots<11>());

// A quotient and a root throw if the divisor or argument may be 0: an error of 4095 is below 2^-40, one of 4096 is not.
constexpr int quotient_by(double low, double high, double error) {
    return (range_bound<>(1, 1, 0) / range_bound<>(low, high, error)).error > 0;
}
constexpr int root_of(double low, double error) {
    return number_traits<range_bound<>>::sqrt(range_bound<>(low, 1, error)).error > 0;
}
static_assert(known<decltype([] { return quotient_by(0x1p-40, 1, 4095); })> &&
              known<decltype([] { return quotient_by(-1, -0x1p-40, 4095); })> &&
              known<decltype([] { return root_of(0x1p-40, 4095); })>);
static_assert(!known<decltype([] { return quotient_by(0x1p-40, 1, 4096); })> &&
              !known<decltype([] { return quotient_by(-1, -0x1p-40, 4096); })> &&
              !known<decltype([] { return root_of(0x1p-40, 4096); })>);

static_assert(range_bound<>().low == 0 && range_bound<>().high == 0 && range_bound<>().error == 0);
static_assert(range_bound<>::exact_input().low == -1 && range_bound<>::exact_input().high == 1 &&
              range_bound<>::exact_input().error == 0);
static_assert(range_bound<>(-3, 2, 1).magnitude() == 3 && range_bound<>(-1, 2, 1).magnitude() == 2);
static_assert(range_bound<>(-3).low == -3 && range_bound<>(-3).high == -3 && range_bound<>(-3).error == 0);
constexpr auto narrowed = range_bound<>(-3, 2, 1).within(-1, 4);
static_assert(narrowed.low == -1 && narrowed.high == 2 && narrowed.error == 1);
static_assert(range_bound<>(-3, 2, 1).within(-4, 1).low == -3 && range_bound<>(-3, 2, 1).within(-4, 1).high == 1);
// A number that is rounded to at most 1 was at most 1/(1 - u), and its error is u times that.
constexpr auto rounded_once = range_bound<5>::rounded_input();
static_assert(bounds_closely(rounded_once.high, 1 / (1 - 0x1p-4), 1.06) && rounded_once.low == -rounded_once.high &&
              bounds_closely(rounded_once.error, 1 / (1 - 0x1p-4), 1.06));
static_assert(range_bound<5>::unit == 0x1p-4 && range_bound<>::unit == 0x1p-52);

} // namespace
