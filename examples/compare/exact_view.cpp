#include "exact_access.hpp"

#include <iterator>
#include <utility>

namespace compare {

namespace {

binary_number without_boost(const rounded_value& x) {
    binary_number result{whole_of(x.significand), x.exponent, x.infinite};
    result.significand.negative = x.negative;
    return result;
}

} // namespace

whole_number whole_of(const exact_integer& x) {
    whole_number result;
    result.negative = x.sign() < 0;
    export_bits(exact_integer(abs(x)), std::back_inserter(result.digits), 32);
    return result;
}

exact_integer integer_of(const whole_number& x) {
    exact_integer result = 0;
    if (!x.digits.empty()) {
        import_bits(result, x.digits.begin(), x.digits.end(), 32);
    }
    return x.negative ? exact_integer(-result) : result;
}

exact exact_of(const fraction& x) { return exact(integer_of(x.numerator), integer_of(x.denominator)); }

bool exact_view::is_zero() const { return exact_access::behind(*this).is_zero(); }

fraction exact_view::parts() const {
    const exact& x = exact_access::behind(*this);
    return {whole_of(exact_integer(numerator(x))), whole_of(exact_integer(denominator(x)))};
}

std::string exact_view::numerator_in_decimal() const {
    return exact_integer(numerator(exact_access::behind(*this))).str();
}

std::string exact_view::denominator_in_decimal() const {
    return exact_integer(denominator(exact_access::behind(*this))).str();
}

binary_number exact_view::rounded(const binary_format& format) const {
    return without_boost(round_to(exact_access::behind(*this), format));
}

binary_number exact_view::inverse_rounded(const binary_format& format) const {
    return without_boost(round_to(exact(1 / exact_access::behind(*this)), format));
}

double exact_view::nearest() const { return nearest_double(exact_access::behind(*this)); }

double exact_view::nearest_to_rest(double taken) const {
    return nearest_double(exact(exact_access::behind(*this) - exact_of(taken)));
}

double exact_view::below() const { return double_below(exact_access::behind(*this)); }

double exact_view::above() const { return double_above(exact_access::behind(*this)); }

whole_number exact_view::in_units(unsigned bits) const {
    const exact& x = exact_access::behind(*this);
    const exact_integer twice = abs(exact_integer(numerator(x))) * (exact_integer(1) << (bits + 1)),
                        below = denominator(x);
    whole_number result = whole_of(exact_integer((twice + below) / (below * 2)));
    result.negative = x.sign() < 0;
    return result;
}

} // namespace compare
