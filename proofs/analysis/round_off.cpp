// |computed - exact| <= K u M on chosen inputs, by the compiler's own arithmetic: floats against doubles, in which
// small integers are exact, doubles against integers.
#include <graze/analysis/error_bound.hpp>
#include <graze/formula/discriminant.hpp>
#include <graze/formula/plane_crossing.hpp>
#include <graze/number/floating.hpp>
#include <graze/number/integer.hpp>

#include <array>

namespace {

using namespace graze;

struct halved {
    template <class M>
    constexpr auto operator()(const M& m) const {
        return discriminant_halved{}(quadratic_of(m));
    }
};

// The constant from exact differences, for vectors of norms of at most length and velocity, of error_bound's u = 2^-52.
template <int N, class F>
constexpr double constant() {
    return F{}(relative_motion{bounded_vector<N>(error_bound::exact_input({1, 0, 0})),
                               bounded_vector<N>(error_bound::exact_input({0, 1, 0})),
                               error_bound::exact_input({1, 0, 0})})
               .error *
           error_bound_slack;
}

template <class T>
constexpr relative_motion<3, T, T, T> motion(const std::array<int, 7>& x) {
    return {{{T(x[0]), T(x[1]), T(x[2])}}, {{T(x[3]), T(x[4]), T(x[5])}}, T(x[6])};
}

// Of 12-bit integers: D < 2^53. Floats round to nearest, u = 2^-24; what is of second order in u is below 1 %.
template <class F>
constexpr double error_in_float(const std::array<int, 7>& x) {
    const double exact = F{}(motion<double>(x));
    const double difference = static_cast<double>(F{}(motion<float>(x))) - exact;
    const auto m = motion<double>(x);
    const double length2 = squared_norm(m.dx) > m.R * m.R ? squared_norm(m.dx) : m.R * m.R;
    return (difference < 0 ? -difference : difference) * 0x1p24 / (length2 * squared_norm(m.du));
}

// A family each: grazing, far, tiny radius, near contact, almost equal velocities, generic.
constexpr std::array<std::array<int, 7>, 6> chosen{{{4000, 29, 0, -3999, 1, 7, 36},
                                                    {4095, 4093, 4091, -4089, -4087, -4085, 3},
                                                    {4001, 3, 5, -4003, 1, 2, 1},
                                                    {2897, 2895, 11, -4093, -4091, 3, 4095},
                                                    {3001, 2003, 1009, 1, -1, 0, 2999},
                                                    {1237, -2311, 3989, -2477, 3163, -1801, 2741}}};
template <class F>
constexpr double worst_in_float() {
    double worst = 0;
    for (const auto& x : chosen) {
        const double error = error_in_float<F>(x);
        worst = error > worst ? error : worst;
    }
    return worst;
}
static_assert(worst_in_float<halved>() > 0 && worst_in_float<halved>() < 1.01 * constant<3, halved>());
static_assert(worst_in_float<discriminant_lagrange>() > 0 &&
              worst_in_float<discriminant_lagrange>() < 1.01 * constant<3, discriminant_lagrange>());

// Lagrange's form errs ten thousand times less than the halved one where balls graze, are far or are small.
constexpr bool errs_far_less(const std::array<int, 7>& x) {
    return 10000 * error_in_float<discriminant_lagrange>(x) < error_in_float<halved>(x);
}
static_assert(errs_far_less(chosen[0]) && errs_far_less(chosen[1]) && errs_far_less(chosen[2]));

// Of 30-bit integers in doubles: |computed - exact| 2^53 <= K length² velocity², all as integers.
template <class F>
constexpr bool double_is_within(const std::array<int, 7>& x) {
    const auto m = motion<integer<32>>(x);
    const auto exact = F{}(m);
    const double value = F{}(motion<double>(x));
    int shift = 0;
    double significand = value;
    for (; significand >= 0x1p62 || significand <= -0x1p62; significand /= 2) {
        ++shift;
    }
    const auto computed = integer<140>::from_shifted(static_cast<std::int64_t>(significand), shift);
    const auto difference = computed - exact;
    const auto magnitude = sign(difference) < 0 ? -difference : difference;
    const auto r2 = m.R * m.R;
    const auto x2 = squared_norm(m.dx);
    const auto length2 = x2 + r2; // at least the larger
    const integer<12> k(static_cast<int>(constant<3, F>()) + 1);
    return sign(magnitude * integer<54>::from_shifted(1, 53) - k * (length2 * squared_norm(m.du))) <= 0;
}
constexpr std::array<std::array<int, 7>, 3> long_ones{
    {{1000000007, 998244353, 19, -999999937, 17, 23, 1000000009},
     {1073741789, 1073741783, 1073741741, -1073741723, -1073741719, -1073741717, 5},
     {123456791, -987654323, 555555557, -246813589, 777777801, -135792469, 1010101039}}};
static_assert(double_is_within<halved>(long_ones[0]) && double_is_within<discriminant_lagrange>(long_ones[0]));
static_assert(double_is_within<halved>(long_ones[1]) && double_is_within<discriminant_lagrange>(long_ones[1]));
static_assert(double_is_within<halved>(long_ones[2]) && double_is_within<discriminant_lagrange>(long_ones[2]));

} // namespace
