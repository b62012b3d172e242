#include "true_value.hpp"

#include "rounding.hpp"

#include <limits>
#include <utility>

namespace compare {

namespace mp = boost::multiprecision;

computed::computed(wide x) : value_(std::move(x)) {}
computed::computed(exact_real x) : value_(std::move(x)) {}
computed::computed(interval x) : value_(std::move(x)) {}
computed::computed(not_finite x) : value_(x) {}
computed::computed(exactly_right x) : value_(x) {}
computed::computed(const computed& other) = default;
computed::computed(computed&& other) noexcept = default;
computed& computed::operator=(const computed& other) = default;
computed& computed::operator=(computed&& other) noexcept = default;
computed::~computed() = default;

namespace {

// The root of an integer, if it is an integer.
template <class I>
bool whole_root(const I& x, I& root) {
    I remainder;
    root = mp::sqrt(x, remainder);
    return remainder == 0;
}

bool rational_root(const exact& d, exact& root) {
    auto above = numerator(d), below = denominator(d);
    decltype(above) root_above, root_below;
    if (!whole_root(above, root_above) || !whole_root(below, root_below)) {
        return false;
    }
    root = exact(root_above, root_below);
    return true;
}

int sign(const exact& x) { return x.sign(); }

// Whether q²d is the same for both. In integers, because reducing fractions is what takes long.
bool same_square(const exact_real& x, const exact_real& y) {
    const auto side = [](const exact_real& above, const exact_real& below) -> exact_integer {
        const exact_integer q = numerator(above.q()), r = denominator(below.q());
        return q * q * numerator(above.d()) * r * r * denominator(below.d());
    };
    return side(x, y) == side(y, x);
}

} // namespace

exact_real simplified(const exact_real& x) {
    exact root;
    if (sign(x.q()) == 0) {
        return exact_real(x.p());
    }
    return rational_root(x.d(), root) ? exact_real(exact(x.p() + x.q() * root)) : x;
}

bool equal(const exact_real& x, const exact_real& y) {
    const bool same_p = x.p() == y.p();
    if (same_p && x.q() == y.q() && (sign(x.q()) == 0 || x.d() == y.d())) {
        return true;
    }
    if (same_p && sign(x.q()) == sign(y.q()) && same_square(x, y)) {
        return true;
    }
    const exact_real a = simplified(x), b = simplified(y);
    return a.p() == b.p() && sign(a.q()) == sign(b.q()) &&
           (sign(a.q()) == 0 || a.q() * a.q() * a.d() == b.q() * b.q() * b.d());
}

const wide& root_memory::root_of(const exact& d) {
    if (d != d_) {
        root_ = sqrt(to_wide(d));
        d_ = d;
    }
    return root_;
}

wide to_wide(const exact_real& x, root_memory& roots) {
    const int p = sign(x.p()), q = sign(x.q());
    if (q == 0) {
        return to_wide(x.p());
    }
    const wide term = to_wide(x.q()) * roots.root_of(x.d());
    if (p == 0) {
        return term;
    }
    const wide rational = to_wide(x.p());
    if (p == q) {
        return rational + term;
    }
    return to_wide(exact(x.p() * x.p() - x.q() * x.q() * x.d())) / (rational - term);
}

true_value::true_value(const exact_real& x, root_memory& roots) : exactly_(simplified(x)) {
    value_ = to_wide(exactly_, roots);
    if (sign(exactly_.q()) == 0) {
        is_value_ = is_wide(exactly_.p());
        nearest_ = nearest_double(exactly_.p());
    } else {
        is_value_ = false;
        wide rounded = value_;
        if (const auto middle = middle_beside(value_)) { // the value is irrational, so on one side of the middle
            const int side = (exactly_ - exact_real(to_exact(*middle))).sign();
            rounded = *middle + ldexp(wide(side), exponent_of(*middle) - 800);
        }
        nearest_ = nearest_double(rounded);
    }
}

namespace {

// The distance from t, given the difference from t.value().
wide certified(const wide& difference, const true_value& t) {
    const wide apart = abs(difference);
    if (t.is_value()) {
        return apart;
    }
    const wide known = ldexp(wide(abs(t.value())), -780);
    return apart > known ? apart : known;
}

} // namespace

std::optional<wide> distance(const computed& x, const true_value& t) {
    if (const wide* number = std::get_if<wide>(&x.value())) {
        return certified(*number - t.value(), t);
    }
    if (const exact_real* real = std::get_if<exact_real>(&x.value())) {
        if (equal(*real, t.exactly())) {
            return wide(0);
        }
        root_memory roots;
        return certified(to_wide(*real, roots) - t.value(), t);
    }
    if (std::holds_alternative<exactly_right>(x.value())) {
        return wide(0);
    }
    if (const interval* between = std::get_if<interval>(&x.value())) {
        const wide low = certified(between->low - t.value(), t), high = certified(between->high - t.value(), t);
        return low > high ? low : high;
    }
    return std::nullopt;
}

bool rounds_correctly(const computed& x, const true_value& t) {
    if (const wide* number = std::get_if<wide>(&x.value())) {
        return nearest_double(*number) == t.nearest();
    }
    if (const exact_real* real = std::get_if<exact_real>(&x.value())) {
        if (equal(*real, t.exactly())) {
            return true;
        }
        root_memory roots;
        return true_value(*real, roots).nearest() == t.nearest();
    }
    if (const interval* between = std::get_if<interval>(&x.value())) {
        return nearest_double(between->low) == t.nearest() && nearest_double(between->high) == t.nearest();
    }
    return std::holds_alternative<exactly_right>(x.value());
}

bool encloses(const interval& x, const true_value& t) {
    const auto side = [&](const wide& end) { // the sign of the exact value less the end
        return (t.exactly() - exact_real(to_exact(end))).sign();
    };
    const wide room = ldexp(wide(abs(t.value())), -780);
    return (t.value() - x.low > room || side(x.low) >= 0) && (x.high - t.value() > room || side(x.high) <= 0);
}

wide middle(const computed& x, const true_value& t) {
    if (const wide* number = std::get_if<wide>(&x.value())) {
        return *number;
    }
    if (const exact_real* real = std::get_if<exact_real>(&x.value())) {
        root_memory roots;
        return to_wide(*real, roots);
    }
    if (const interval* between = std::get_if<interval>(&x.value())) {
        return (between->low + between->high) / wide(2);
    }
    return std::holds_alternative<exactly_right>(x.value()) ? t.value() : std::numeric_limits<wide>::quiet_NaN();
}

} // namespace compare
