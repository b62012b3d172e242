// When a ball touches a plane or a feature of a wall, by the formulas in numbers that bound their own error.
#pragma once

#include <graze/formula/discriminant.hpp>
#include <graze/formula/roots.hpp>
#include <graze/machine/fence.hpp>
#include <graze/number/bounded_word.hpp>
#include <graze/time/certain_rounding.hpp>
#include <graze/time/event.hpp>

namespace graze::inline v0_1::detail {

// A row's numbers in the form that pair kinds take.
template <class T>
struct bounded_group {
    const T* first;

    template <class I>
    [[nodiscard]] I get(std::size_t i) const noexcept {
        return I(static_cast<double>(as_stored(first[i])));
    }
};
template <class P, class T>
struct bounded_row {
    bounded_group<T> length, velocity, normal;

    explicit bounded_row(const T* row) noexcept
        : length{row}, velocity{row + P::lengths}, normal{row + P::lengths + P::velocities} {}
};

template <int N, class T>
[[nodiscard]] auto bounded_motion(ball_and_plane<N>, const T* row) noexcept {
    using P = ball_and_plane<N>;
    return P::template motion<bounded_word>(bounded_row<P, T>(row));
}

template <int N, class T>
[[nodiscard]] auto bounded_motion(ball_and_wall<N>, const T* row) noexcept {
    using P = ball_and_wall<N>;
    return P::template motion<bounded_word>(bounded_row<P, T>(row));
}

// The time of a hit on a plane or a face: (33) completed.
template <class M>
[[nodiscard]] bounded_word face_time(const M& m) noexcept {
    const bounded_word height = plane_height{}(m);
    if (!height.has_certain_sign()) {
        return bounded_word::unknown();
    }
    return plane_touch_time{}(height, plane_speed{}(m), m.r * sqrt(graze::squared_norm(m.n)));
}

// The time of a hit, from the quadratic of an edge or a corner and its discriminant.
[[nodiscard]] inline bounded_word root_time(const quadratic<bounded_word, bounded_word, bounded_word>& q,
                                            const bounded_word& discriminant) noexcept {
    return root_stable{}(q.c, q.h, sqrt(discriminant));
}

// m: as seen from where the edge is the edge λ_0 = 0.
template <class M>
[[nodiscard]] bounded_word edge_time(const M& m) noexcept {
    return root_time(edge_quadratic(m), edge_discriminant{}(m));
}
// m: as seen from the corner.
template <class M>
[[nodiscard]] bounded_word corner_time(const M& m) noexcept {
    const auto relative = corner_motion(m);
    return root_time(quadratic_of(relative), discriminant_lagrange{}(relative));
}

// The time of an event that is a hit on a plane or a wall.
template <int N, class T>
[[nodiscard, gnu::noinline]] bounded_word hit_time(const event_row<N, T>& e) noexcept {
    if (e.kind == event_kind::plane) {
        return face_time(bounded_motion(ball_and_plane<N>{}, e.row.data()));
    }
    const auto m = bounded_motion(ball_and_wall<N>{}, e.row.data());
    if (e.kind == event_kind::face) {
        return face_time(face_of(m));
    }
    if constexpr (N == 3) {
        if (e.kind == event_kind::edge) {
            return edge_time(seen_from(m, edge_view(e.index)));
        }
    }
    return corner_time(seen_from(m, wall_view{e.index, false}));
}

// The value with a bound on its error.
[[nodiscard]] inline bounded<double> as_bounds(const bounded_word& x) noexcept {
    return {x.value().high(), x.value().low(), (1 + 0x1p-40) * x.error()};
}

} // namespace graze::inline v0_1::detail
