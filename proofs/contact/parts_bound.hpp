// The rounding error of steps that compute with sums of two doubles, bounded by the compiler from the steps themselves.
#pragma once

#include <graze/machine/error_free.hpp>

namespace graze {

// A double in such a step: |x̂| <= size and |x̂ - x| <= error, where x is the result if the step rounds nowhere except
// in the values of its error-free transforms. A transform is exact, value + error = x̂ ∘ ŷ: its value counts as exact,
// and its error inherits the errors of x̂ and ŷ. Every other operation obeys |fl(z) - z| <= u|z| with u = 2^-53 (to
// nearest); the counts hold if it is fused or reordered. The caller excludes underflow and overflow. The bounds
// themselves are computed in doubles: allow for error_bound_slack.
//
// What a step omits on purpose, mostly a product of two low parts, is not a rounding: a proof adds it.
struct parts_bound {
    static constexpr double unit = 0x1p-53;

    double size = 0;
    double error = 0;
    bool is_one = false; // ±1, by which products are exact

    constexpr parts_bound() = default;
    constexpr parts_bound(double x) : size(x < 0 ? -x : x), is_one(size == 1) {}
    constexpr parts_bound(double size_, double error_) : size(size_), error(error_) {}

    // The result of an operation whose exact result from the doubles is at most `largest`.
    [[nodiscard]] static constexpr parts_bound rounded(double largest, double inherited) {
        return {largest * (1 + unit), inherited + unit * largest};
    }
    // Value and error of a transform.
    [[nodiscard]] static constexpr exact_pair<parts_bound> transformed(double largest, double inherited) {
        return {parts_bound(largest * (1 + unit), 0), parts_bound(unit * largest, inherited)};
    }
    // The error that a product inherits.
    [[nodiscard]] static constexpr double inherited(const parts_bound& x, const parts_bound& y) {
        return x.size * y.error + (y.size + y.error) * x.error;
    }

    [[nodiscard]] friend constexpr parts_bound operator-(const parts_bound& x) { return x; }
    [[nodiscard]] friend constexpr parts_bound operator+(const parts_bound& x, const parts_bound& y) {
        return rounded(x.size + y.size, x.error + y.error);
    }
    [[nodiscard]] friend constexpr parts_bound operator*(const parts_bound& x, const parts_bound& y) {
        return x.is_one ? y : y.is_one ? x : rounded(x.size * y.size, inherited(x, y));
    }
};

// Two of them side by side, like two lanes.
struct parts_bounds {
    parts_bound lane[2];

    [[nodiscard]] constexpr const parts_bound& operator[](int i) const { return lane[i]; }

    [[nodiscard]] friend constexpr parts_bounds operator-(const parts_bounds& x) { return x; }
    [[nodiscard]] friend constexpr parts_bounds operator+(const parts_bounds& x, const parts_bounds& y) {
        return {{x[0] + y[0], x[1] + y[1]}};
    }
    [[nodiscard]] friend constexpr parts_bounds operator*(const parts_bounds& x, const parts_bounds& y) {
        return {{x[0] * y[0], x[1] * y[1]}};
    }
    [[nodiscard]] friend constexpr parts_bounds operator*(const parts_bounds& x, const parts_bound& y) {
        return {{x[0] * y, x[1] * y}};
    }
};

// The functions that the steps call, for these types.
[[nodiscard]] constexpr parts_bound settled(const parts_bound& x) { return x; }
[[nodiscard]] constexpr parts_bounds settled(const parts_bounds& x) { return x; }
[[nodiscard]] constexpr detail::halves<parts_bound> veltkamp_split(const parts_bound& x) { return {x, x}; }
[[nodiscard]] constexpr detail::halves<parts_bounds> veltkamp_split(const parts_bounds& x) { return {x, x}; }

[[nodiscard]] constexpr exact_pair<parts_bound> two_sum(const parts_bound& x, const parts_bound& y) {
    return parts_bound::transformed(x.size + y.size, x.error + y.error);
}
[[nodiscard]] constexpr exact_pair<parts_bound> fast_two_sum(const parts_bound& x, const parts_bound& y) {
    return two_sum(x, y);
}
template <bool Fused>
[[nodiscard]] constexpr exact_pair<parts_bound> two_product(const detail::factor<parts_bound, Fused>& x,
                                                            const detail::factor<parts_bound, Fused>& y) {
    return parts_bound::transformed(x.value.size * y.value.size, parts_bound::inherited(x.value, y.value));
}
template <bool Fused>
[[nodiscard]] constexpr exact_pair<parts_bound> two_square(const detail::factor<parts_bound, Fused>& x) {
    return two_product(x, x);
}

namespace detail {
[[nodiscard]] constexpr exact_pair<parts_bounds> side_by_side(const exact_pair<parts_bound>& x,
                                                              const exact_pair<parts_bound>& y) {
    return {{{x.value, y.value}}, {{x.error, y.error}}};
}
template <bool Fused>
[[nodiscard]] constexpr factor<parts_bound, Fused> lane_of(const factor<parts_bounds, Fused>& x, int i) {
    return as_factor<Fused>(x.value[i]);
}
} // namespace detail

[[nodiscard]] constexpr exact_pair<parts_bounds> two_sum(const parts_bounds& x, const parts_bounds& y) {
    return detail::side_by_side(two_sum(x[0], y[0]), two_sum(x[1], y[1]));
}
template <bool Fused>
[[nodiscard]] constexpr exact_pair<parts_bounds> two_product(const detail::factor<parts_bounds, Fused>& x,
                                                             const detail::factor<parts_bounds, Fused>& y) {
    return detail::side_by_side(two_product(detail::lane_of(x, 0), detail::lane_of(y, 0)),
                                two_product(detail::lane_of(x, 1), detail::lane_of(y, 1)));
}
template <bool Fused>
[[nodiscard]] constexpr exact_pair<parts_bounds> two_square(const detail::factor<parts_bounds, Fused>& x) {
    return two_product(x, x);
}

} // namespace graze
