#include "certified.hpp"

#include "../exact_access.hpp"
#include "../types/gmp_exact.hpp"

#include <algorithm>

namespace compare::run {

namespace {

std::size_t length_of(const mpq_class& x) {
    return mpz_sizeinbase(x.get_num_mpz_t(), 2) + mpz_sizeinbase(x.get_den_mpz_t(), 2);
}

bool is_square(const mpq_class& x) {
    return mpz_perfect_square_p(x.get_num_mpz_t()) != 0 && mpz_perfect_square_p(x.get_den_mpz_t()) != 0;
}

mpq_class root_of(const mpq_class& square) {
    mpq_class root;
    mpz_sqrt(root.get_num_mpz_t(), square.get_num_mpz_t());
    mpz_sqrt(root.get_den_mpz_t(), square.get_den_mpz_t());
    return root;
}

// Whether the interval determines its number to this many bits.
bool is_narrow(const mpfi_interval& x, long bits) {
    if (mpfr_sgn(x.lower()) != mpfr_sgn(x.upper())) {
        return false;
    }
    mpfr_t width;
    mpfr_init2(width, 16);
    mpfr_sub(width, x.upper(), x.lower(), MPFR_RNDU);
    const bool narrow = mpfr_zero_p(width) != 0 ||
                        mpfr_get_exp(width) + bits < std::min(mpfr_get_exp(x.lower()), mpfr_get_exp(x.upper()));
    mpfr_clear(width);
    return narrow;
}

} // namespace

certified::certified(const exact& x, long bits) : bits_(bits) {
    set_rational(rational_.get_mpq_t(), exact_access::view(x));
}

certified::certified(mpq_class rational, shared unknown, long bits)
    : rational_(std::move(rational)), unknown_(std::move(unknown)), bits_(bits) {
    if (sgn(rational_) == 0) {
        unknown_.reset(); // 0 times a number is 0: every number is finite, even if its interval is not
    }
    limit_length();
}

certified::certified(mpq_class rational, surd root, long bits) : rational_(std::move(rational)), bits_(bits) {
    if (sgn(root.factor) != 0) {
        surd_ = std::make_shared<const surd>(std::move(root));
    }
    limit_length();
}

std::size_t certified::length() const {
    return length_of(rational_) + (surd_ ? length_of(surd_->factor) + length_of(*surd_->radicand) : 0);
}

void certified::limit_length() {
    if (length() > longest_exact) {
        unknown_ = std::make_shared<const mpfi_interval>(around(bits_));
        rational_ = 1;
        surd_.reset();
    }
}

certified certified::quotient(const mpz_class& x, const mpz_class& y, long bits) {
    if (sgn(x) == 0) {
        return {};
    }
    mpfi_interval above(bits), below(bits);
    mpfi_set_z(above.get(), x.get_mpz_t());
    mpfi_set_z(below.get(), y.get_mpz_t());
    return {above / below, bits};
}

certified certified::at(long bits) const {
    certified result(is_exact() ? *this : rounded(bits));
    result.bits_ = bits;
    return result;
}

certified certified::rounded(long bits) const {
    if (is_zero()) {
        return {};
    }
    mpfi_interval around_it(bits);
    mpfi_set(around_it.get(), around(bits).get());
    return {std::move(around_it), bits};
}

certified certified::infinity() {
    mpfi_interval value(2);
    mpfr_set_inf(&value.get()->left, 1);
    mpfr_set_inf(&value.get()->right, 1);
    return {std::move(value), 2};
}

mpfi_interval certified::around(long bits) const {
    if (is_rational()) {
        return {bits, rational_.get_mpq_t()};
    }
    if (!is_exact()) {
        mpfi_interval result(*unknown_);
        if (rational_ != 1) {
            mpfi_mul_q(result.get(), result.get(), rational_.get_mpq_t());
        }
        return result;
    }
    // p and q√d may nearly cancel. But their sum is not 0, so some precision is enough.
    for (long more = bits + 16;; more *= 2) {
        mpfi_interval wide = sqrt(mpfi_interval(more, surd_->radicand->get_mpq_t()));
        mpfi_mul_q(wide.get(), wide.get(), surd_->factor.get_mpq_t());
        mpfi_add_q(wide.get(), wide.get(), rational_.get_mpq_t());
        mpfi_interval result(bits);
        mpfi_set(result.get(), wide.get());
        if (is_narrow(wide, bits)) {
            return result;
        }
    }
}

graze::time_bounds certified::bounds() const {
    const mpfi_interval enclosing = around(64);
    return {mpfr_get_d(enclosing.lower(), MPFR_RNDD), mpfr_get_d(enclosing.upper(), MPFR_RNDU)};
}

bool certified::is_infinite() const { return !is_exact() && mpfr_inf_p(unknown_->lower()) != 0; }

std::optional<int> certified::certain_sign() const {
    if (is_rational()) {
        return sgn(rational_);
    }
    if (is_exact()) {
        const int p = sgn(rational_), q = sgn(surd_->factor);
        return p * q >= 0 ? q : p * sgn(norm());
    }
    const int lower = mpfr_sgn(unknown_->lower()), upper = mpfr_sgn(unknown_->upper());
    if (mpfi_nan_p(unknown_->get()) != 0 || lower != upper) {
        return {};
    }
    return sgn(rational_) * lower;
}

int certified::sign() const {
    const std::optional<int> certain = certain_sign();
    if (!certain) {
        throw undecided_sign();
    }
    return *certain;
}

std::optional<std::shared_ptr<const mpq_class>> certified::field_of(const certified& x, const certified& y) {
    if (!x.surd_ || !y.surd_) {
        return x.surd_ ? x.surd_->radicand : y.surd_ ? y.surd_->radicand : nullptr;
    }
    const auto &d = x.surd_->radicand, &e = y.surd_->radicand;
    return d == e || is_square(mpq_class(*e / *d)) ? std::optional(d) : std::nullopt;
}

mpq_class certified::factor_of(const std::shared_ptr<const mpq_class>& radicand) const {
    if (!surd_ || surd_->radicand == radicand) {
        return surd_ ? surd_->factor : mpq_class(0);
    }
    return surd_->factor * root_of(mpq_class(*surd_->radicand / *radicand));
}

mpq_class certified::norm() const {
    mpq_class square = rational_ * rational_;
    if (surd_) {
        square -= surd_->factor * surd_->factor * *surd_->radicand;
    }
    return square;
}

certified certified::operator-() const {
    if (surd_) {
        return {mpq_class(-rational_), surd{mpq_class(-surd_->factor), surd_->radicand}, bits_};
    }
    return {mpq_class(-rational_), unknown_, bits_};
}

certified operator+(const certified& x, const certified& y) {
    const long bits = std::max(x.bits_, y.bits_);
    if (!x.surd_ && !y.surd_ && x.unknown_ == y.unknown_) {
        return {mpq_class(x.rational_ + y.rational_), x.unknown_, bits};
    }
    if (x.is_zero() || y.is_zero()) {
        return x.is_zero() ? y : x;
    }
    if (x.is_exact() && y.is_exact()) {
        if (const auto d = certified::field_of(x, y)) {
            return {mpq_class(x.rational_ + y.rational_),
                    certified::surd{mpq_class(x.factor_of(*d) + y.factor_of(*d)), *d}, bits};
        }
    }
    return {x.around(bits) + y.around(bits), bits};
}

certified operator*(const certified& x, const certified& y) {
    const long bits = std::max(x.bits_, y.bits_);
    if (!x.surd_ && !y.surd_) {
        if (x.is_rational() || y.is_rational()) {
            return {mpq_class(x.rational_ * y.rational_), x.is_rational() ? y.unknown_ : x.unknown_, bits};
        }
        return certified(*x.unknown_ * *y.unknown_, bits) *
               certified(mpq_class(x.rational_ * y.rational_), nullptr, bits);
    }
    if (x.is_zero() || y.is_zero()) {
        return {};
    }
    if (x.is_exact() && y.is_exact()) {
        if (const auto d = certified::field_of(x, y)) {
            const mpq_class p = x.factor_of(*d), q = y.factor_of(*d);
            return {mpq_class(x.rational_ * y.rational_ + p * q * **d),
                    certified::surd{mpq_class(x.rational_ * q + p * y.rational_), *d}, bits};
        }
    }
    return {x.around(bits) * y.around(bits), bits};
}

certified operator/(const certified& x, const certified& y) {
    const long bits = std::max(x.bits_, y.bits_);
    if (y.is_infinite()) {
        return {};
    }
    if (y.is_zero()) {
        throw std::domain_error("certified: division by zero");
    }
    if (y.surd_) { // x times the inverse of y, by y's conjugate
        const mpq_class norm = y.norm();
        return x * certified(mpq_class(y.rational_ / norm),
                             certified::surd{mpq_class(-y.surd_->factor / norm), y.surd_->radicand}, bits);
    }
    if (x.surd_) {
        return y.is_rational() ? x * certified(mpq_class(1 / y.rational_), nullptr, bits)
                               : certified(x.around(bits) / y.around(bits), bits);
    }
    const mpq_class quotient(x.rational_ / y.rational_);
    if (y.is_rational() || x.unknown_ == y.unknown_) {
        return {quotient, y.is_rational() ? x.unknown_ : nullptr, bits};
    }
    const certified rest(x.is_rational() ? mpfi_interval(bits, mpq_class(1).get_mpq_t()) / *y.unknown_
                                         : *x.unknown_ / *y.unknown_,
                         bits);
    return rest * certified(quotient, nullptr, bits);
}

// (x + y√d)² = p + q√d where the norm p² - q²d is a square s², and (p + s)/2 or (p - s)/2 is x².
std::optional<certified> certified::root_in_field() const {
    const mpq_class square = norm();
    if (sgn(square) < 0 || !is_square(square)) {
        return {};
    }
    const mpq_class s = root_of(square);
    for (const mpq_class& half : {mpq_class((rational_ + s) / 2), mpq_class((rational_ - s) / 2)}) {
        if (sgn(half) > 0 && is_square(half)) {
            const mpq_class x = root_of(half);
            const certified root(x, surd{mpq_class(surd_->factor / (2 * x)), surd_->radicand}, bits_);
            return root.certain_sign() == -1 ? -root : root;
        }
    }
    return {};
}

certified sqrt(const certified& x) {
    if (x.is_rational() && sgn(x.rational_) >= 0) {
        if (is_square(x.rational_)) {
            return {root_of(x.rational_), certified::shared(), x.bits_};
        }
        return {mpq_class(0), certified::surd{mpq_class(1), std::make_shared<const mpq_class>(x.rational_)}, x.bits_};
    }
    if (x.surd_) {
        if (std::optional<certified> root = x.root_in_field()) {
            return *std::move(root);
        }
    }
    return {sqrt(x.interval()), x.bits_};
}

certified larger(const certified& x, const certified& y) {
    if (const std::optional<int> certain = (x - y).certain_sign()) {
        return *certain < 0 ? y : x;
    }
    const long bits = std::max(x.bits_, y.bits_);
    return {larger(x.around(bits), y.around(bits)), bits};
}

certified either(const certified& x, const certified& y) {
    if ((x - y).certain_sign() == 0) {
        return x;
    }
    const long bits = std::max(x.bits_, y.bits_);
    mpfi_interval both(bits);
    mpfi_union(both.get(), x.around(bits).get(), y.around(bits).get());
    return {std::move(both), bits};
}

certified highest(const certified& x) {
    if (x.is_exact()) {
        return x;
    }
    mpfi_interval end = x.interval();
    mpfr_set(&end.get()->left, end.upper(), MPFR_RNDN);
    return {std::move(end), x.bits_};
}

certified not_less(const certified& x) {
    mpfi_interval above = x.interval();
    mpfr_set_inf(&above.get()->right, 1);
    return {std::move(above), x.bits_};
}

double near_double(const certified& x) {
    return x.is_rational() ? x.rational().get_d() : mpfi_get_d(x.around(64).get());
}

} // namespace compare::run
