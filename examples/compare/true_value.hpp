// The exact value of a quantity, p + q√d, and how far a computed one is from it.
#pragma once

#include "wide.hpp"

#include <graze/number/sqrt_extension.hpp>

#include <optional>
#include <variant>

namespace compare {

using exact_real = graze::sqrt_extension<exact>;

// x with its root evaluated if that is rational. So q is 0 if and only if x is rational.
[[nodiscard]] exact_real simplified(const exact_real& x);

// Whether x and y are the same real number, even over different roots.
[[nodiscard]] bool equal(const exact_real& x, const exact_real& y);

// Square roots of rationals to 2^-890. It remembers the last one, since the values of one pair share it.
class root_memory {
  public:
    [[nodiscard]] const wide& root_of(const exact& d);

  private:
    exact d_ = 0;
    wide root_ = 0;
};

// x to 2^-880; uses its conjugate where p and q√d would cancel.
[[nodiscard]] wide to_wide(const exact_real& x, root_memory& roots);

class true_value {
  public:
    true_value() = default;
    true_value(const exact_real& x, root_memory& roots);

    [[nodiscard]] const exact_real& exactly() const noexcept { return exactly_; }
    [[nodiscard]] const wide& value() const noexcept { return value_; } // relative error below 2^-880
    [[nodiscard]] bool is_value() const noexcept { return is_value_; }  // value() is the exact value
    [[nodiscard]] double nearest() const noexcept { return nearest_; }  // correctly rounded, ties to even

  private:
    exact_real exactly_;
    wide value_ = 0;
    bool is_value_ = true;
    double nearest_ = 0;
};

// The forms in which a number type's value is known exactly.
struct not_finite {};
struct exactly_right {}; // it is the exact value itself
struct interval {
    wide low, high;
};

// The members are not inline, so that they are compiled once instead of in every number type's translation unit.
class computed {
  public:
    using value_type = std::variant<wide, exact_real, interval, not_finite, exactly_right>;

    computed(wide x);
    computed(exact_real x);
    computed(interval x);
    computed(not_finite x);
    computed(exactly_right x);
    computed(const computed& other);
    computed(computed&& other) noexcept;
    computed& operator=(const computed& other);
    computed& operator=(computed&& other) noexcept;
    ~computed();

    [[nodiscard]] const value_type& value() const noexcept { return value_; }

  private:
    value_type value_;
};

// |x - t|, for an interval that of its farther end; 0 exactly if x is t. The relative error is below 2^-100. If x
// agrees with an irrational t to 2^-780, the result is that much of t, an upper bound. Empty if x is not finite.
[[nodiscard]] std::optional<wide> distance(const computed& x, const true_value& t);

// Whether x and t round to the same double.
[[nodiscard]] bool rounds_correctly(const computed& x, const true_value& t);

// Whether t lies in the interval x.
[[nodiscard]] bool encloses(const interval& x, const true_value& t);

// An approximation of x, which stands for t, to at least 2^-880; for an interval its middle.
[[nodiscard]] wide middle(const computed& x, const true_value& t);

} // namespace compare
