// A mover is a ball, which is a flight since 0, or a flight. Code for movers serves both.
#pragma once

#include <graze/exact/binary.hpp>
#include <graze/exact/rounding.hpp>
#include <graze/shape/flight.hpp>

#include <array>

namespace graze::inline v0_1::detail {

// Whether B has an epoch; its dimension and the type of its numbers.
template <class B>
struct moving_traits;
template <int N, class T>
struct moving_traits<ball<N, T>> {
    static constexpr bool has_epoch = false;
    static constexpr int dimension = N;
    using number = T;
};
template <int N, class T>
struct moving_traits<flight<N, T>> : moving_traits<ball<N, T>> {
    static constexpr bool has_epoch = true;
};
template <class B>
concept moving = requires {
    typename moving_traits<B>::number;
};
template <moving B>
using number_in = typename moving_traits<B>::number;
template <moving B>
inline constexpr int dimension_of = moving_traits<B>::dimension;

template <class B>
inline constexpr bool is_flight = false;
template <int N, class T>
inline constexpr bool is_flight<flight<N, T>> = true;

// A flight's ball; anything else as it is.
template <class B>
[[nodiscard, gnu::always_inline]] constexpr inline const B& state_of(const B& b) noexcept {
    return b;
}
template <int N, class T>
[[nodiscard, gnu::always_inline]] constexpr inline const ball<N, T>& state_of(const flight<N, T>& f) noexcept {
    return f.state;
}

// As a flight. Code that is large and seldom runs exists once, for flights.
template <int N, class T>
[[nodiscard]] constexpr flight<N, T> as_flight(const ball<N, T>& b) noexcept {
    return {b, T(0)};
}
template <int N, class T>
[[nodiscard]] constexpr const flight<N, T>& as_flight(const flight<N, T>& f) noexcept {
    return f;
}

// The epochs of two movers.
template <moving B>
[[nodiscard]] constexpr std::array<number_in<B>, 2> epochs_of(const B& a, const B& b) noexcept {
    if constexpr (is_flight<B>) {
        return {a.since, b.since};
    } else {
        return {};
    }
}

// Whether s < t, exactly, of any finite numbers, by their bits.
template <class T>
[[nodiscard]] constexpr bool is_earlier(const T& s, const T& t) noexcept {
    const auto order = [](const T& x) {
        const auto magnitude = static_cast<std::int64_t>(order_of_magnitude(x));
        return split(x).significand < 0 ? -magnitude : magnitude;
    };
    return order(s) < order(t);
}

// The later of two instants; a zero as +0.
template <class T>
[[nodiscard]] constexpr T start_of(const std::array<T, 2>& since) noexcept {
    if constexpr (std::signed_integral<T>) {
        return since[0] < since[1] ? since[1] : since[0];
    } else {
        const T& later = is_earlier(since[0], since[1]) ? since[1] : since[0];
        return from_bits<T>(is_zero(later) ? 0 : bits_of(later), false);
    }
}

} // namespace graze::inline v0_1::detail
