// Numbers of the certified run: exact rationals as long as they can be, intervals of a given precision from then on.
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
struct undecided_sign : std::runtime_error {
    undecided_sign() : std::runtime_error("a sign is undecided at this precision") {}
};

// r, or r X with a rational r and an interval X around an unknown number. Copies share X, and what shares one is added
// exactly, so that what cancels leaves 0 (a ball that gives all its velocity to an equal one stops).
class certified {
  public:
    // A rational of more bits than this, numerator and denominator together, becomes an interval.
    static constexpr std::size_t longest_rational = std::size_t{1} << 16U;

    certified(int x = 0) : rational_(x) {} // exactly

    // Exactly; what is computed with it and is no rational is enclosed to `bits` bits or more.
    certified(const exact& x, long bits);

    [[nodiscard]] static certified infinity(); // 1 / infinity() is 0; anything else with it is undecided
    [[nodiscard]] certified enclosed() const { return {interval(), bits_}; } // the same, as an interval from here on

    [[nodiscard]] bool is_rational() const noexcept { return unknown_ == nullptr; }
    [[nodiscard]] const mpq_class& rational() const noexcept { return rational_; } // if it is one
    [[nodiscard]] mpfi_interval interval() const { return around(bits_); }         // around it, whatever it is
    [[nodiscard]] graze::time_bounds bounds() const;                               // doubles that enclose it
    [[nodiscard]] bool is_infinite() const;

    // -1, 0 or 1; 0 for the value 0 alone; empty or undecided_sign where the interval leaves it open.
    [[nodiscard]] std::optional<int> certain_sign() const;
    [[nodiscard]] int sign() const;

    [[nodiscard]] certified operator-() const { return {mpq_class(-rational_), unknown_, bits_}; }
    friend certified operator+(const certified& x, const certified& y);
    friend certified operator-(const certified& x, const certified& y) { return x + -y; }
    friend certified operator*(const certified& x, const certified& y);
    friend certified operator/(const certified& x, const certified& y);
    friend certified sqrt(const certified& x);
    friend certified larger(const certified& x, const certified& y);

    [[nodiscard]] friend bool operator==(const certified& x, const certified& y) { return (x - y).sign() == 0; }
    [[nodiscard]] friend std::strong_ordering operator<=>(const certified& x, const certified& y) {
        return (x - y).sign() <=> 0;
    }

  private:
    using shared = std::shared_ptr<const mpfi_interval>;

    certified(mpq_class rational, shared unknown, long bits);
    certified(mpfi_interval unknown, long bits)
        : unknown_(std::make_shared<const mpfi_interval>(std::move(unknown))), bits_(bits) {}

    [[nodiscard]] mpfi_interval around(long bits) const; // of a rational, to so many bits

    mpq_class rational_ = 1;
    shared unknown_;
    long bits_ = 2; // what an interval that is made of it has; MPFR's least
};

[[nodiscard]] certified sqrt(const certified& x); // rational where x is a rational's square; x >= 0

// The larger of the two; where that is open, an enclosure of it.
[[nodiscard]] certified larger(const certified& x, const certified& y);

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
