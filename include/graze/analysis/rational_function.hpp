// Quotients of polynomials, for formulas with a division.
#pragma once

#include <graze/analysis/polynomial.hpp>

namespace graze::inline v0_1 {

// numerator/denominator, never reduced; == cross-multiplies. Division by the zero polynomial throws.
template <int Terms = 256>
class rational_function {
  public:
    using polynomial = graze::polynomial<Terms>;
    constexpr rational_function() = default;
    constexpr rational_function(int value) : numerator_(value) {}
    constexpr rational_function(polynomial value) : numerator_(std::move(value)) {}
    constexpr rational_function(polynomial numerator, polynomial denominator)
        : numerator_(std::move(numerator)), denominator_(std::move(denominator)) {
        if (denominator_ == polynomial(0)) {
            throw std::domain_error("rational_function: division by zero");
        }
    }

    [[nodiscard]] constexpr const polynomial& numerator() const noexcept { return numerator_; }
    [[nodiscard]] constexpr const polynomial& denominator() const noexcept { return denominator_; }

    [[nodiscard]] friend constexpr bool operator==(const rational_function& x, const rational_function& y) {
        return x.numerator_ * y.denominator_ == y.numerator_ * x.denominator_;
    }

    [[nodiscard]] constexpr rational_function operator-() const { return {-numerator_, denominator_}; }
    [[nodiscard]] friend constexpr rational_function operator+(const rational_function& x, const rational_function& y) {
        if (x.denominator_ == y.denominator_) {
            return {x.numerator_ + y.numerator_, x.denominator_};
        }
        return {x.numerator_ * y.denominator_ + y.numerator_ * x.denominator_, x.denominator_ * y.denominator_};
    }
    [[nodiscard]] friend constexpr rational_function operator-(const rational_function& x, const rational_function& y) {
        return x + -y;
    }
    [[nodiscard]] friend constexpr rational_function operator*(const rational_function& x, const rational_function& y) {
        return {x.numerator_ * y.numerator_, x.denominator_ * y.denominator_};
    }
    [[nodiscard]] friend constexpr rational_function operator/(const rational_function& x, const rational_function& y) {
        return {x.numerator_ * y.denominator_, x.denominator_ * y.numerator_};
    }

  private:
    polynomial numerator_;
    polynomial denominator_{1};
};

template <int Terms>
struct number_traits<rational_function<Terms>> {
    static constexpr const char* name = "rational_function";
    static constexpr bool is_exact = true;
    static constexpr int digits = 0;
    static constexpr int sign(const rational_function<Terms>& x) {
        return x.numerator().sign() * x.denominator().sign();
    }
};

} // namespace graze::inline v0_1
