#include "wide.hpp"

#include "rounding.hpp"

#include <cmath>
#include <utility>

namespace compare {

namespace mp = boost::multiprecision;

wide to_wide(const exact& x) { return wide(numerator(x)) / wide(denominator(x)); }

wide wide_of(double x) { return wide(x); }

wide wide_of(long double x) { return wide(x); }

bool is_wide(const exact& x) {
    const auto below = denominator(x);
    if (lsb(below) != msb(below)) {
        return false;
    }
    const auto above = mp::abs(numerator(x));
    return above == 0 || msb(above) - lsb(above) < static_cast<unsigned>(wide_digits);
}

long exponent_of(const wide& x) { return static_cast<long>(ilogb(x)); }

double scaled(const wide& x, long exponent) {
    if (x == 0) {
        return 0.0;
    }
    const long place = exponent_of(x) + exponent;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (place > 1023) {
        return x > 0 ? infinity : -infinity;
    }
    if (place < -1022) {
        const double smallest = std::numeric_limits<double>::min();
        return x > 0 ? smallest : -smallest;
    }
    return static_cast<double>(wide(ldexp(x, exponent)));
}

namespace {

// |x| in units of the last place of its nearest double.
struct in_units {
    long last; // the unit is 2^last
    wide whole, beyond_middle;
};

in_units in_units_of(const wide& x) {
    const long place = exponent_of(x);
    const long last = (place < -1022 ? -1022 : place) - 52;
    const wide units = ldexp(wide(abs(x)), -last);
    wide whole = floor(units);
    wide beyond = units - whole - wide(0.5);
    return {last, std::move(whole), std::move(beyond)};
}

} // namespace

double nearest_double(const wide& x) {
    if (x == 0) {
        return 0.0;
    }
    double result = std::numeric_limits<double>::infinity();
    if (exponent_of(x) <= 1023) {
        const in_units units = in_units_of(x);
        auto significand = static_cast<std::uint64_t>(units.whole);
        if (units.beyond_middle > 0 || (units.beyond_middle == 0 && (significand & 1) != 0)) {
            ++significand;
        }
        result = std::ldexp(static_cast<double>(significand), static_cast<int>(units.last));
    }
    return x > 0 ? result : -result;
}

std::optional<wide> middle_beside(const wide& x) {
    if (x == 0 || exponent_of(x) > 1023) {
        return std::nullopt;
    }
    const in_units units = in_units_of(x);
    const wide middle = ldexp(wide(units.whole + wide(0.5)), units.last);
    if (abs(units.beyond_middle) > ldexp(wide(units.whole + wide(1)), -800)) {
        return std::nullopt;
    }
    return x > 0 ? middle : wide(-middle);
}

exact to_exact(const wide& x) {
    if (x == 0) {
        return 0;
    }
    const long last = exponent_of(x) - wide_digits + 1;
    const exact whole(static_cast<exact_integer>(wide(ldexp(x, -last))));
    const exact_integer power = exact_integer(1) << static_cast<unsigned long>(last < 0 ? -last : last);
    return last < 0 ? exact(whole / exact(power)) : exact(whole * exact(power));
}

} // namespace compare
