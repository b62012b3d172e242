// MPFI's intervals as values (link mpfi and mpfr). Each has its own precision, and a result has the larger precision of
// its operands. (Boost.Multiprecision's mpfi_float takes the precision of every result from a setting of the thread, or
// from the type.)
#pragma once

#include <mpfi.h>

namespace compare::run {

// Two binary numbers of the same precision that enclose the true value. Every operation rounds outwards.
class mpfi_interval {
  public:
    explicit mpfi_interval(mpfr_prec_t bits); // [0, 0]
    mpfi_interval(mpfr_prec_t bits, mpq_srcptr enclosed);
    mpfi_interval(const mpfi_interval& other);
    mpfi_interval(mpfi_interval&& other) noexcept;
    mpfi_interval& operator=(mpfi_interval other) noexcept;
    ~mpfi_interval();

    [[nodiscard]] mpfr_prec_t bits() const { return mpfi_get_prec(value_); }
    [[nodiscard]] mpfi_srcptr get() const noexcept { return value_; }
    [[nodiscard]] mpfi_ptr get() noexcept { return value_; }
    [[nodiscard]] mpfr_srcptr lower() const noexcept { return &value_->left; }
    [[nodiscard]] mpfr_srcptr upper() const noexcept { return &value_->right; }

    [[nodiscard]] mpfi_interval operator-() const;

  private:
    mpfi_t value_; // after a move: precision 0 and no memory
    void release() noexcept;
};

[[nodiscard]] mpfi_interval operator+(const mpfi_interval& x, const mpfi_interval& y);
[[nodiscard]] mpfi_interval operator-(const mpfi_interval& x, const mpfi_interval& y);
[[nodiscard]] mpfi_interval operator*(const mpfi_interval& x, const mpfi_interval& y); // x * x: a square
[[nodiscard]] mpfi_interval operator/(const mpfi_interval& x, const mpfi_interval& y); // by 0: the whole line
[[nodiscard]] mpfi_interval sqrt(const mpfi_interval& x); // NaN if x contains negative numbers

// An enclosure of the larger of the two values.
[[nodiscard]] mpfi_interval larger(const mpfi_interval& x, const mpfi_interval& y);

} // namespace compare::run
