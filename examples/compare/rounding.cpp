#include "rounding.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace compare {

namespace {

long bits_of(const exact_integer& x) { return x.is_zero() ? 0 : static_cast<long>(msb(x)) + 1; }

exact_integer shifted(const exact_integer& x, long by) {
    return by > 0 ? exact_integer(x << static_cast<unsigned long>(by)) : x;
}

double to_double(const rounded_value& r) {
    const double magnitude = r.infinite ? std::numeric_limits<double>::infinity()
                                        : std::ldexp(static_cast<double>(static_cast<std::uint64_t>(r.significand)),
                                                     static_cast<int>(r.exponent)); // exact: it fits the format
    return r.negative ? -magnitude : magnitude;
}

} // namespace

rounded_value round_to(const exact& x, const binary_format& format, rounding direction) {
    rounded_value result;
    if (x.is_zero()) {
        return result;
    }
    result.negative = x.sign() < 0;
    const exact_integer n = abs(exact_integer(numerator(x)));
    const exact_integer d = denominator(x);
    long top = bits_of(n) - bits_of(d); // 2^(top-1) < |x| < 2^(top+1), then 2^top <= |x| < 2^(top+1)
    if (shifted(n, -top) < shifted(d, top)) {
        --top;
    }
    result.exponent = std::max(top + 1, format.min_exponent) - format.digits;
    exact_integer remainder;
    const exact_integer divisor = shifted(d, result.exponent);
    divide_qr(shifted(n, -result.exponent), divisor, result.significand, remainder);

    bool up = false;
    if (direction == rounding::to_nearest) {
        const exact_integer doubled = remainder << 1U;
        up = doubled > divisor || (doubled == divisor && bit_test(result.significand, 0));
    } else {
        up = !remainder.is_zero() && result.negative == (direction == rounding::down);
    }
    if (up) {
        ++result.significand;
    }
    if (bits_of(result.significand) > format.digits) { // it was all ones
        result.significand >>= 1U;
        ++result.exponent;
    }
    if (bits_of(result.significand) + result.exponent > format.max_exponent) {
        const bool away = direction == rounding::to_nearest || result.negative == (direction == rounding::down);
        result.infinite = away;
        result.significand = away ? exact_integer(0) : exact_integer(shifted(1, format.digits) - 1);
        result.exponent = away ? 0 : format.max_exponent - format.digits;
    }
    return result;
}

double nearest_double(const exact& x) { return to_double(round_to(x, double_format)); }

double double_below(const exact& x) { return to_double(round_to(x, double_format, rounding::down)); }

double double_above(const exact& x) { return to_double(round_to(x, double_format, rounding::up)); }

exact exact_of(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const auto field = static_cast<long>(bits >> 52U & 0x7ffU);
    if (field == 0x7ff) {
        throw std::domain_error("exact_of: not a finite number");
    }
    std::uint64_t significand = bits & 0xfffffffffffffU;
    if (field != 0) {
        significand |= std::uint64_t{1} << 52U;
    }
    if (significand == 0) {
        return exact(0);
    }
    const int zeros = std::countr_zero(significand);
    const long exponent = std::max(field, 1L) - 1075 + zeros;
    exact_integer value(significand >> static_cast<unsigned>(zeros));
    if (bits >> 63U != 0) {
        value = -value;
    }
    return exponent >= 0 ? exact(shifted(value, exponent)) : exact(value, shifted(1, -exponent));
}

} // namespace compare
