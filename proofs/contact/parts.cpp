// The constants of the contacts' fast path: the losses of its steps, derived from the steps themselves, do not exceed
// what time/newton_approach.hpp and contact/lane_steps.hpp say. The notation is theirs, with u = 2^-53.
//
// Bounds are homogeneous in the sizes of the inputs, so each size is set to 1 in turn. What a step omits, a product of
// two low parts, is added to what it rounds.
#include <graze/analysis/error_bound.hpp>
#include <graze/contact/lane_steps.hpp>

#include "parts_bound.hpp"

namespace {

using namespace graze;
using bounds = parts_bounds;
using one = parts_bound;

constexpr double u = parts_bound::unit;

constexpr bounds both(const one& x) { return {{x, x}}; }
// A size that does not count as a literal ±1.
constexpr one sized(double size, double error = 0) { return {size, error}; }
// A difference of inputs with its error.
constexpr exact_pair<bounds> difference_of(double size) { return {both(sized(size)), both(sized(u * size))}; }
constexpr auto factor_of(const bounds& x) { return detail::as_factor<true>(x); }
constexpr auto factor_of(const one& x) { return detail::as_factor<true>(x); }

constexpr bool is_within(double derived, double stated) { return derived * error_bound_slack <= stated; }
// No stated constant is loose: the derived one is at least half of it.
constexpr bool is_tight(double derived, double stated) { return is_within(derived, stated) && 2 * derived >= stated; }

// y = Δx + Δu t0, m = |Δx| + |Δu| t0.
constexpr auto displaced(double length, double way) {
    return detail::displacement<true>(difference_of(length), difference_of(way), factor_of(both(sized(1))));
}
constexpr bool bounds_displacement(double length, double way) {
    const auto y = displaced(length, way);
    const double m = length + way;
    return is_within(y.low[0].size, 3.02 * u * m) && is_within(y.low[0].error, 7.01 * u * u * m);
}
static_assert(bounds_displacement(1, 0) && bounds_displacement(0, 1));
static_assert(is_tight(displaced(0, 1).low[0].size, 3.02 * u) && is_tight(displaced(0, 1).low[0].error, 7.01 * u * u));

// f = |y|² - R² without the rounding of its leading part: of each square by itself, and of each y times its m.
constexpr detail::lane_displacement<true, bounds> displacement_of(double first, double second, double m) {
    const bounds low{{sized(3.02 * u * m, 7.01 * u * u * m), sized(3.02 * u * m, 7.01 * u * u * m)}};
    return {factor_of(bounds{{sized(first), sized(second)}}), low, factor_of(bounds{})};
}
struct loss {
    double size, error; // of the low parts, added up as approach_near does
};
constexpr loss loss_of_residual(double y0, double y1, double y2, double R, double m) {
    auto last = displacement_of(R, y2, m);
    if (R != 0) {
        last.low.lane[0] = sized(u * R); // a sum of two radii, exact in two parts
    }
    const auto f = detail::distance_residual(displacement_of(y0, y1, m), last);
    const one low = f.error[0] + f.error[1];
    return {low.size, low.error};
}
constexpr double largest(double x, double y) { return x > y ? x : y; }
// Σ a y² <= max a |y|², |y|² < 1.0022 R²; Σ b y m <= max b |y||m|, |m| <= 2.25 L; R <= L/√2. Of size and error alike.
constexpr loss residual = [] {
    constexpr double R = 0.70711, y = 1.0011 * R, m = 2.25;
    const auto by = [&](auto part) {
        const double squares =
            largest(part(loss_of_residual(1, 0, 0, 0, 0)),
                    largest(part(loss_of_residual(0, 1, 0, 0, 0)), part(loss_of_residual(0, 0, 1, 0, 0))));
        const auto with_m = [&](double y0, double y1, double y2) {
            return part(loss_of_residual(y0, y1, y2, 0, 1)) - part(loss_of_residual(y0, y1, y2, 0, 0));
        };
        const double mixed = largest(with_m(1, 0, 0), largest(with_m(0, 1, 0), with_m(0, 0, 1)));
        return squares * y * y + part(loss_of_residual(0, 0, 0, 1, 0)) * R * R + mixed * y * m;
    };
    return loss{by([](const loss& x) { return x.size; }), by([](const loss& x) { return x.error; })};
}();
// With one more rounding of the low parts where the leading ones cancel.
static_assert(is_tight(residual.error + u * residual.size, 116 * u * u));

// x + u (t0 + t1): 3.01 u² |x| + |u| (6.01 u² t0 + 3.01 u |t1|), adding the bound included.
constexpr double loss_of_position(double x, double way, double t1) {
    const auto y = detail::position_in_parts(both(sized(x)), both(sized(1)), factor_of(both(sized(way))), sized(t1));
    return y.error[0].error + u * y.error[0].size;
}
static_assert(is_tight(loss_of_position(1, 0, 0), 3.01 * u * u));
static_assert(is_within(loss_of_position(0, 1, 0), 6.01 * u * u) && is_within(loss_of_position(0, 0, 1), 3.01 * u));

// The normal, |il| <= 2.02 u ih: 8.3 u² |yh| ih + 4.2 u |zl| ih.
constexpr double loss_of_normal(double high, double low) {
    detail::lane_displacement<true, bounds> y = displacement_of(high, high, 0);
    const double inverse_low = 2.02 * u;
    const auto n = detail::normal_of(y, both(sized(low)), factor_of(both(sized(1))), both(sized(inverse_low)));
    return n.low[0].error + low * inverse_low;
}
static_assert(is_tight(loss_of_normal(1, 0), 8.3 * u * u) && is_tight(loss_of_normal(0, 1), 4.2 * u));

// zl = yl + Δu t1 rounds 3.02 u² m + 2u |Δu t1| more.
static_assert([] {
    auto y = displacement_of(1, 1, 1);
    y.du = factor_of(both(sized(1)));
    const double with_m = detail::low_at_contact(y, sized(0)).lane[0].error;
    const double with_t1 = detail::low_at_contact(displaced(0, 1), sized(1)).lane[0].error - with_m;
    return is_within(with_m, (7.01 + 3.03) * u * u) && is_within(with_t1, 2.01 * u);
}());

// u + φ n, |φ's low part| <= 9 u |φ|, |nl| <= 3.1 u |nh|: |φ n| 94 u² + 2.01 u² |u|, adding the bound included.
constexpr double loss_of_velocity(double speed, double phi) {
    const detail::lane_normal<true, bounds> n{factor_of(both(sized(1))), both(sized(3.1 * u))};
    const double phi_low = 9 * u * phi;
    const auto v = detail::velocity_in_parts(both(sized(speed)), factor_of(both(sized(phi))), both(sized(phi_low)), n);
    return v.error[0].error + u * v.error[0].size + phi_low * 3.1 * u;
}
static_assert(is_tight(loss_of_velocity(1, 0), 2.01 * u * u) && is_tight(loss_of_velocity(0, 1), 94 * u * u));

// (x.value + x.error)(high + low), |x.error| <= λ, |low| <= 2.02 u: 8.1 u² + 4.1 u λ more than its factors'.
constexpr exact_pair<one> times(const exact_pair<one>& x, const one& low) {
    auto product = detail::times(x, factor_of(sized(1)), low);
    product.error.error += x.error.size * low.size;
    return product;
}
constexpr double loss_of_times(double lambda) { return times({sized(1), sized(lambda)}, sized(2.02 * u)).error.error; }
static_assert(is_tight(loss_of_times(0), 8.1 * u * u));
static_assert(is_tight(loss_of_times(u) - loss_of_times(0), 4.1 * u * u));

// φ = 2 (s/R)/(m_a + m_b) m from an s with |its low part| <= u|s| and inverses that are right to 9.2 u²: 71 u² more
// than s, and a low part of at most 9 u.
static_assert([] {
    const one inverse_low = sized(2.02 * u, 9.2 * u * u);
    const auto per_mass = times(times({sized(1), sized(u)}, inverse_low), inverse_low);
    const auto share = two_product(factor_of(sized(1)), factor_of(sized(1)));
    const one low = share.error + per_mass.error * sized(1);
    return is_tight(low.error, 71 * u * u) && is_tight(low.size, 9 * u);
}());

// s = -y·Δu, |y| <= 0.708 L, |m| <= 2.25 L: 76 u² L V + 1.5 V² e, of which y's own error makes 10.1 u² L V + 1.21 V² e.
// Products of y's low part and the errors of Δu are left out. e >= 31 u |t1|.
constexpr double loss_of_closing_speed(int axis, double y, double low) {
    const auto at = [&](int i, double x) { return sized(i == axis ? x : 0); };
    const auto difference = [&](int i, int j) {
        return exact_pair<bounds>{{{at(i, 1), at(j, 1)}}, {{at(i, u), at(j, u)}}};
    };
    const struct { exact_pair<bounds> u01, u_2; } motion{difference(0, 1), difference(-1, 2)};
    auto y01 = displacement_of(at(0, y).size, at(1, y).size, 0);
    auto y2 = displacement_of(0, at(2, y).size, 0);
    y01.du = factor_of(motion.u01.value);
    y2.du = factor_of(motion.u_2.value);
    const bounds low01{{at(0, low), at(1, low)}};
    const bounds low2{{sized(0), at(2, low)}};
    return detail::closing_speed(y01, low01, y2, low2, motion).error.error + low * u;
}
constexpr double loss_of_closing_speed(double y, double low) {
    return largest(loss_of_closing_speed(0, y, low),
                   largest(loss_of_closing_speed(1, y, low), loss_of_closing_speed(2, y, low)));
}
constexpr double speed_error_of_low = (loss_of_closing_speed(0, u) - loss_of_closing_speed(0, 0)) / u;
static_assert(is_tight(loss_of_closing_speed(1, 0) * 0.708 + speed_error_of_low * 3.02 * u * 2.25 + 10.1 * u * u,
                       76 * u * u));
static_assert(is_within(speed_error_of_low / (31 * u) + 1.21, 1.5));

// The error that the code adds to a velocity is enough: for a hit 54 u² γ + 71 u² + 94 u², γ >= 1/0.51; for an overlap
// 32 u² χ + 30 u² and the same, χ >= 1.
static_assert(is_within(54 * u * u + (71 + 94) * 0.51 * u * u, 0x1p-98) &&
              is_within((32 + 30 + 71 + 94) * u * u, 0x1p-98));
// So is the error that it adds to a time: half of |f̂ - f| over σ, with the squares of low parts that f omits.
constexpr double left_out = 3.02 * 2.25 * 3.02 * 2.25 + 0.5;
static_assert(is_within(left_out, 47) && is_within((116 + left_out) * u * u / 2 * (1 + 0x1p-9), 0x1p-99));
// The same for flights, whose Δx is already off by 8.1 u² of the length.
static_assert(is_within((116 + left_out + 2.01 * 0.71 * 8.1) * u * u / 2 * (1 + 0x1p-9), 0x1p-99));
static_assert(is_within((60.2 + (71 + 94) * 0.51) * u * u, 0x1p-98));

} // namespace
