#include "certified.hpp"

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

} // namespace

certified::certified(const exact& x, long bits) : bits_(bits) { set_rational(rational_.get_mpq_t(), x); }

certified::certified(mpq_class rational, shared unknown, long bits)
    : rational_(std::move(rational)), unknown_(std::move(unknown)), bits_(bits) {
    if (sgn(rational_) == 0) {
        unknown_.reset(); // the unknown number is finite, whatever the interval around it is
    } else if (length_of(rational_) > longest_rational) {
        unknown_ = std::make_shared<const mpfi_interval>(around(bits_));
        rational_ = 1;
    }
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
    mpfi_interval result(*unknown_);
    if (rational_ != 1) {
        mpfi_mul_q(result.get(), result.get(), rational_.get_mpq_t());
    }
    return result;
}

graze::time_bounds certified::bounds() const {
    const mpfi_interval enclosing = around(64);
    return {mpfr_get_d(enclosing.lower(), MPFR_RNDD), mpfr_get_d(enclosing.upper(), MPFR_RNDU)};
}

bool certified::is_infinite() const { return !is_rational() && mpfr_inf_p(unknown_->lower()) != 0; }

std::optional<int> certified::certain_sign() const {
    if (is_rational()) {
        return sgn(rational_);
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

certified operator+(const certified& x, const certified& y) {
    const long bits = std::max(x.bits_, y.bits_);
    if (x.unknown_ == y.unknown_) {
        return {mpq_class(x.rational_ + y.rational_), x.unknown_, bits};
    }
    if ((x.is_rational() && sgn(x.rational_) == 0) || (y.is_rational() && sgn(y.rational_) == 0)) {
        return x.is_rational() && sgn(x.rational_) == 0 ? y : x;
    }
    return {x.around(bits) + y.around(bits), bits};
}

certified operator*(const certified& x, const certified& y) {
    const long bits = std::max(x.bits_, y.bits_);
    if (x.is_rational() || y.is_rational()) {
        return {mpq_class(x.rational_ * y.rational_), x.is_rational() ? y.unknown_ : x.unknown_, bits};
    }
    return certified(*x.unknown_ * *y.unknown_, bits) * certified(mpq_class(x.rational_ * y.rational_), {}, bits);
}

certified operator/(const certified& x, const certified& y) {
    const long bits = std::max(x.bits_, y.bits_);
    if (y.is_infinite()) {
        return {};
    }
    if (sgn(y.rational_) == 0) {
        throw std::domain_error("certified: division by zero");
    }
    const mpq_class quotient(x.rational_ / y.rational_);
    if (y.is_rational() || x.unknown_ == y.unknown_) {
        return {quotient, y.is_rational() ? x.unknown_ : nullptr, bits};
    }
    const certified rest(x.is_rational() ? mpfi_interval(bits, mpq_class(1).get_mpq_t()) / *y.unknown_
                                         : *x.unknown_ / *y.unknown_,
                         bits);
    return rest * certified(quotient, {}, bits);
}

certified sqrt(const certified& x) {
    if (x.is_rational() && is_square(x.rational_)) {
        mpq_class root;
        mpz_sqrt(root.get_num_mpz_t(), x.rational_.get_num_mpz_t());
        mpz_sqrt(root.get_den_mpz_t(), x.rational_.get_den_mpz_t());
        return {std::move(root), {}, x.bits_};
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

double near_double(const certified& x) {
    return x.is_rational() ? x.rational().get_d() : mpfi_get_d(x.interval().get());
}

} // namespace compare::run
