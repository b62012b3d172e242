// The time of an event of a plane or a wall near one in doubles, from its row.
#pragma once

#include <graze/filter/static_filter.hpp>
#include <graze/formula/wall_features.hpp>
#include <graze/machine/fence.hpp>
#include <graze/machine/fused.hpp>
#include <graze/time/event.hpp>
#include <graze/time/flat_steps.hpp>

namespace graze::inline v0_1::detail {

// Whether sizes are moderate enough for their products neither to over- nor underflow.
template <class... S>
[[nodiscard, gnu::always_inline]] inline bool are_moderate(const S&... size) noexcept {
    return (within_powers<-100, 100>(size) & ...);
}

// The pair in doubles. For a plane, the normal stands in place of the first edge.
template <int N>
struct flat_row {
    vec<N, double> x, corner, u;
    vec<N, double> edge[N == 2 ? 1 : 2] = {};
    double r;

    template <class T>
    [[gnu::always_inline]] flat_row(event_kind kind, const T* row) noexcept {
        using P = ball_and_wall<N>;
        using Q = ball_and_plane<N>;
        // Alone: a load of several would wait until the stores of each are in the cache, if the row has just been
        // written.
        const auto vector = [&](std::size_t from) {
            return make_vec<N>([&](int i) {
                return read_alone(static_cast<double>(as_stored(row[from + static_cast<unsigned>(i)])));
            });
        };
        constexpr std::size_t n = N;
        const bool is_plane = kind == event_kind::plane;
        x = vector(0);
        corner = vector(n);
        r = static_cast<double>(as_stored(row[is_plane ? Q::lengths - 1 : P::lengths - 1]));
        u = vector(is_plane ? Q::lengths : P::lengths);
        edge[0] = vector(is_plane ? Q::lengths + Q::velocities : 2 * n);
        if constexpr (N == 3) {
            if (!is_plane) {
                edge[1] = vector(3 * n);
            }
        }
    }
};

template <bool Fused, int N>
[[nodiscard, gnu::always_inline]] inline parts_vector<N> normal_in_parts(event_kind kind,
                                                                         const flat_row<N>& f) noexcept {
    if (kind == event_kind::plane) {
        return exact_components<N>(f.edge[0]);
    }
    if constexpr (N == 2) {
        return exact_components<2>({{-f.edge[0][1], f.edge[0][0]}});
    } else {
        return cross_in_parts<Fused>(exact_components<3>(f.edge[0]), exact_components<3>(f.edge[1]));
    }
}

// The direction of the edge of this number.
template <int N>
[[nodiscard, gnu::always_inline]] inline parts_vector<N> edge_in_parts(const flat_row<N>& f, int number) noexcept {
    return number == slanted_edge ? difference_in_parts<N>(f.edge[1], f.edge[0])
                                  : exact_components<N>(number >= 2 ? f.edge[0] : f.edge[1]);
}

// The centre relative to corner i of the wall.
template <int N>
[[nodiscard, gnu::always_inline]] inline parts_vector<N> centre_in_parts(const flat_row<N>& f, int corner) noexcept {
    auto from = difference_in_parts<N>(f.x, f.corner);
    for (int i = 0; i + 1 < N; ++i) {
        if ((corner >> i & 1) != 0) {
            from = difference_in_parts<N>(from, f.edge[i]);
        }
    }
    return from;
}

// The time of a hit near `time`.
template <int N, class T>
struct flat_time_near {
    const event_row<N, T>* e;
    double time;

    template <bool Fused>
    [[nodiscard, gnu::always_inline]] flat_time operator()(std::bool_constant<Fused>) const noexcept {
        const flat_row<N> f(e->kind, e->row.data());
        const bool is_edge = e->kind == event_kind::edge;
        const int corner = e->kind == event_kind::corner ? e->index : is_edge ? edge_view(e->index).corner : 0;
        const auto from = centre_in_parts(f, corner);
        double speed = 0;
        for (int i = 0; i < N; ++i) {
            speed += absolute(f.u[i]);
        }
        // size: of the normal or the direction, if there is one.
        const auto checked = [&](const flat_time& t, double size) noexcept {
            return flat_time{t.high, t.low, t.error,
                             all_hold(t.good, are_moderate(from.size() + f.r, speed, size, time))};
        };
        if (e->kind == event_kind::corner) {
            return checked(touch_corner<Fused, N>(from, f.u, f.r, time), 1);
        }
        if constexpr (N == 3) {
            if (is_edge) {
                const auto d = edge_in_parts<3>(f, e->index);
                return checked(touch_edge<Fused>(from, f.u, d, f.r, time), d.size());
            }
        }
        const auto touch = touch_face<Fused, N>(from, f.u, normal_in_parts<Fused>(e->kind, f), f.r, time);
        return checked(touch.time, touch.n.size());
    }
};

// The same as compiled for this machine.
template <int N, class T>
[[nodiscard]] flat_time flat_time_in_doubles(const event_row<N, T>& e, double time) noexcept {
    return with_best_products(flat_time_near<N, T>{&e, time});
}

} // namespace graze::inline v0_1::detail
