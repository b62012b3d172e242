// A rational number for constant expressions, for proofs about scenes.
#pragma once

#include <graze/number/traits.hpp>

#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace graze::proof {

// numerator/denominator in lowest terms, denominator > 0. Exact. A number that needs more than 63 bits throws, and so
// does not compile in a constant expression.
class rational {
  public:
    constexpr rational(int value = 0) : numerator_(value) {}
    constexpr rational(std::int64_t numerator, std::int64_t denominator) : numerator_(numerator) {
        if (denominator == 1) { // most numbers are whole, and compilers count every step
            return;
        }
        if (denominator == 0) {
            throw std::domain_error("rational: division by zero");
        }
        const std::int64_t divisor = std::gcd(numerator, denominator) * (denominator < 0 ? -1 : 1);
        numerator_ = numerator / divisor;
        denominator_ = denominator / divisor;
    }

    [[nodiscard]] friend constexpr bool operator==(const rational&, const rational&) = default;
    [[nodiscard]] friend constexpr bool operator<(const rational& x, const rational& y) {
        return (x - y).numerator_ < 0;
    }

    [[nodiscard]] constexpr rational operator-() const { return {-numerator_, denominator_}; }
    [[nodiscard]] friend constexpr rational operator+(const rational& x, const rational& y) {
        const std::int64_t divisor =
            x.denominator_ == 1 || y.denominator_ == 1 ? 1 : std::gcd(x.denominator_, y.denominator_);
        const std::int64_t left = product(x.numerator_, y.denominator_ / divisor);
        const std::int64_t right = product(y.numerator_, x.denominator_ / divisor);
        if (right > 0 ? left > largest - right : left < -largest - right) {
            throw std::overflow_error("rational: more than 63 bits");
        }
        return {left + right, product(x.denominator_, y.denominator_ / divisor)};
    }
    [[nodiscard]] friend constexpr rational operator-(const rational& x, const rational& y) { return x + -y; }
    [[nodiscard]] friend constexpr rational operator*(const rational& x, const rational& y) {
        const rational p(x.numerator_, y.denominator_); // reduced before the product, so that it does not overflow
        const rational q(y.numerator_, x.denominator_);
        return {product(p.numerator_, q.numerator_), product(p.denominator_, q.denominator_)};
    }
    [[nodiscard]] friend constexpr rational operator/(const rational& x, const rational& y) {
        return x * rational(y.denominator_, y.numerator_);
    }

  private:
    static constexpr std::int64_t largest = std::numeric_limits<std::int64_t>::max();
    [[nodiscard]] static constexpr std::int64_t product(std::int64_t x, std::int64_t y) {
        const auto magnitude = [](std::int64_t v) { return v < 0 ? -v : v; };
        if (y != 0 && magnitude(x) > largest / magnitude(y)) {
            throw std::overflow_error("rational: more than 63 bits");
        }
        return x * y;
    }

    std::int64_t numerator_;
    std::int64_t denominator_ = 1;
};

} // namespace graze::proof

template <>
struct graze::number_traits<graze::proof::rational> {
    static constexpr const char* name = "rational";
    static constexpr bool is_exact = true;
    static constexpr int digits = 0;
};
