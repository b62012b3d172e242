// The components of a contact with a bound of their errors, in units of their own, and their rounding.
#pragma once

#include <graze/contact/fast_contact.hpp>
#include <graze/time/scaled_rounding.hpp>

#include <bit>
#include <optional>

namespace graze::inline v0_1::detail {

// Keeps what is bounded, by its number.
struct bounded_components {
    bounded<double> found[16];
    parts known = 0;

    [[gnu::always_inline]] void operator()(const bounded<double>& x, int number) noexcept {
        found[number] = x;
        known |= parts{1} << number;
    }
    [[gnu::always_inline]] void operator()(const bounded<lanes>& x, int first, int second) noexcept {
        (*this)(bounded<double>{x.high[0], x.low[0], x.error[0]}, first);
        (*this)(bounded<double>{x.high[1], x.low[1], x.error[1]}, second);
    }
};

// x 2^scale rounded to nearest, by one comparison of its ends where both x and the result are normal numbers of T: of
// floats only if nothing is scaled.
template <class T>
[[nodiscard]] inline std::optional<T> round_component(const bounded<double>& x, int scale) noexcept {
    if (scale == 0 || std::is_same_v<T, double>) {
        const ends<double> interval = ends_of<T>(x);
        if (agree<T>(interval)) {
            if (scale == 0) {
                return static_cast<T>(interval.upper);
            }
            const std::uint64_t bits = bits_of(interval.upper);
            const int exponent = static_cast<int>(bits >> 52 & 0x7ff) + scale;
            if (0 < exponent && exponent < 0x7ff) {
                const auto shift = static_cast<std::uint64_t>(static_cast<std::int64_t>(scale)) << 52;
                return static_cast<T>(std::bit_cast<double>(bits + shift));
            }
        }
    }
    return rounded_scaled<T>(x, scale, rounding::nearest);
}

// Writes those of the wanted components that are certain, from units of lengths and velocities of 2^length and
// 2^velocity, and returns which.
template <int N, class T>
[[nodiscard, gnu::noinline]] parts round_components(contact<N, T>& c, parts wanted, const bounded_components& x,
                                                    int length, int velocity) noexcept {
    parts certain = 0;
    for (parts rest = wanted & x.known; rest != 0; rest &= rest - 1) {
        const int number = std::countr_zero(rest);
        const int scale = number == 0 ? length - velocity : number < 7 ? length : number < 10 ? 0 : velocity;
        if (const auto rounded = round_component<T>(x.found[number], scale)) {
            component(c, number) = *rounded;
            certain |= parts{1} << number;
        }
    }
    return certain;
}

} // namespace graze::inline v0_1::detail
