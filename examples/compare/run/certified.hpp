// Numbers of the certified run: exact in a quadratic field as long as possible, then intervals of a given precision.
//
// Formulas run in them unchanged. A decision is a sign, and a sign that an interval leaves open throws. So whatever a
// run decides is proved.
#pragma once

#include "mpfi_interval.hpp"

#include "../problem.hpp"

#include <graze/number/traits.hpp>
#include <graze/scene/mechanics.hpp>

#include <gmpxx.h>

#include <compare>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

namespace compare::run {

// Thrown if the interval around a number contains both signs, or if nothing is known of the number.
struct undecided_sign : graze::undecided {
    undecided_sign() : undecided("a sign at this precision", 0) {}
};

// Either p + q√d with rational p, q and d, exactly, or r X with a rational r and an interval X around an unknown
// number. Numbers of one field Q(√d) give exact results; numbers of two fields give intervals. Copies share X, and
// numbers that share X are added exactly. So what cancels leaves 0: a ball that gives all its velocity to an equal ball
// stops.
class certified {
  public:
    // An exact number becomes an interval if its numerators and denominators together have more bits.
    static constexpr std::size_t longest_exact = std::size_t{1} << 16U;

    certified(int x = 0) : rational_(x) {} // exactly

    // Exact. What is computed from it and cannot be exact is enclosed to at least `bits` bits.
    certified(const exact& x, long bits);

    certified(mpq_class x, long bits) : rational_(std::move(x)), bits_(bits) { limit_length(); }

    [[nodiscard]] static certified quotient(const mpz_class& x, const mpz_class& y, long bits); // enclosed, but for 0
    [[nodiscard]] static certified infinity(); // 1 / infinity() is 0; all else is undecided
    [[nodiscard]] certified enclosed() const { return {interval(), bits_}; } // as an interval from here on

    [[nodiscard]] bool is_exact() const noexcept { return unknown_ == nullptr; }
    [[nodiscard]] bool is_rational() const noexcept { return is_exact() && surd_ == nullptr; }
    [[nodiscard]] const mpq_class& rational() const noexcept { return rational_; } // if is_rational()
    [[nodiscard]] mpfi_interval interval() const { return around(bits_); }         // an interval that contains it
    [[nodiscard]] mpfi_interval around(long bits) const; // the same; around an exact number, to this many bits of it
    [[nodiscard]] graze::time_bounds bounds() const;     // doubles that enclose it
    [[nodiscard]] bool is_infinite() const;

    [[nodiscard]] long bits() const noexcept { return bits_; }
    [[nodiscard]] certified at(long bits) const;      // the same number; what is computed from it has this many bits
    [[nodiscard]] certified rounded(long bits) const; // an interval of this many bits around it
    [[nodiscard]] std::size_t length() const;         // of an exact number: the bits of its integers together

    // -1, 0 or 1; 0 only if the value is 0. If the interval leaves it open: empty, or undecided_sign is thrown.
    [[nodiscard]] std::optional<int> certain_sign() const;
    [[nodiscard]] int sign() const;

    [[nodiscard]] certified operator-() const;
    friend certified operator+(const certified& x, const certified& y);
    friend certified operator-(const certified& x, const certified& y) { return x + -y; }
    friend certified operator*(const certified& x, const certified& y);
    friend certified operator/(const certified& x, const certified& y);
    friend certified sqrt(const certified& x);
    friend certified larger(const certified& x, const certified& y);
    friend certified either(const certified& x, const certified& y);
    friend certified highest(const certified& x);
    friend certified not_less(const certified& x);

    [[nodiscard]] friend bool operator==(const certified& x, const certified& y) { return (x - y).sign() == 0; }
    [[nodiscard]] friend std::strong_ordering operator<=>(const certified& x, const certified& y) {
        return (x - y).sign() <=> 0;
    }

  private:
    using shared = std::shared_ptr<const mpfi_interval>;
    struct surd { // factor √radicand; the factor is not 0, the radicand is positive and no square
        mpq_class factor;
        std::shared_ptr<const mpq_class> radicand;
    };

    certified(mpq_class rational, shared unknown, long bits);
    certified(mpq_class rational, surd root, long bits);
    certified(mpfi_interval unknown, long bits)
        : unknown_(std::make_shared<const mpfi_interval>(std::move(unknown))), bits_(bits) {}

    // d of a field Q(√d) that contains both exact numbers, if there is one; null if both are rational.
    static std::optional<std::shared_ptr<const mpq_class>> field_of(const certified& x, const certified& y);
    [[nodiscard]] mpq_class factor_of(const std::shared_ptr<const mpq_class>& radicand) const; // of √radicand
    [[nodiscard]] std::optional<certified> root_in_field() const;
    [[nodiscard]] mpq_class norm() const; // p² - q²d
    [[nodiscard]] bool is_zero() const { return is_rational() && sgn(rational_) == 0; }
    void limit_length();

    mpq_class rational_ = 1; // p, or r
    std::shared_ptr<const surd> surd_;
    shared unknown_;
    long bits_ = 2; // the precision of intervals computed from it; at first the least that MPFR has
};

// Exact if x is rational or the square of a number of its field. x >= 0.
[[nodiscard]] certified sqrt(const certified& x);

// The larger of the two. If that is open, an enclosure of it.
[[nodiscard]] certified larger(const certified& x, const certified& y);

// One of the two, without saying which: an interval around both, or x if they are certainly equal.
[[nodiscard]] certified either(const certified& x, const certified& y);

// The upper end of the interval around x.
[[nodiscard]] certified highest(const certified& x);

// An unknown number that is not less than x, wherever x is in its interval.
[[nodiscard]] certified not_less(const certified& x);

// A double within a relative 2^-52 of x or, if x is not exact, of the middle of its interval.
[[nodiscard]] double near_double(const certified& x);

} // namespace compare::run

template <>
struct graze::number_traits<compare::run::certified> {
    static constexpr const char* name = "certified";
    static constexpr bool is_exact = false;
    static constexpr int digits = 0; // of any precision
    static compare::run::certified sqrt(const compare::run::certified& x) { return compare::run::sqrt(x); }
    static int sign(const compare::run::certified& x) { return x.sign(); }
};
