// Numbers of the certified run: exact in a quadratic field as long as they can be, intervals of a given precision from
// then on.
//
// A formula runs in them as it is. Its decisions are signs; one that an interval leaves open throws, so that whatever a
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

// The interval around a number has both signs, or none that is known.
struct undecided_sign : graze::undecided {
    undecided_sign() : undecided("a sign at this precision", 0) {}
};

// p + q√d with rational p, q and d, exactly; or r X with a rational r and an interval X around an unknown number. Exact
// numbers of one field Q(√d) are computed with exactly; of two fields, in intervals. Copies share X, and what shares
// one is added exactly, so that what cancels leaves 0 (a ball that gives all its velocity to an equal one stops).
class certified {
  public:
    // An exact number of more bits than this, numerators and denominators together, becomes an interval.
    static constexpr std::size_t longest_exact = std::size_t{1} << 16U;

    certified(int x = 0) : rational_(x) {} // exactly

    // Exactly; what is computed with it and cannot be exact is enclosed to `bits` bits or more.
    certified(const exact& x, long bits);

    certified(mpq_class x, long bits) : rational_(std::move(x)), bits_(bits) { limit_length(); }

    [[nodiscard]] static certified quotient(const mpz_class& x, const mpz_class& y, long bits); // enclosed, but for 0
    [[nodiscard]] static certified infinity(); // 1 / infinity() is 0; anything else with it is undecided
    [[nodiscard]] certified enclosed() const { return {interval(), bits_}; } // the same, as an interval from here on

    [[nodiscard]] bool is_exact() const noexcept { return unknown_ == nullptr; }
    [[nodiscard]] bool is_rational() const noexcept { return is_exact() && surd_ == nullptr; }
    [[nodiscard]] const mpq_class& rational() const noexcept { return rational_; } // if it is one
    [[nodiscard]] mpfi_interval interval() const { return around(bits_); }         // around it, whatever it is
    [[nodiscard]] mpfi_interval around(long bits) const; // likewise; of an exact number, to so many bits of it
    [[nodiscard]] graze::time_bounds bounds() const;     // doubles that enclose it
    [[nodiscard]] bool is_infinite() const;

    [[nodiscard]] long bits() const noexcept { return bits_; }
    [[nodiscard]] certified at(long bits) const;      // the same; what is computed with it has so many bits
    [[nodiscard]] certified rounded(long bits) const; // an interval of so many bits around it
    [[nodiscard]] std::size_t length() const;         // of an exact number: the bits of its integers

    // -1, 0 or 1; 0 for the value 0 alone; empty or undecided_sign where the interval leaves it open.
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
    struct surd { // factor √radicand; the factor is not 0, the radicand positive and no square
        mpq_class factor;
        std::shared_ptr<const mpq_class> radicand;
    };

    certified(mpq_class rational, shared unknown, long bits);
    certified(mpq_class rational, surd root, long bits);
    certified(mpfi_interval unknown, long bits)
        : unknown_(std::make_shared<const mpfi_interval>(std::move(unknown))), bits_(bits) {}

    // d of the field Q(√d) in which both exact numbers are, if there is one; null for two rationals.
    static std::optional<std::shared_ptr<const mpq_class>> field_of(const certified& x, const certified& y);
    [[nodiscard]] mpq_class factor_of(const std::shared_ptr<const mpq_class>& radicand) const; // of √radicand
    [[nodiscard]] std::optional<certified> root_in_field() const;
    [[nodiscard]] mpq_class norm() const; // p² - q²d
    [[nodiscard]] bool is_zero() const { return is_rational() && sgn(rational_) == 0; }
    void limit_length();

    mpq_class rational_ = 1; // p, or r
    std::shared_ptr<const surd> surd_;
    shared unknown_;
    long bits_ = 2; // what an interval that is made of it has; MPFR's least
};

// Exact where x is rational, or the square of a number of its field; x >= 0.
[[nodiscard]] certified sqrt(const certified& x);

// The larger of the two; where that is open, an enclosure of it.
[[nodiscard]] certified larger(const certified& x, const certified& y);

// One of the two, it is not known which: an enclosure of both, or x where they are certainly equal.
[[nodiscard]] certified either(const certified& x, const certified& y);

// The upper end of the interval around x.
[[nodiscard]] certified highest(const certified& x);

// An unknown number that is not less than x, whatever is in the interval around x.
[[nodiscard]] certified not_less(const certified& x);

// A double within 2^-52 of x, relatively, or of the middle of the interval around it.
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
