// |computed - exact| <= K u M on chosen inputs, by the compiler's own arithmetic: floats are compared with doubles,
// which are exact for small integers, and doubles with integers.
#include <graze/analysis/error_bound.hpp>
#include <graze/exact/integer.hpp>
#include <graze/formula/discriminant.hpp>
#include <graze/formula/plane_crossing.hpp>
#include <graze/number/floating.hpp>

#include "../bounds/staged.hpp"

#include <array>

namespace {

using namespace graze;

struct halved {
    template <class M>
    constexpr auto operator()(const M& m) const {
        return discriminant_halved{}(quadratic_of(m));
    }
};

// The constant from exact differences, for vectors of norms of at most length and velocity, in error_bound's u = 2^-52.
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

// For 12-bit integers: D < 2^53. Floats round to nearest, u = 2^-24; terms of second order in u are below 1 %.
template <class F>
constexpr double error_in_float(const std::array<int, 7>& x) {
    const double exact = F{}(motion<double>(x));
    const double difference = static_cast<double>(F{}(motion<float>(x))) - exact;
    const auto m = motion<double>(x);
    const double length2 = squared_norm(m.dx) > m.R * m.R ? squared_norm(m.dx) : m.R * m.R;
    return (difference < 0 ? -difference : difference) * 0x1p24 / (length2 * squared_norm(m.du));
}

// One pair of each family: grazing, far, tiny radius, near contact, almost equal velocities, generic.
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

// For balls that graze, are far apart or small, Lagrange's form errs ten thousand times less than the halved form.
constexpr bool errs_far_less(const std::array<int, 7>& x) {
    return 10000 * error_in_float<discriminant_lagrange>(x) < error_in_float<halved>(x);
}
static_assert(errs_far_less(chosen[0]) && errs_far_less(chosen[1]) && errs_far_less(chosen[2]));

// τ in float against τ in double, which errs 2^29 times less, for balls that meet with D >= 2^-10 a |Δx|². The unit is
// 2^-24 |Δx|/|Δu|, as in the bound of staged.hpp.
template <class T>
constexpr T time_of(const std::array<int, 7>& x) {
    const auto m = motion<T>(x);
    return root_stable{}(T(coefficient_c{}(m)), T(coefficient_h{}(m)), graze::root(T(discriminant_lagrange{}(m))));
}
constexpr double time_error(const std::array<int, 7>& x) {
    const auto m = motion<double>(x);
    const double scale2 = squared_norm(m.dx) / squared_norm(m.du);
    const double error = (static_cast<double>(time_of<float>(x)) - time_of<double>(x)) * 0x1p24;
    return error * error / scale2; // squared
}
constexpr std::array<std::array<int, 7>, 5> meeting{{{4000, 29, 0, -3999, 1, 7, 203},
                                                     {4095, 4093, 4091, -4089, -4087, -3001, 1700},
                                                     {2897, 2895, 11, -4093, -4091, 3, 4093},
                                                     {1237, -2311, 3989, -2477, 3163, -3801, 2741},
                                                     {3001, 2003, 1009, -3, -2, -1, 2999}}};
constexpr bool in_domain(const std::array<int, 7>& x) {
    const auto m = motion<double>(x);
    return coefficient_h{}(m) < 0 && coefficient_c{}(m) >= 0 &&
           1024 * discriminant_lagrange{}(m) >= squared_norm(m.du) * squared_norm(m.dx);
}
constexpr double time_bound = 1.01 * bounds::staged_root<discriminant_lagrange, 3, 25>(10);
constexpr bool time_is_within(const std::array<int, 7>& x) {
    return in_domain(x) && time_error(x) > 0 && time_error(x) < time_bound * time_bound;
}
static_assert(time_is_within(meeting[0]) && time_is_within(meeting[1]) && time_is_within(meeting[2]) &&
              time_is_within(meeting[3]) && time_is_within(meeting[4]));

// staged.hpp assumes that an error of two balls is linear in R²; error_bound confirms it for each radius.
template <class F>
constexpr bool is_linear_in_square_of_radius() {
    using bound = basic_error_bound<53>;
    for (const double r : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const double direct = F{}(relative_motion{bounded_vector<3>(bound::rounded_input({1, 0, 0})),
                                                  bounded_vector<3>(bound::rounded_input({0, 1, 0})),
                                                  bound(r, r * bound::rounded_input({1, 0, 0}).error, {1, 0, 0})})
                                  .error;
        const double taken = bounds::error_of_balls<F, 3, 53>.at(r * r);
        if (!(taken >= direct && taken <= direct * (1 + 0x1p-40))) {
            return false;
        }
    }
    return true;
}
static_assert(is_linear_in_square_of_radius<coefficient_c>() && is_linear_in_square_of_radius<coefficient_h>() &&
              is_linear_in_square_of_radius<discriminant_lagrange>() && is_linear_in_square_of_radius<halved>());

// The crossing of a plane: whether the ball cuts it, and when it touches it, for |u·n| >= 2^-6 |u||n|.
template <class T>
constexpr plane_motion<3, T, T, T, T> crossing(const std::array<int, 10>& x) {
    return {{{T(x[0]), T(x[1]), T(x[2])}}, {{T(x[3]), T(x[4]), T(x[5])}}, {{T(x[6]), T(x[7]), T(x[8])}}, T(x[9])};
}
constexpr double clearance_error(const std::array<int, 10>& x) {
    const auto m = crossing<double>(x);
    const double error = static_cast<double>(plane_clearance{}(crossing<float>(x))) - plane_clearance{}(m);
    const double w2 = squared_norm(m.w) > m.r * m.r ? squared_norm(m.w) : m.r * m.r;
    return (error < 0 ? -error : error) * 0x1p24 / (w2 * squared_norm(m.n));
}
template <class T>
constexpr T touch_of(const std::array<int, 10>& x) {
    const auto m = crossing<T>(x);
    return plane_touch_time{}(T(plane_height{}(m)), T(plane_speed{}(m)), T(m.r * graze::root(T(squared_norm(m.n)))));
}
constexpr double touch_error(const std::array<int, 10>& x) {
    const auto m = crossing<double>(x);
    const double error = (static_cast<double>(touch_of<float>(x)) - touch_of<double>(x)) * 0x1p24;
    return error * error * squared_norm(m.u) / squared_norm(m.w);
}
constexpr std::array<std::array<int, 10>, 3> crossings{{{3001, 2003, 1009, -1237, -2311, -3989, 997, 1999, 1499, 577},
                                                        {4093, -211, 307, -4091, 4089, 17, 3571, 13, 1301, 2999},
                                                        {101, 103, 4091, 2003, -2999, -1201, 5, 7, 3001, 3989}}};
constexpr double clearance_bound = 1.01 * bounds::error_of_plane<plane_clearance, 3, 25>;
constexpr double touch_bound = 1.01 * bounds::staged_touch<3, 25>(6);
constexpr bool crossing_is_within(const std::array<int, 10>& x) {
    const auto m = crossing<double>(x);
    const double height = plane_height{}(m), speed = plane_speed{}(m), nn = squared_norm(m.n);
    const bool in_domain = speed < 0 && 256 * height * height >= squared_norm(m.w) * nn && plane_clearance{}(m) >= 0 &&
                           4096 * speed * speed >= squared_norm(m.u) * nn;
    return in_domain && clearance_error(x) > 0 && clearance_error(x) < clearance_bound && touch_error(x) > 0 &&
           touch_error(x) < touch_bound * touch_bound;
}
static_assert(crossing_is_within(crossings[0]) && crossing_is_within(crossings[1]) && crossing_is_within(crossings[2]));

// 30-bit integers in doubles: |computed - exact| 2^53 <= K length² velocity², all as integers.
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
