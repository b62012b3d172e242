// How many bits a formula needs: the rule of integer<Bits> as a number type, without the integers.
#pragma once

#include <graze/number/traits.hpp>

#include <limits>

namespace graze::inline v0_1 {

// Stands for every integer x with |x| < 2^bits. A sum or difference has one bit more than the wider operand, a product
// the bits of both. No result is narrower than its operands, so a formula's width also holds all its intermediate
// numbers. integer<Bits> deduces the same widths.
struct bit_width {
    int bits = 0;

    constexpr bit_width() = default;
    constexpr explicit bit_width(int value) {
        for (unsigned magnitude = value < 0 ? 0U - static_cast<unsigned>(value) : static_cast<unsigned>(value);
             magnitude != 0; magnitude >>= 1) {
            ++bits;
        }
    }
    // Integers x with |x| < 2^count.
    [[nodiscard]] static constexpr bit_width of(int count) {
        bit_width w;
        w.bits = count;
        return w;
    }
};

[[nodiscard]] constexpr bit_width operator-(const bit_width& x) { return x; }
[[nodiscard]] constexpr bit_width operator+(const bit_width& x, const bit_width& y) {
    return bit_width::of((x.bits > y.bits ? x.bits : y.bits) + 1);
}
[[nodiscard]] constexpr bit_width operator-(const bit_width& x, const bit_width& y) { return x + y; }
[[nodiscard]] constexpr bit_width operator*(const bit_width& x, const bit_width& y) {
    return bit_width::of(x.bits + y.bits);
}

template <>
struct number_traits<bit_width> {
    static constexpr const char* name = "bit_width";
    static constexpr bool is_exact = true;
    static constexpr int digits = 0;
    static constexpr int sign(const bit_width& x) { return x.bits != 0 ? 1 : 0; }
};

// The number of bits up to which every integer is a value of T: 24 for float, 53 for double, 31 and 63 for 32-bit and
// 64-bit integers, no limit for a T whose traits say that it is exact.
template <class T>
[[nodiscard]] consteval int exact_bits() {
    if constexpr (std::numeric_limits<T>::is_specialized && std::numeric_limits<T>::is_bounded) {
        static_assert(std::numeric_limits<T>::radix == 2, "exact_bits: not a binary type");
        return std::numeric_limits<T>::digits;
    } else {
        static_assert(number_value<T>, "exact_bits: neither a built-in type nor one that number_traits describes");
        return number_traits<T>::is_exact ? std::numeric_limits<int>::max() : number_traits<T>::digits;
    }
}

// Whether f, run in T, rounds nothing if its inputs are integers of the given widths, or such integers times powers of
// two none of whose products leaves the range of T.
template <class T, class F, class Widths>
[[nodiscard]] consteval bool exact_in(F f, const Widths& inputs) {
    return f(inputs).bits <= exact_bits<T>();
}

} // namespace graze::inline v0_1
