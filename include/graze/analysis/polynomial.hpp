// Polynomials in several variables over the integers: a formula that runs in them yields the equation itself.
#pragma once

#include <graze/number/traits.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

namespace graze::inline v0_1 {

// A sum of up to Terms terms c·x₀^e₀·...·x₁₅^e₁₅ in canonical form: == is equality of polynomials. It is exact. A
// coefficient of more than 63 bits, an exponent above 15 or one term too many throws std::overflow_error; in a constant
// expression it does not compile. No memory is allocated: in constant expressions, g++ 12 destroys arrays of elements
// that own memory twice.
template <int Terms = 256>
class polynomial {
  public:
    static constexpr int variables = 16;
    static constexpr int highest_exponent = 15;

    constexpr polynomial() = default;
    constexpr polynomial(int value) {
        if (value != 0) {
            append({0, value});
        }
    }
    // The variable x_index.
    [[nodiscard]] static constexpr polynomial variable(int index) {
        if (index < 0 || index >= variables) {
            throw std::out_of_range("polynomial: no such variable");
        }
        polynomial x;
        x.append({std::uint64_t{1} << 4 * index, 1});
        return x;
    }

    [[nodiscard]] friend constexpr bool operator==(const polynomial& x, const polynomial& y) {
        for (std::size_t i = 0; i < x.size_ && i < y.size_; ++i) {
            if (x.terms_[i] != y.terms_[i]) {
                return false;
            }
        }
        return x.size_ == y.size_;
    }

    [[nodiscard]] constexpr polynomial operator-() const {
        polynomial r;
        for (std::size_t i = 0; i < size_; ++i) {
            r.append({terms_[i].exponents, -terms_[i].coefficient});
        }
        return r;
    }
    [[nodiscard]] friend constexpr polynomial operator+(const polynomial& x, const polynomial& y) {
        return merged(x, y, 1);
    }
    [[nodiscard]] friend constexpr polynomial operator-(const polynomial& x, const polynomial& y) {
        return merged(x, y, -1);
    }
    [[nodiscard]] friend constexpr polynomial operator*(const polynomial& x, const polynomial& y) {
        return x.size_ == 0 || y.size_ == 0 ? polynomial() : product_of(x, 0, x.size_, y);
    }

    // The sign of its values where all variables are positive, if the signs of its coefficients determine it; otherwise
    // std::domain_error is thrown. So a formula with a case distinction runs in the case that its arguments imply.
    [[nodiscard]] constexpr int sign() const {
        bool positive = false;
        bool negative = false;
        for (std::size_t i = 0; i < size_; ++i) {
            (terms_[i].coefficient > 0 ? positive : negative) = true;
        }
        if (positive && negative) {
            throw std::domain_error("polynomial: its sign depends on its variables");
        }
        return positive ? 1 : negative ? -1 : 0;
    }

    // The polynomial with x_index replaced: `with` replaces it everywhere, with_square replaces its square.
    [[nodiscard]] constexpr polynomial with(int index, const polynomial& value) const {
        return replaced(index, 1, value);
    }
    [[nodiscard]] constexpr polynomial with_square(int index, const polynomial& square) const {
        return replaced(index, 2, square);
    }

  private:
    struct term {
        std::uint64_t exponents; // four bits for each variable: a product of monomials is a sum of these
        std::int64_t coefficient;
        [[nodiscard]] friend constexpr bool operator==(const term&, const term&) = default;
    };

    static constexpr std::int64_t largest = std::numeric_limits<std::int64_t>::max();
    [[nodiscard]] static constexpr std::int64_t magnitude(std::int64_t x) { return x < 0 ? -x : x; }

    [[nodiscard]] static constexpr std::int64_t sum(std::int64_t x, std::int64_t y) {
        if (y > 0 ? x > largest - y : x < -largest - y) {
            throw std::overflow_error("polynomial: a coefficient of more than 63 bits");
        }
        return x + y;
    }
    [[nodiscard]] static constexpr term product(const term& x, const term& y) {
        if (magnitude(x.coefficient) > largest / magnitude(y.coefficient)) {
            throw std::overflow_error("polynomial: a coefficient of more than 63 bits");
        }
        const std::uint64_t exponents = x.exponents + y.exponents;
        if (exponents < x.exponents || ((x.exponents ^ y.exponents ^ exponents) & 0x1111111111111110U) != 0) {
            throw std::overflow_error("polynomial: an exponent above 15");
        }
        return {exponents, x.coefficient * y.coefficient};
    }

    [[nodiscard]] static constexpr polynomial merged(const polynomial& x, const polynomial& y, int sign_of_y) {
        polynomial r;
        std::size_t i = 0;
        std::size_t j = 0;
        while (i < x.size_ || j < y.size_) {
            if (j == y.size_ || (i < x.size_ && x.terms_[i].exponents < y.terms_[j].exponents)) {
                r.append(x.terms_[i++]);
            } else if (i == x.size_ || y.terms_[j].exponents < x.terms_[i].exponents) {
                r.append({y.terms_[j].exponents, sign_of_y * y.terms_[j].coefficient});
                ++j;
            } else {
                const std::int64_t c = sum(x.terms_[i].coefficient, sign_of_y * y.terms_[j].coefficient);
                if (c != 0) {
                    r.append({x.terms_[i].exponents, c});
                }
                ++i;
                ++j;
            }
        }
        return r;
    }

    // Terms [from, to) of x, multiplied by y.
    [[nodiscard]] static constexpr polynomial product_of(const polynomial& x, std::size_t from, std::size_t to,
                                                         const polynomial& y) {
        if (to - from > 1) {
            const std::size_t middle = from + (to - from) / 2;
            return product_of(x, from, middle, y) + product_of(x, middle, to, y);
        }
        polynomial r;
        for (std::size_t j = 0; j < y.size_; ++j) {
            r.append(product(x.terms_[from], y.terms_[j]));
        }
        return r;
    }

    [[nodiscard]] constexpr polynomial replaced(int index, int power, const polynomial& value) const {
        polynomial r;
        for (int exponent = highest_exponent / power; exponent >= 0; --exponent) { // Horner's rule in value
            polynomial factor;
            for (std::size_t i = 0; i < size_; ++i) {
                const int here = static_cast<int>(terms_[i].exponents >> 4 * index & 15U);
                if (here / power == exponent) {
                    polynomial one_term;
                    one_term.append({terms_[i].exponents - (static_cast<std::uint64_t>(exponent * power) << 4 * index),
                                     terms_[i].coefficient});
                    factor = factor + one_term;
                }
            }
            r = r * value + factor;
        }
        return r;
    }

    constexpr void append(const term& t) {
        if (size_ == terms_.size()) {
            throw std::overflow_error("polynomial: too many terms");
        }
        terms_[size_++] = t;
    }

    std::size_t size_ = 0;
    std::array<term, static_cast<std::size_t>(Terms)> terms_{}; // by ascending exponents, without zero coefficients
};

template <int Terms>
struct number_traits<polynomial<Terms>> {
    static constexpr const char* name = "polynomial";
    static constexpr bool is_exact = true;
    static constexpr int digits = 0;
    static constexpr int sign(const polynomial<Terms>& x) { return x.sign(); }
    static constexpr polynomial<Terms> fma(const polynomial<Terms>& x, const polynomial<Terms>& y,
                                           const polynomial<Terms>& z) {
        return x * y + z;
    }
};

} // namespace graze::inline v0_1
