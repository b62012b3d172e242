// Judges of the later stages: the sign of a number, or that it is open. (filtered_judge, of doubles with a bound from
// their scales, is in flat_signs.hpp.)
#pragma once

#include <graze/exact/big_integer.hpp>
#include <graze/exact/workspace.hpp>
#include <graze/formula/flat_view.hpp>
#include <graze/formula/flat_way.hpp>
#include <graze/number/bounded_word.hpp>
#include <graze/number/traits.hpp>
#include <graze/pair/bounded_double.hpp>

#include <cstdint>
#include <type_traits>

namespace graze::inline v0_1::detail {

// is_quick: formulas are compiled for its numbers. In others the steps of recorded formulas run.
struct word_judge {
    static constexpr bool is_quick = false;
    static constexpr bool has_roots = true;
    [[nodiscard]] bool root(const bounded_word& x, bounded_word& y) const noexcept {
        y = sqrt(x);
        return true;
    }

    template <class F, class X>
    [[nodiscard]] int operator()(F f, const X& x) const noexcept {
        return sign_of(f(x));
    }
    [[nodiscard]] int sign_of(const bounded_word& y) const noexcept {
        return y.has_certain_sign() ? graze::sign(y) : y.is_zero() ? 0 : open_sign;
    }
};
// No sign of it is a certain 0, but that of a speed which is known to vanish.
struct refined_judge {
    static constexpr bool is_quick = true;
    static constexpr bool has_roots = false;
    bool moves_along = false; // the plane
    bool guesses = false;     // takes the doubles for exact

    template <class F, class X>
    [[nodiscard]] int operator()(F f, const X& x) const noexcept {
        if constexpr (std::is_same_v<F, way_speed>) {
            if (moves_along) {
                return 0;
            }
        }
        return sign_of(f(x));
    }
    // A step loses less than 2^-1070; inputs below 2^3, a degree below 30 and fewer than 2^11 steps leave that below
    // 2^-900.
    [[nodiscard]] int sign_of(const bounded_double<53>& y) const noexcept {
        if (guesses) {
            return graze::sign(y);
        }
        const int s = y.certain_sign(0x1p-900);
        return s != 0 ? s : open_sign;
    }
};
struct exact_judge {
    static constexpr bool is_quick = false;
    static constexpr bool has_roots = false;
    workspace* room;

    [[nodiscard]] constexpr workspace::scope scope() const noexcept { return workspace::scope(room); }
    [[nodiscard]] constexpr std::int64_t* mark() const noexcept { return room->take(0); }
    constexpr void rewind(std::int64_t* mark) const noexcept { room->keep_until(mark); }

    template <class F, class X>
    [[nodiscard]] constexpr int operator()(F f, const X& x) const {
        const workspace::scope own(room);
        return sign_of(f(x));
    }
    [[nodiscard]] constexpr int sign_of(const big_integer& y) const noexcept { return graze::sign(y); }
};

} // namespace graze::inline v0_1::detail
