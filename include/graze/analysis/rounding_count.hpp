// The number of a formula's roundings and the size of its terms: together they bound its rounding error from the very
// numbers that it adds up.
#pragma once

#include <graze/number/traits.hpp>

namespace graze::inline v0_1 {

// How many roundings a term of a formula of sums and products takes at most, in any order of summation. With S the
// value of the formula in term_size, and every rounding within u of its result,
//   |computed - exact| <= ((1 + u)^k - 1) S <= k u/(1 - k u) S,   k = total()
// (Higham, Accuracy and Stability of Numerical Algorithms, 2nd edition, Lemma 3.1): a computed term is a product of
// inputs, with at most one factor 1 + δ or 1/(1 + δ) for each product and each sum on its way. Fused multiply-adds and
// registers of more precision omit roundings. The caller excludes under- and overflow.
struct rounding_count {
    int products = 0; // on the path with the most
    int sums = 0;     // in all

    constexpr rounding_count() = default;
    constexpr rounding_count(int products_, int sums_) : products(products_), sums(sums_) {}
    constexpr explicit rounding_count(int) {} // a constant
    // An input that is exact, and one that is a rounded difference or sum of inputs.
    [[nodiscard]] static constexpr rounding_count exact_input() { return {0, 0}; }
    [[nodiscard]] static constexpr rounding_count rounded_input() { return {0, 1}; }

    [[nodiscard]] constexpr int total() const { return products + sums; }
    // k u/(1 - k u), with room for its own roundings and those of S.
    [[nodiscard]] constexpr double bound(double u) const {
        const double k = total();
        return (1 + 0x1p-40) * k * u / (1 - k * u);
    }

    [[nodiscard]] friend constexpr rounding_count operator-(const rounding_count& x) { return x; }
    [[nodiscard]] friend constexpr rounding_count operator+(const rounding_count& x, const rounding_count& y) {
        return {x.products > y.products ? x.products : y.products, x.sums + y.sums + 1};
    }
    [[nodiscard]] friend constexpr rounding_count operator-(const rounding_count& x, const rounding_count& y) {
        return x + y;
    }
    [[nodiscard]] friend constexpr rounding_count operator*(const rounding_count& x, const rounding_count& y) {
        return {x.products + y.products + 1, x.sums + y.sums};
    }
};

// The sum of the magnitudes of a formula's terms, in doubles.
struct term_size {
    double value = 0;

    constexpr term_size() = default;
    // The size of an input.
    constexpr explicit term_size(double x) noexcept : value(x < 0 ? -x : x) {}
    constexpr explicit term_size(int x) noexcept : value(x < 0 ? -x : x) {}

    [[nodiscard]] friend constexpr term_size operator-(const term_size& x) noexcept { return x; }
    [[nodiscard]] friend constexpr term_size operator+(const term_size& x, const term_size& y) noexcept {
        return unsigned_size(x.value + y.value);
    }
    [[nodiscard]] friend constexpr term_size operator-(const term_size& x, const term_size& y) noexcept {
        return unsigned_size(x.value + y.value);
    }
    [[nodiscard]] friend constexpr term_size operator*(const term_size& x, const term_size& y) noexcept {
        return unsigned_size(x.value * y.value);
    }

  private:
    [[nodiscard]] static constexpr term_size unsigned_size(double x) noexcept {
        term_size r;
        r.value = x;
        return r;
    }
};

template <>
struct number_traits<rounding_count> {
    static constexpr const char* name = "rounding_count";
    static constexpr bool is_exact = false;
    static constexpr int digits = 0;
    static constexpr int sign(const rounding_count&) { return 1; }
    static constexpr rounding_count twice(const rounding_count& x) { return x; }
};
template <>
struct number_traits<term_size> {
    static constexpr const char* name = "term_size";
    static constexpr bool is_exact = false;
    static constexpr int digits = 53;
    static constexpr int sign(const term_size& x) noexcept { return x.value > 0; }
    static constexpr term_size twice(const term_size& x) noexcept { return x + x; }
};

} // namespace graze::inline v0_1
