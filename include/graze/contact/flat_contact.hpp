// The contact of a ball that hits a plane or a face, or overlaps it, from its touch in parts, each component with an
// error.
//
// With the notation of time/flat_steps.hpp: κ = N/|n| >= 1, and |n| is right to 2^-97 κ⁴ of itself. The normal n/|n| is
// then right to 2^-96 κ⁴; u·n/|n| to 2^-96 V κ⁴, V = Σ|u_i|, and the velocity u - 2 (u·n/|n|) n/|n| to 2^-94 V κ⁴. Of
// an overlap the point is x - (w·n/n·n) n. With W = Σ|w_i| the height w·n is off by 2^-97 W N, which n/n·n makes 2^-97
// W κ; n·n is right to 2^-100 κ² of itself, its inverse to 2^-100 more and the products to some u²: 2^-95 W κ² in all.
#pragma once

#include <graze/contact/path_in_parts.hpp>

#include <cmath>

namespace graze::inline v0_1::detail {

// A plane or a face. from: w for an overlap, else nothing.
template <bool Fused, int N, class T, class Take>
[[gnu::always_inline]] inline void take_face_contact(wall_contact<N, T>& c, const path_in_parts<Fused, N, Take>& path,
                                                     const face_touch<N>& touch, double V,
                                                     const parts_vector<N>* from) noexcept {
    const auto& f = path.f;
    const auto& n = touch.n;
    const auto per_length = inverse_in_parts<Fused>({touch.length.high, touch.length.low});
    const auto phi = product_in_parts<Fused>({2 * touch.speed.value, 2 * touch.speed.error}, per_length);
    const double spread2 = touch.length.spread * touch.length.spread;
    const double normal_error = 0x1p-96 * (spread2 * spread2);
    const double side = std::copysign(1.0, -touch.speed.value); // the normal points to where the ball comes from
    int zeros = 0;
    for (int i = 0; i < N; ++i) {
        zeros += is_exact_zero(n[i]) ? 1 : 0;
    }
    const bool known_zeros = zeros == 0 || has_no_tiny_edge(f);
    exact_pair<double> along{};
    if (from != nullptr) {
        along = product_in_parts<Fused>(dot_in_parts<Fused, N>(*from, n),
                                        inverse_in_parts<Fused>(dot_in_parts<Fused, N>(n, n)));
    }
    for (int i = 0; i < N; ++i) {
        const auto s = path.at(i);
        const int at_point = static_cast<int>(wall_component::point) + i;
        const int at_normal = static_cast<int>(wall_component::normal) + i;
        const int at_velocity = static_cast<int>(wall_component::velocity) + i;
        const bool is_axis = known_zeros && zeros == N - 1 && !is_exact_zero(n[i]);
        if (from != nullptr) {
            path.take.exact(f.x[i], static_cast<int>(wall_component::position) + i, c.position[i]);
        } else if (is_axis) {
            path.take.sum(f.corner[i], side * std::copysign(f.r, n[i].value),
                          static_cast<int>(wall_component::position) + i, c.position[i]);
        } else {
            path.take_position(s, i, wall_component::position, c.position[i]);
        }
        if (known_zeros && is_exact_zero(n[i])) {
            path.take_unturned(s, i, c);
            continue;
        }
        const auto unit = product_in_parts<Fused>(n[i], per_length);
        path.take({side * unit.value, side * unit.error, normal_error}, at_normal, c.normal[i]);
        const auto velocity = sum_in_parts({f.u[i], 0}, negated(product_in_parts<Fused>(phi, unit)));
        path.take({velocity.value, velocity.error, 4 * V * normal_error}, at_velocity, c.velocity[i]);
        if (is_axis) {
            path.take.exact(f.corner[i], at_point, c.point[i]);
        } else if (from != nullptr) {
            const auto point = sum_in_parts({f.x[i], 0}, negated(product_in_parts<Fused>(along, n[i])));
            path.take({point.value, point.error, s.size + 0x1p-95 * (from->size() * spread2)}, at_point, c.point[i]);
        } else {
            const auto reach = product_in_parts<Fused>({side * f.r, 0}, unit);
            const auto point = sum_in_parts(s.position, negated(reach));
            path.take({point.value, point.error, s.error + s.size + f.r * (2 * normal_error)}, at_point, c.point[i]);
        }
    }
}

// An edge of direction d, or a corner. y: the centre from it at the contact, off by `error` in each component. For an
// edge the part of y along d is taken off, a third time as much error at most; where d is along an axis, exactly. The
// rest is split anew: a component may cancel to its low part, and products of two such parts are not small.
template <bool Fused, int N, class T, class Take>
[[gnu::always_inline]] inline void take_round_contact(wall_contact<N, T>& c, const path_in_parts<Fused, N, Take>& path,
                                                      parts_vector<N> y, double error, const parts_vector<N>* d,
                                                      int corner, double V) noexcept {
    const auto& f = path.f;
    int axis = -1; // the one along which d is
    if (d != nullptr) {
        int others = 0;
        for (int i = 0; i < N; ++i) {
            const bool is_zero = is_exact_zero((*d)[i]);
            axis = is_zero ? axis : i;
            others += is_zero ? 1 : 0;
        }
        axis = others == N - 1 ? axis : -1;
        if (axis >= 0) {
            y.component[axis] = {0, 0};
        } else {
            const auto along = product_in_parts<Fused>(dot_in_parts<Fused, N>(y, *d),
                                                       inverse_in_parts<Fused>(dot_in_parts<Fused, N>(*d, *d)));
            for (int i = 0; i < N; ++i) {
                const auto across = sum_in_parts(y[i], negated(product_in_parts<Fused>(along, (*d)[i])));
                y.component[i] = two_sum(across.value, across.error);
            }
            error = 4 * error + 0x1p-95 * y.size();
        }
    }
    const auto per_radius = inverse_in_parts<Fused>({f.r, 0});
    exact_pair<double> speed = product_in_parts<Fused>({f.u[0], 0}, y[0]);
    for (int i = 1; i < N; ++i) {
        speed = sum_in_parts(speed, product_in_parts<Fused>({f.u[i], 0}, y[i]));
    }
    const auto per_square = product_in_parts<Fused>(per_radius, per_radius);
    const auto change = product_in_parts<Fused>({2 * speed.value, 2 * speed.error}, per_square);
    // |y| = r: the change is at most 2V/r, off by 2V (error + 2^-98 size)/r² and some u² of it.
    const double relative = (error + 0x1p-97 * y.size()) * per_radius.value + 0x1p-99;
    for (int i = 0; i < N; ++i) {
        const auto s = path.at(i);
        path.take_position(s, i, wall_component::position, c.position[i]);
        const int at_point = static_cast<int>(wall_component::point) + i;
        if (i == axis) {
            path.take_unturned(s, i, c);
            continue;
        }
        const auto unit = product_in_parts<Fused>(y[i], per_radius);
        path.take({unit.value, unit.error, relative}, static_cast<int>(wall_component::normal) + i, c.normal[i]);
        const auto velocity = sum_in_parts({f.u[i], 0}, negated(product_in_parts<Fused>(change, y[i])));
        path.take({velocity.value, velocity.error, 8 * V * relative}, static_cast<int>(wall_component::velocity) + i,
                  c.velocity[i]);
        if (d == nullptr || axis >= 0) {
            if constexpr (N == 3) {
                if (corner == 3) {
                    const auto edge = difference_in_parts<N>(exact_components<N>(f.corner), -f.edge[0]);
                    const auto far = difference_in_parts<N>(edge, -f.edge[1]);
                    path.take({far[i].value, far[i].error, 0x1p-103 * far.size()}, at_point, c.point[i]);
                    continue;
                }
            }
            path.take.sum(f.corner[i], corner == 0 ? 0 : f.edge[corner - 1][i], at_point, c.point[i]);
        } else {
            const auto point = sum_in_parts(s.position, negated(y[i]));
            path.take({point.value, point.error, s.error + s.size + error + 0x1p-100 * y.size()}, at_point, c.point[i]);
        }
    }
}

// Fills in what is certain for a hit near `time`, or for an overlap with a plane or a face at 0. Returns what is open,
// which is everything if nothing is known. clock(τ): the time that is wanted; for an overlap it is 0.
template <int N, class T, class Clock>
struct flat_contact_near {
    wall_contact<N, T>* c;
    event_kind kind;
    int index;
    const T* row;
    double time;
    const Clock* clock;

    template <bool Fused>
    [[nodiscard, gnu::always_inline]] component_set operator()(std::bool_constant<Fused>) const noexcept {
        return given_to<Fused>(certain_components<N, T>{});
    }
    // Gives `take` what is exact, and the rest with bounds. Take: certain_components, or what a test looks at them
    // with.
    template <bool Fused, class Take>
    [[nodiscard, gnu::always_inline]] component_set given_to(Take take) const noexcept {
        const flat_row<N> f(kind, row);
        double V = 0, size = f.r;
        for (int i = 0; i < N; ++i) {
            V += absolute(f.u[i]);
            size += absolute(f.x[i]) + absolute(f.corner[i]);
        }
        if (kind == event_kind::plane || kind == event_kind::face) {
            const auto from = difference_in_parts<N>(f.x, f.corner);
            auto touch = touch_face<Fused, N>(from, f.u, normal_in_parts<Fused>(kind, f), f.r, time);
            if (time == 0) {
                touch.time = {
                    0, 0, 0, touch.length.spread < 0x1p8 && absolute(touch.speed.value) > 0x1p-32 * V * touch.n.size()};
                take.exact(0, 0, c->time);
            }
            if (!(touch.time.good && are_moderate(size, V, touch.n.size(), time == 0 ? 1.0 : time))) [[unlikely]] {
                return all_components;
            }
            if (time != 0) {
                take((*clock)(touch.time.bounds()), 0, c->time);
            }
            take_face_contact<Fused, N, T, Take>(*c, {f, touch.time, take}, touch, V, time == 0 ? &from : nullptr);
            return take.open_components();
        }
        const bool is_edge = N == 3 && kind == event_kind::edge;
        const int from_corner = is_edge ? edge_view(index).corner : index;
        const auto from = centre_in_parts(f, from_corner);
        parts_vector<N> d{};
        flat_time t{};
        if constexpr (N == 3) {
            if (is_edge) {
                d = edge_in_parts<3>(f, index);
                t = touch_edge<Fused>(from, f.u, d, f.r, time);
            }
        }
        if (!is_edge) {
            t = touch_corner<Fused, N>(from, f.u, f.r, time);
        }
        if (!(t.good && are_moderate(size + from.size(), V, is_edge ? d.size() : 1.0, time, f.r))) [[unlikely]] {
            return all_components;
        }
        take((*clock)(t.bounds()), 0, c->time);
        auto y = moved<Fused, N>(from, f.u, t.high);
        for (int i = 0; i < N; ++i) {
            y.component[i].error += f.u[i] * t.low;
        }
        take_round_contact<Fused, N, T, Take>(*c, {f, t, take}, y, 1.01 * V * t.error + 0x1p-100 * y.size(),
                                              is_edge ? &d : nullptr, from_corner, V);
        return take.open_components();
    }
};

} // namespace graze::inline v0_1::detail
