// When the balls of many pairs touch first, all at once.
#pragma once

#include <graze/predicate/batch.hpp>
#include <graze/time/batch_blocks.hpp>
#include <graze/time/time_of_shapes.hpp>
#include <graze/time/time_of_walls.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>

namespace graze::inline v0_1 {

namespace detail {

// The type that times of T are rounded to.
template <class T>
using rounded_time_of = typename impact_time<2, T>::rounded_type;

// By its bits: under -ffast-math clang treats code that returns or passes an infinity as not reached.
template <class T>
void put_infinity(T& x) noexcept {
    constexpr auto bits = format_of<T>.infinite_bits();
    const auto infinity = static_cast<std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>>(bits);
    std::memcpy(&x, &infinity, sizeof(T));
}

// x's time of impact with y, rounded; +infinity if there is none.
template <int N, class T, class Y>
void round_impact(const ball<N, T>& x, const Y& y, rounding mode, rounded_time_of<T>& rounded) {
    const auto time = graze::time_of_impact(x, y);
    if (time) {
        rounded = mode == rounding::nearest    ? static_cast<rounded_time_of<T>>(*time)
                  : mode == rounding::downward ? time->lower()
                                               : time->upper();
    } else {
        put_infinity(rounded);
    }
}

// Whether lanes are worth asking who never touches: a plane's scalar function says so at once.
template <class A, class B>
inline constexpr bool rules_out_in_lanes = [] {
    if constexpr (has_lanes<batch_classify, A, B>) {
        return flat_shape<std::remove_cvref_t<decltype(std::declval<const B&>().at(0))>>;
    } else {
        return false;
    }
}();

// Of a block of balls and one wall or triangle: writes +infinity for those that the lanes say never touch it.
// Leaves open the others.
template <int Wider, class A, class B, class T>
void rule_out(const A& a, const B& b, std::size_t from, std::size_t count, T* time, open_pairs& left) {
    std::array<encounter, block_size> what{};
    ask_widest_lanes<Wider, batch_classify>(a, b, from, count, what.data(), left);
    for (std::size_t k = 0; k < count; ++k) {
        if (is_collision(what[k])) {
            left.add(k, 1);
        } else {
            put_infinity(time[from + k]);
        }
    }
}

template <class A, class B>
inline constexpr bool has_time_lanes = [] {
    if constexpr (std::is_floating_point_v<typename A::scalar> && register_bytes > 0) {
        return requires(const B& b) { b.template lanes_at<native_pack<typename A::scalar>>({}); };
    } else {
        return false;
    }
}();

template <class Mode, int Wider = compiled_register_bytes, class A, class B>
void time_all(const A& a, const B& b, std::span<rounded_time_of<typename A::scalar>> time, rounding mode) {
    require_size<Mode>(a, b, time.size());
    const auto one = [&](std::size_t i) { of_pair<Mode>(i, [&] { round_impact(a.at(i), b.at(i), mode, time[i]); }); };
    if constexpr (has_time_lanes<A, B> || rules_out_in_lanes<A, B>) {
        constexpr int wider = is_foreign<A> || is_foreign<B> ? 0 : Wider;
        lane_pause pause;
        for (std::size_t from = 0; from < time.size(); from += block_size) {
            const std::size_t count = std::min(block_size, time.size() - from);
            open_pairs left;
            if constexpr (has_time_lanes<A, B>) {
                time_widest_lanes<wider>(a, b, from, count, mode, time.data(), left);
            } else if (pause.is_over()) {
                rule_out<wider>(a, b, from, count, time.data(), left);
                pause.note(left, count);
            } else {
                left.add_rest(0, count);
            }
            left.each([&](std::size_t k) { one(from + k); });
        }
    } else {
        for (std::size_t i = 0; i < time.size(); ++i) {
            one(i);
        }
    }
}

} // namespace detail

namespace batch {

// When each ball of a first touches the ball of the same index in b, or the one ball, plane, wall or triangle b.
// time[i] is time_of_impact(a[i], b[i]) rounded once: to nearest (ties to even) or, like its lower() and upper(), down
// or up. It is +infinity if they never touch. `time` holds numbers of type T; for balls of integers, doubles.
// Arguments, exceptions and what has been written after one are as for classify.
template <class A, class B, class Mode = detail::unit_mode>
requires detail::batch_of<A, B>
void time_of_impact(const A& a, const B& b,
                    std::span<detail::rounded_time_of<typename detail::source_for<A>::scalar>> time,
                    rounding mode = rounding::nearest) {
    detail::time_all<Mode>(detail::source_of(a), detail::source_of(b), time, mode);
}

} // namespace batch
} // namespace graze::inline v0_1
