// Sums and products of sparse integers' digits, compiled once for all widths. Otherwise a program with exact decisions
// would spend most of its compile time on these loops, again and again.
#pragma once

#include <graze/machine/wide_multiply.hpp>

#include <algorithm>
#include <bit>
#include <cstdint>

namespace graze::inline v0_1::detail {

// A non-owning view of Σ digit_i 2^(64 position_i), positions ascending.
struct sparse_digits {
    int count;
    const std::int16_t* position;
    const std::int64_t* digit;
};

// A non-owning output for digits, from the lowest on. It omits zeros. There is room for all digits.
struct sparse_output {
    int count;
    std::int16_t* position;
    std::int64_t* digit;

    constexpr void append(int where, std::int64_t value) noexcept {
        if (value != 0) {
            position[count] = static_cast<std::int16_t>(where);
            digit[count] = value;
            ++count;
        }
    }
};

// Writes the digits of x.
[[nodiscard, gnu::noinline]] constexpr int copy_digits(const sparse_digits& x, sparse_output r) noexcept {
    for (int i = 0; i < x.count; ++i) {
        r.position[i] = x.position[i];
        r.digit[i] = x.digit[i];
    }
    return x.count;
}

// Writes x + factor·y for factor 1 or -1, digit by digit from the lowest on. Returns the number of digits.
[[nodiscard, gnu::noinline]] constexpr int add_digits(const sparse_digits& x, const sparse_digits& y, int factor,
                                                      sparse_output r) noexcept {
    int i = 0;
    int j = 0;
    std::int64_t carry = 0;
    int carry_position = 0;
    while (i < x.count || j < y.count || carry != 0) {
        int p = carry != 0 ? carry_position : 0x7fff;
        p = i < x.count ? std::min<int>(p, x.position[i]) : p;
        p = j < y.count ? std::min<int>(p, y.position[j]) : p;
        const std::int64_t from_x = i < x.count && x.position[i] == p ? x.digit[i++] : 0;
        const std::int64_t from_y = j < y.count && y.position[j] == p ? y.digit[j++] : 0;
        const std::int64_t carried = carry != 0 && carry_position == p ? carry : 0;
        const auto t = multiply_add_balanced(from_y, factor, from_x, carried);
        r.append(p, t.low);
        carry = t.high;
        carry_position = p + 1;
    }
    return r.count;
}

// Adds up digits in place, with a mask of the positions that are in use. It owns neither.
class digit_accumulator {
  public:
    constexpr digit_accumulator(std::uint64_t* touched, std::int64_t* sum) noexcept : touched_(touched), sum_(sum) {}

    // Adds x·y, row by row. By value, so that the compiler knows that no write changes the views.
    [[gnu::noinline]] constexpr void add_product(sparse_digits x, sparse_digits y) noexcept {
        digit_accumulator here = *this;
        for (int i = 0; i < x.count; ++i) {
            const std::int64_t factor = x.digit[i];
            const int row = x.position[i];
            std::int64_t carry = 0;
            int next = -1;
            for (int j = 0; j < y.count; ++j) {
                const int p = row + y.position[j];
                if (p != next) {
                    here.deposit(next, carry);
                    carry = 0;
                }
                const auto t = multiply_add_balanced(factor, y.digit[j], here.at(p), carry);
                here.sum_[p] = t.low;
                carry = t.high;
                next = p + 1;
            }
            here.deposit(next, carry);
        }
    }

    // Writes the sum, from the first `words` words of the mask.
    [[nodiscard, gnu::noinline]] constexpr int write(int words, sparse_output r) const noexcept {
        for (int word = 0; word < words; ++word) {
            for (std::uint64_t rest = touched_[word]; rest != 0; rest &= rest - 1) {
                const int p = 64 * word + std::countr_zero(rest);
                r.append(p, sum_[p]);
            }
        }
        return r.count;
    }

  private:
    // The digit at p; 0 at the first use of p.
    [[nodiscard]] constexpr std::int64_t at(int p) noexcept {
        const std::uint64_t bit = std::uint64_t{1} << (p % 64);
        std::uint64_t& word = touched_[p / 64];
        if ((word & bit) == 0) {
            word |= bit;
            return 0;
        }
        return sum_[p];
    }

    constexpr void deposit(int p, std::int64_t carry) noexcept {
        while (carry != 0) {
            const auto t = multiply_add_balanced(0, 0, at(p), carry);
            sum_[p++] = t.low;
            carry = t.high;
        }
    }

    std::uint64_t* touched_;
    std::int64_t* sum_;
};

} // namespace graze::inline v0_1::detail
