// A collision as the smaller root of an exact quadratic, whatever met whatever.
#pragma once

#include <graze/formula/root_order.hpp>
#include <graze/formula/wall_encounter.hpp>
#include <graze/pair/pair.hpp>

#include <algorithm>
#include <array>
#include <cstdint>

namespace graze::inline v0_1::detail {

enum class event_kind : std::uint8_t { balls, plane, face, edge, corner };

// What met, as numbers: the packed row of its pair (the rest of the array is not used), and which feature of a wall.
template <int N, class T>
struct event {
    static constexpr std::size_t capacity = std::max(
        {two_balls<N>::lengths + two_balls<N>::velocities, ball_and_wall<N>::lengths + ball_and_wall<N>::velocities,
         ball_and_plane<N>::lengths + ball_and_plane<N>::velocities + ball_and_plane<N>::normals});

    std::array<T, capacity> row;
    event_kind kind;
    std::int8_t index;
    bool overlap;
    bool nearest = false; // whether the enclosure of the time is around the number that it is rounded to

    template <class P, class Y>
    constexpr event(P, const ball<N, T>& x, const Y& y, event_kind what, int which, bool inside) noexcept
        : kind(what), index(static_cast<std::int8_t>(which)), overlap(inside) {
        P::pack(row.data(), x, y);
        std::fill(row.begin() + P::lengths + P::velocities + P::normals, row.end(), T(0));
    }
};

template <int N>
[[nodiscard]] constexpr event_kind kind_of(feature f) noexcept {
    return f == feature::face ? event_kind::face : f == feature::edge ? event_kind::edge : event_kind::corner;
}

// f(P{}) with the pair kind of an event.
template <int N, class F>
[[nodiscard]] constexpr auto with_pair(event_kind kind, F f) {
    return kind == event_kind::balls   ? f(two_balls<N>{})
           : kind == event_kind::plane ? f(ball_and_plane<N>{})
                                       : f(ball_and_wall<N>{});
}

// use(q) with the quadratic of an event of pair kind P from its motion.
template <int N, class P, class M, class F>
[[nodiscard]] constexpr auto with_quadratic(event_kind kind, int index, const M& m, F use) {
    if constexpr (std::is_same_v<P, ball_and_wall<N>>) {
        if (kind == event_kind::face) {
            return use(quadratic_of(face_of(m)));
        }
        if constexpr (N == 3) {
            if (kind == event_kind::edge) {
                return use(edge_quadratic(seen_from(m, edge_view(index))));
            }
        }
        return use(quadratic_of(corner_motion(seen_from(m, wall_view{index, false}))));
    } else {
        return use(quadratic_of(m));
    }
}

using big_quadratic = quadratic<big_integer, big_integer, big_integer>;

// The quadratic of an event whose inputs have been lifted, in the one type that holds all of them.
template <int N, class T, class P, class Inputs>
[[nodiscard]] constexpr big_quadratic big_quadratic_of(const event<N, T>& e, P, const Inputs& in) {
    const auto motion = P::template motion<big_integer>(in);
    return with_quadratic<N, P>(e.kind, e.index, motion, [&](const auto& q) {
        return big_quadratic{q.a, q.h, e.overlap ? big_integer() : q.c};
    });
}

// The sign of τ(x) - τ(y).
template <int N, class T>
[[nodiscard, gnu::noinline]] constexpr int compare_exactly(const event<N, T>& x, const event<N, T>& y) {
    return with_pair<N>(x.kind, [&]<class P>(P p) {
        return with_pair<N>(y.kind, [&]<class R>(R r) {
            auto inputs_x = lift_row<P>(x.row);
            auto inputs_y = lift_row<R>(y.row);
            align(inputs_x.length, inputs_y.length);
            align(inputs_x.velocity, inputs_y.velocity);
            if constexpr (std::is_same_v<P, two_balls<N>> && std::is_same_v<R, two_balls<N>>) {
                const auto in = [&]<class I>() {
                    auto q = quadratic_of(P::template motion<I>(inputs_x));
                    auto s = quadratic_of(P::template motion<I>(inputs_y));
                    using C = decltype(q.c);
                    return root_order{}(quadratic{q.a, q.h, x.overlap ? C(0) : q.c},
                                        quadratic{s.a, s.h, y.overlap ? C(0) : s.c});
                };
                const int width = std::max(inputs_x.width(), inputs_y.width());
                if (width <= one_limb_width) {
                    return in.template operator()<integer<one_limb_width>>();
                }
            }
            exact_workspace room;
            inputs_x.use(room);
            inputs_y.use(room);
            return root_order{}(big_quadratic_of(x, p, inputs_x), big_quadratic_of(y, r, inputs_y));
        });
    });
}

// The sign of τ(x) - m, m finite. m = M 2^j in the event's unit of time.
template <int N, class T>
[[nodiscard, gnu::noinline]] constexpr int compare_exactly(const event<N, T>& x, const binary& m) {
    return with_pair<N>(x.kind, [&]<class P>(P p) {
        auto inputs = lift_row<P>(x.row);
        const int power = m.exponent - (inputs.length.exponent - inputs.velocity.exponent);
        exact_workspace room;
        inputs.use(room);
        const auto numerator = big_integer::from_shifted(room, m.significand, power > 0 ? power : 0);
        const auto denominator = big_integer::from_shifted(room, 1, power < 0 ? -power : 0);
        const big_quadratic q = big_quadratic_of(x, p, inputs);
        return root_against(sign(value_at{}(q, numerator, denominator)), sign(slope_at{}(q, numerator, denominator)));
    });
}

} // namespace graze::inline v0_1::detail
