// Sums of doubles and products, as if in three times their precision.
#pragma once

#include <graze/machine/error_free.hpp>

namespace graze::inline v0_1::detail {

// SumK with K = 3 (Ogita, Rump, Oishi, "Accurate sum and dot product", SIAM J. Sci. Comput. 26(6), 2005). For n <= 32
// terms whose magnitudes add up to S, high + middle + low is off by at most n³u³S < 2^-143 S, u = 2^-53: the errors of
// the terms' sums add up to at most n u S, the errors of those sums to n² u² S, and the latter are summed with n
// roundings. Under the conditions of error-free transforms.
template <bool Fused>
struct accurate_sum {
    double high = 0, middle = 0, low = 0;

    [[gnu::always_inline]] constexpr void add(double x) noexcept {
        const auto s = two_sum(high, x);
        const auto t = two_sum(middle, s.error);
        high = s.value;
        middle = t.value;
        low = settled(low + t.error);
    }
    [[gnu::always_inline]] constexpr void add(const exact_pair<double>& x) noexcept {
        add(x.value);
        add(x.error);
    }
    // sign (x.value + x.error)², five terms, of which the square of the error, at most u² of the whole, is rounded.
    [[gnu::always_inline]] constexpr void add_square(const exact_pair<double>& x, double sign) noexcept {
        const auto value = as_factor<Fused>(x.value);
        const auto square = two_square(value);
        add({sign * square.value, sign * square.error});
        const auto cross = two_product(value, as_factor<Fused>(2 * sign * x.error));
        add(cross);
        add(settled(sign * (x.error * x.error)));
    }

    // The sum in two doubles, right to another 2u² of itself.
    [[nodiscard, gnu::always_inline]] constexpr exact_pair<double> rounded() const noexcept {
        const auto s = two_sum(high, middle);
        return two_sum(s.value, settled(s.error + low));
    }
};

} // namespace graze::inline v0_1::detail
