#include "mpfi_interval.hpp"

#include <algorithm>
#include <utility>

namespace compare::run {

mpfi_interval::mpfi_interval(mpfr_prec_t bits) {
    mpfi_init2(value_, bits);
    mpfi_set_ui(value_, 0);
}

mpfi_interval::mpfi_interval(mpfr_prec_t bits, mpq_srcptr enclosed) {
    mpfi_init2(value_, bits);
    mpfi_set_q(value_, enclosed);
}

mpfi_interval::mpfi_interval(const mpfi_interval& other) {
    mpfi_init2(value_, other.bits());
    mpfi_set(value_, other.value_);
}

mpfi_interval::mpfi_interval(mpfi_interval&& other) noexcept {
    *value_ = *other.value_;
    other.release();
}

mpfi_interval& mpfi_interval::operator=(mpfi_interval other) noexcept {
    std::swap(*value_, *other.value_);
    return *this;
}

mpfi_interval::~mpfi_interval() {
    if (value_->left._mpfr_d != nullptr) {
        mpfi_clear(value_);
    }
}

void mpfi_interval::release() noexcept { value_->left._mpfr_d = value_->right._mpfr_d = nullptr; }

namespace {

template <class F>
mpfi_interval result_of(F operation, const mpfi_interval& x, const mpfi_interval& y) {
    mpfi_interval result(std::max(x.bits(), y.bits()));
    operation(result.get(), x.get(), y.get());
    return result;
}

} // namespace

mpfi_interval mpfi_interval::operator-() const {
    mpfi_interval result(bits());
    mpfi_neg(result.value_, value_);
    return result;
}

mpfi_interval operator+(const mpfi_interval& x, const mpfi_interval& y) { return result_of(mpfi_add, x, y); }
mpfi_interval operator-(const mpfi_interval& x, const mpfi_interval& y) { return result_of(mpfi_sub, x, y); }

mpfi_interval operator*(const mpfi_interval& x, const mpfi_interval& y) {
    if (&x == &y) { // both factors are the same number, so the square is not negative
        mpfi_interval result(x.bits());
        mpfi_sqr(result.get(), x.get());
        return result;
    }
    return result_of(mpfi_mul, x, y);
}

mpfi_interval operator/(const mpfi_interval& x, const mpfi_interval& y) { return result_of(mpfi_div, x, y); }

mpfi_interval sqrt(const mpfi_interval& x) {
    mpfi_interval result(x.bits());
    mpfi_sqrt(result.get(), x.get());
    return result;
}

mpfi_interval larger(const mpfi_interval& x, const mpfi_interval& y) {
    mpfi_interval result(std::max(x.bits(), y.bits()));
    mpfr_max(&result.get()->left, x.lower(), y.lower(), MPFR_RNDD);
    mpfr_max(&result.get()->right, x.upper(), y.upper(), MPFR_RNDU);
    return result;
}

} // namespace compare::run
