// Integers whose width is in their type: sums and products are wider types, so that overflow is impossible.
#pragma once

#include <graze/machine/failure.hpp>
#include <graze/machine/wide_multiply.hpp>
#include <graze/number/traits.hpp>

#include <array>
#include <bit>
#include <compare>
#include <concepts>
#include <cstdint>
#include <utility>

namespace graze::inline v0_1 {

namespace detail {

// f(0), ..., f(Count - 1), unrolled if there are few: at -O2 compilers keep such loops, which cost more than the work.
template <int Count, class F>
constexpr void repeat(F f) {
    if constexpr (Count <= 5) {
        [&]<int... I>(std::integer_sequence<int, I...>) { (f(I), ...); }
        (std::make_integer_sequence<int, Count>{});
    } else {
        for (int i = 0; i < Count; ++i) {
            f(i);
        }
    }
}

} // namespace detail

// An integer x with |x| < 2^Bits. It is exact and constexpr and never allocates. A sum or difference has one bit more
// than the wider operand, a product the bits of both. Two's complement in 64-bit limbs, lowest first.
template <int Bits>
class integer {
    static_assert(Bits >= 1, "graze::integer: at least one bit");

  public:
    static constexpr int bits = Bits;
    static constexpr int limbs = Bits / 64 + 1;

    constexpr integer() noexcept = default;

    // From a type all of whose values fit.
    template <std::signed_integral I>
    requires(sizeof(I) <= 8 && Bits >= 8 * static_cast<int>(sizeof(I))) constexpr integer(I value) noexcept {
        fill(static_cast<std::int64_t>(value));
    }
    // From a constant. One that does not fit does not compile.
    template <std::same_as<int> I>
    requires(Bits < 8 * static_cast<int>(sizeof(int))) consteval integer(I value) {
        if (value >> Bits != (value < 0 ? -1 : 0) || -value >> Bits != (value > 0 ? -1 : 0)) {
            detail::fail<std::logic_error>("graze::integer: the constant does not fit");
        }
        fill(value);
    }

    // From a narrower integer.
    template <int B>
    requires(B < Bits) constexpr integer(const integer<B>& x) noexcept {
        detail::repeat<limbs>([&](int i) { limb_[static_cast<unsigned>(i)] = x.limb(i); });
    }

    // significand · 2^shift, shift >= 0. The caller guarantees that it fits.
    [[nodiscard]] static constexpr integer from_shifted(std::int64_t significand, int shift) noexcept {
        integer x;
        if constexpr (limbs == 1) {
            x.limb_[0] = static_cast<std::uint64_t>(significand) << shift;
        } else if constexpr (limbs == 2) {
            const auto value = static_cast<std::uint64_t>(significand);
            const auto above = static_cast<std::uint64_t>(significand >> (63 - shift % 64) >> 1);
            x.limb_[0] = shift < 64 ? value << shift % 64 : 0;
            x.limb_[1] = shift < 64 ? above : value << shift % 64;
        } else {
            const auto value = static_cast<std::uint64_t>(significand);
            const std::uint64_t extension = significand < 0 ? ~std::uint64_t{0} : 0;
            const int word = shift / 64;
            const int bit = shift % 64;
            for (int i = 0; i < limbs; ++i) {
                const std::uint64_t here = i < word ? 0 : i == word ? value : extension;
                const std::uint64_t below = i <= word ? 0 : i == word + 1 ? value : extension;
                x.limb_[static_cast<unsigned>(i)] = bit == 0 ? here : here << bit | below >> (64 - bit);
            }
        }
        return x;
    }

    // Limb i of the two's complement, sign-extended beyond the last.
    [[nodiscard]] constexpr std::uint64_t limb(int i) const noexcept {
        return i < limbs ? limb_[static_cast<unsigned>(i)] : extension();
    }
    [[nodiscard]] constexpr bool is_negative() const noexcept {
        return static_cast<std::int64_t>(limb_[limbs - 1]) < 0;
    }

    [[nodiscard]] constexpr integer operator-() const noexcept {
        integer r;
        std::uint64_t carry = 1;
        detail::repeat<limbs>([&](int i) { r.set_limb(i, detail::add_with_carry(~limb(i), 0, carry)); });
        return r;
    }

    [[nodiscard]] constexpr int sign() const noexcept {
        std::uint64_t any = 0;
        detail::repeat<limbs>([&](int i) { any |= limb(i); });
        return is_negative() ? -1 : any != 0 ? 1 : 0;
    }

    [[nodiscard]] friend constexpr bool operator==(const integer&, const integer&) noexcept = default;
    [[nodiscard]] friend constexpr std::strong_ordering operator<=>(const integer& x, const integer& y) noexcept {
        if (x.is_negative() != y.is_negative()) {
            return x.is_negative() ? std::strong_ordering::less : std::strong_ordering::greater;
        }
        for (unsigned i = limbs; i-- > 0;) {
            if (x.limb_[i] != y.limb_[i]) {
                return x.limb_[i] <=> y.limb_[i];
            }
        }
        return std::strong_ordering::equal;
    }

    // Writes limb i; for the arithmetic below.
    constexpr void set_limb(int i, std::uint64_t value) noexcept { limb_[static_cast<unsigned>(i)] = value; }

  private:
    [[nodiscard]] constexpr std::uint64_t extension() const noexcept { return is_negative() ? ~std::uint64_t{0} : 0; }
    constexpr void fill(std::int64_t value) noexcept {
        limb_[0] = static_cast<std::uint64_t>(value);
        for (unsigned i = 1; i < limbs; ++i) {
            limb_[i] = value < 0 ? ~std::uint64_t{0} : 0;
        }
    }

    std::array<std::uint64_t, limbs> limb_{};
};

template <int A, int B>
[[nodiscard]] constexpr auto operator+(const integer<A>& x, const integer<B>& y) noexcept {
    using sum = integer<(A > B ? A : B) + 1>;
    sum r;
    std::uint64_t carry = 0;
    detail::repeat<sum::limbs>([&](int i) { r.set_limb(i, detail::add_with_carry(x.limb(i), y.limb(i), carry)); });
    return r;
}

template <int A, int B>
[[nodiscard]] constexpr auto operator-(const integer<A>& x, const integer<B>& y) noexcept {
    using difference = integer<(A > B ? A : B) + 1>;
    difference r;
    std::uint64_t carry = 1;
    detail::repeat<difference::limbs>(
        [&](int i) { r.set_limb(i, detail::add_with_carry(x.limb(i), ~y.limb(i), carry)); });
    return r;
}

// Adds up rows of unsigned products. The top bit of a negative factor adds too much, which is subtracted at the end,
// modulo the width.
template <int A, int B>
[[nodiscard]] constexpr auto operator*(const integer<A>& x, const integer<B>& y) noexcept {
    using product = integer<A + B>;
    constexpr int rows = integer<A>::limbs;
    constexpr int columns = integer<B>::limbs;
    product r;
    if constexpr (rows == 1 && columns == 1) {
        const auto p = detail::multiply_add_balanced(static_cast<std::int64_t>(x.limb(0)),
                                                     static_cast<std::int64_t>(y.limb(0)), 0, 0);
        r.set_limb(0, static_cast<std::uint64_t>(p.low));
        if constexpr (product::limbs == 2) {
            r.set_limb(1, static_cast<std::uint64_t>(p.high) - (p.low < 0 ? 1U : 0U));
        }
    } else {
        detail::repeat<rows>([&](int i) {
            std::uint64_t carry = 0;
            detail::repeat<columns>([&](int j) {
                if (i + j < product::limbs) {
                    const auto t = detail::multiply_add(x.limb(i), y.limb(j), r.limb(i + j), carry);
                    r.set_limb(i + j, t.low);
                    carry = t.high;
                }
            });
            if (i + columns < product::limbs) {
                r.set_limb(i + columns, carry);
            }
        });
        const std::uint64_t x_negative = x.is_negative() ? ~std::uint64_t{0} : 0;
        const std::uint64_t y_negative = y.is_negative() ? ~std::uint64_t{0} : 0;
        const auto take_off = [&](const auto& factor, int from, int i, std::uint64_t mask, std::uint64_t& borrow) {
            if (from + i < product::limbs) {
                r.set_limb(from + i, detail::add_with_carry(r.limb(from + i), ~(factor.limb(i) & mask), borrow));
            }
        };
        std::uint64_t borrow = 1;
        detail::repeat<columns>([&](int j) { take_off(y, rows, j, x_negative, borrow); });
        borrow = 1;
        detail::repeat<rows>([&](int i) { take_off(x, columns, i, y_negative, borrow); });
    }
    return r;
}

template <int Bits>
struct number_traits<integer<Bits>> {
    static constexpr const char* name = "integer";
    static constexpr bool is_exact = true;
    static constexpr int digits = 0;
    static constexpr int sign(const integer<Bits>& x) noexcept { return x.sign(); }
};

} // namespace graze::inline v0_1
