// A double word that is not normalised after every step: half the operations, a quarter of the time.
#pragma once

#include <graze/machine/error_free.hpp>
#include <graze/number/traits.hpp>

namespace graze::inline v0_1::detail {

// high + low, where low is small relative to the terms of a formula, but not always relative to high. Losses are of the
// order u² of the terms, as word_rounding (analysis/word_rounding.hpp) counts them. V: double or lanes. Needs the
// conditions of error-free transforms.
template <bool Fused, class V = double>
struct loose_word {
    V high{}, low{};

    constexpr loose_word() = default;
    constexpr explicit loose_word(int x) noexcept : high(x) {}
    constexpr explicit loose_word(const exact_pair<V>& x) noexcept : high(x.value), low(x.error) {}
    constexpr loose_word(const V& h, const V& l) noexcept : high(h), low(l) {}

    // high + low with low at most half a last place of high, for |low| <= |high| / 2^10.
    [[nodiscard, gnu::always_inline]] constexpr loose_word in_order() const noexcept {
        return loose_word(fast_two_sum(high, low));
    }

    [[nodiscard, gnu::always_inline]] friend constexpr loose_word operator-(const loose_word& x) noexcept {
        return {-x.high, -x.low};
    }
    [[nodiscard, gnu::always_inline]] friend constexpr loose_word operator+(const loose_word& x,
                                                                            const loose_word& y) noexcept {
        const auto sum = two_sum(x.high, y.high);
        return {sum.value, settled((x.low + y.low) + sum.error)};
    }
    [[nodiscard, gnu::always_inline]] friend constexpr loose_word operator-(const loose_word& x,
                                                                            const loose_word& y) noexcept {
        const auto difference = two_difference(x.high, y.high);
        return {difference.value, settled((x.low - y.low) + difference.error)};
    }
    [[nodiscard, gnu::always_inline]] friend constexpr loose_word operator*(const loose_word& x,
                                                                            const loose_word& y) noexcept {
        const auto product = two_product(as_factor<Fused>(x.high), as_factor<Fused>(y.high));
        return {product.value, settled(product.error + (x.high * y.low + x.low * y.high))};
    }
};

} // namespace graze::inline v0_1::detail

template <bool Fused, class V>
struct graze::number_traits<graze::detail::loose_word<Fused, V>> {
    static constexpr const char* name = "loose_word";
    static constexpr bool is_exact = false;
    static constexpr int digits = 98;
};
