// A collision as numbers: a pair of any kind, with its epochs.
#pragma once

#include <graze/formula/wall_encounter.hpp>
#include <graze/pair/moving.hpp>
#include <graze/pair/pair.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <type_traits>

namespace graze::inline v0_1::detail {

enum class event_kind : std::uint8_t { balls, plane, face, edge, corner };

// For a wall or a triangle.
template <int N>
[[nodiscard]] constexpr event_kind kind_of(feature f) noexcept {
    return f == feature::face ? event_kind::face : f == feature::edge ? event_kind::edge : event_kind::corner;
}
template <int N>
[[nodiscard]] constexpr event_kind kind_of(ball_and_plane<N>, feature) noexcept {
    return event_kind::plane;
}
template <int N>
[[nodiscard]] constexpr event_kind kind_of(ball_and_wall<N>, feature f) noexcept {
    return kind_of<N>(f);
}
// Its index in an event.
template <class Shape, class Found>
[[nodiscard]] constexpr int number_in_wall(const Found& found) noexcept {
    return feature_number(found.where, found.index, is_triangle<Shape>);
}

// The packed row of a pair, then the epochs of its flights; the rest of the array is not used. The feature of a wall or
// a triangle is given by its index, for an edge by the edge_number. An event at its start (overlap) is of a pair that
// overlaps or touches then.
template <int N, class T>
struct event_row {
    template <class P>
    static constexpr std::size_t numbers = P::lengths + P::velocities + P::normals;
    template <class P>
    static constexpr std::size_t size = numbers<P> + (std::floating_point<T> ? P::epochs : 0);
    static constexpr std::size_t capacity =
        std::max({size<two_balls<N>>, size<ball_and_wall<N>>, size<ball_and_plane<N>>});

    std::array<T, capacity> row;
    event_kind kind;
    std::int8_t index;
    bool overlap;
    bool timed; // whether it is of flights, which have epochs

    // x: a ball or a flight; y: another one, or a plane, a wall or a triangle.
    template <class P, class X, class Y>
    constexpr event_row(P, const X& x, const Y& y, event_kind what, int which, bool inside) noexcept
        : kind(what), index(static_cast<std::int8_t>(which)), overlap(inside), timed(is_flight<X>) {
        P::pack(row.data(), state_of(x), state_of(y));
        std::fill(row.begin() + numbers<P>, row.end(), T(0));
        if constexpr (is_flight<X>) {
            row[numbers<P>] = x.since;
            if constexpr (is_flight<Y>) {
                row[numbers<P> + 1] = y.since;
            }
        }
    }

    // The epochs of the pair's two things as pair kind P takes them: a plane or wall has the epoch of the other.
    template <class P>
    [[nodiscard]] constexpr std::array<T, 2> since(P) const noexcept {
        if constexpr (std::floating_point<T>) {
            return {row[numbers<P>], row[numbers<P> + P::epochs - 1]};
        } else {
            return {};
        }
    }
    // The instant from which both are on their way.
    [[nodiscard]] constexpr T start() const noexcept {
        return !timed                      ? T(0)
               : kind == event_kind::balls ? start_of(since(two_balls<N>{}))
               : kind == event_kind::plane ? start_of(since(ball_and_plane<N>{}))
                                           : start_of(since(ball_and_wall<N>{}));
    }
    [[nodiscard]] constexpr bool is_of_balls() const noexcept { return kind == event_kind::balls && !timed; }
};

struct approached_time; // scaled_rounding.hpp
struct exact_root;      // exact_event.hpp

// What an event's time asks of its pair kind, if doubles of balls don't tell. Since these are pointers, a unit compiles
// those of the kinds that it makes.
template <int N, class T>
struct event_procedures {
    // The time as an exact root, with its digits in the workspace.
    exact_root (*root)(const event_row<N, T>&, workspace&);
    // The time of an event after its start, which is near a double; closer than that, but not exact.
    approached_time (*approach)(const event_row<N, T>&, double near);
};

// Those of pair kind P; of flights, if Timed.
template <int N, class T, class P, bool Timed>
struct procedures_of;

template <int N, class T>
struct event : event_row<N, T> {
    bool nearest; // whether the enclosure of the time is around the number that it is rounded to
    const event_procedures<N, T>* procedures;

    template <class P, class X, class Y>
    constexpr event(P pair, const X& x, const Y& y, event_kind what, int which, bool inside,
                    bool known = false) noexcept
        : event_row<N, T>(pair, x, y, what, which, inside), nearest(known),
          procedures(&procedures_of<N, T, P, is_flight<X>>::table) {}
};

// The quadratic of an event of pair kind P, from its motion.
template <int N, class P, class M>
[[nodiscard]] constexpr auto quadratic_of_pair(event_kind kind, int index, const M& m) {
    if constexpr (std::is_same_v<P, ball_and_wall<N>>) {
        if (kind == event_kind::face) {
            return quadratic_of(face_of(m));
        }
        if constexpr (N == 3) {
            if (kind == event_kind::edge) {
                return edge_quadratic(seen_from(m, edge_view(index)));
            }
        }
        return quadratic_of(corner_motion(seen_from(m, wall_view{index, false})));
    } else {
        return quadratic_of(m);
    }
}

} // namespace graze::inline v0_1::detail
