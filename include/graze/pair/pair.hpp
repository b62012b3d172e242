// A pair as a row of numbers, lengths first, then velocities, then normals: lift takes it and an impact_time keeps
// it.
#pragma once

#include <graze/filter/exact_stage.hpp>
#include <graze/formula/wall_features.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstring>
#include <type_traits>

namespace graze::inline v0_1::detail {

// Two numbers at a time and without a loop: they are soon read as pairs, which is faster if they are written as pairs.
template <int N, class T>
[[gnu::always_inline]] constexpr inline void copy_vector(T* row, const vec<N, T>& x) noexcept {
    if (std::is_constant_evaluated()) {
        std::copy_n(x.component, N, row);
    } else {
        std::memcpy(row, x.component, sizeof(x.component));
    }
}

// Each pair kind has: how many lengths, velocities and normals it has, and epochs if its movers are flights; pack,
// which writes the row; and motion, which turns lifted inputs into the relative motion that the formulas take.
template <int N>
struct two_balls {
    static constexpr std::size_t n = N;
    static constexpr std::size_t lengths = 2 * n + 2;
    static constexpr std::size_t velocities = 2 * n;
    static constexpr std::size_t normals = 0;
    static constexpr std::size_t epochs = 2;

    template <class T>
    static constexpr void pack(T* row, const ball<N, T>& a, const ball<N, T>& b) noexcept {
        copy_vector(row, a.position);
        copy_vector(row + n, b.position);
        copy_vector(row + lengths, a.velocity);
        copy_vector(row + lengths + n, b.velocity);
        row[2 * n] = a.radius;
        row[2 * n + 1] = b.radius;
    }

    template <class I, class Inputs>
    [[nodiscard]] static constexpr auto motion(const Inputs& in) noexcept {
        const auto difference = [](const auto& group) {
            return make_vec<N>([&](int i) {
                const auto of_a = static_cast<std::size_t>(i);
                return group.template sum<I>(of_a, of_a + n, true);
            });
        };
        return relative_motion{difference(in.length), difference(in.velocity),
                               in.length.template sum<I>(2 * n, 2 * n + 1, false)};
    }
};

template <int N>
struct ball_and_plane {
    static constexpr std::size_t n = N;
    static constexpr std::size_t lengths = 2 * n + 1;
    static constexpr std::size_t velocities = n;
    static constexpr std::size_t normals = n;
    static constexpr std::size_t epochs = 1;

    template <class T>
    static constexpr void pack(T* row, const ball<N, T>& b, const plane<N, T>& p) noexcept {
        for (std::size_t i = 0; i < n; ++i) {
            row[i] = b.position.component[i];
            row[n + i] = p.point.component[i];
            row[lengths + i] = b.velocity.component[i];
            row[lengths + velocities + i] = p.normal.component[i];
        }
        row[2 * n] = b.radius;
    }

    template <class I, class Inputs>
    [[nodiscard]] static constexpr auto motion(const Inputs& in) noexcept {
        const auto vector = [](const auto& group, std::size_t from) {
            return make_vec<N>([&](int i) { return group.template get<I>(from + static_cast<std::size_t>(i)); });
        };
        return relative_motion_of(
            ball<N, I>{vector(in.length, 0), vector(in.velocity, 0), in.length.template get<I>(2 * n)},
            plane<N, I>{vector(in.length, n), vector(in.normal, 0)});
    }
};

template <int N>
struct ball_and_wall {
    static constexpr std::size_t n = N;
    static constexpr std::size_t lengths = (n + 1) * n + 1;
    static constexpr std::size_t velocities = n;
    static constexpr std::size_t normals = 0;
    static constexpr std::size_t epochs = 1;

    // For a wall or a triangle.
    template <class T, class W>
    static constexpr void pack(T* row, const ball<N, T>& b, const W& w) noexcept {
        for (std::size_t i = 0; i < n; ++i) {
            row[i] = b.position.component[i];
            row[n + i] = w.corner.component[i];
            for (std::size_t k = 0; k + 1 < n; ++k) {
                row[(2 + k) * n + i] = w.edge[k].component[i];
            }
            row[lengths + i] = b.velocity.component[i];
        }
        row[lengths - 1] = b.radius;
    }

    template <class I>
    struct shapes {
        graze::ball<N, I> ball;
        graze::wall<N, I> wall;
    };
    template <class I, class Inputs>
    [[nodiscard]] static constexpr shapes<I> shapes_of(const Inputs& in) noexcept {
        const auto vector = [](const auto& group, std::size_t from) {
            return make_vec<N>([&](int i) { return group.template get<I>(from + static_cast<std::size_t>(i)); });
        };
        shapes<I> s{{vector(in.length, 0), vector(in.velocity, 0), in.length.template get<I>(lengths - 1)},
                    {vector(in.length, n), {}}};
        for (std::size_t k = 0; k + 1 < n; ++k) {
            s.wall.edge[k] = vector(in.length, (2 + k) * n);
        }
        return s;
    }
    template <class I, class Inputs>
    [[nodiscard]] static constexpr auto motion(const Inputs& in) noexcept {
        const auto s = shapes_of<I>(in);
        return relative_motion_of(s.ball, s.wall);
    }
};

// The pair kind of a ball and a plane, wall or triangle. A triangle is the half of a wall.
template <class Shape>
struct kind_of_pair_with;
template <int N, class T>
struct kind_of_pair_with<plane<N, T>> {
    using type = ball_and_plane<N>;
};
template <int N, class T>
struct kind_of_pair_with<wall<N, T>> {
    using type = ball_and_wall<N>;
};
template <class T>
struct kind_of_pair_with<triangle<T>> {
    using type = ball_and_wall<3>;
};
template <class Shape>
using pair_with = typename kind_of_pair_with<Shape>::type;

// A plane, wall or triangle of that dimension and type.
template <class Shape, int N, class T>
concept standing_in = std::same_as<Shape, plane<N, T>> || std::same_as<Shape, wall<N, T>> ||
    (N == 3 && std::same_as<Shape, triangle<T>>);
// A plane, wall or triangle.
template <class Shape>
concept standing = requires {
    typename pair_with<Shape>;
};

template <class Shape>
inline constexpr bool is_triangle = false;
template <class T>
inline constexpr bool is_triangle<triangle<T>> = true;

// A triangle as the wall of which it is the half: its features are the wall's, except for the slanted edge.
template <class Shape>
[[nodiscard]] constexpr const Shape& as_wall(const Shape& s) noexcept {
    return s;
}
template <class T>
[[nodiscard]] constexpr wall<3, T> as_wall(const triangle<T>& t) noexcept {
    return {t.corner, t.edge};
}

// The row of a pair of kind P.
template <class P, int N, class T, class Y>
[[nodiscard]] constexpr auto packed(const ball<N, T>& x, const Y& y) noexcept {
    std::array<T, P::lengths + P::velocities + P::normals> row{};
    P::pack(row.data(), x, y);
    return row;
}

// A row of pair kind P, lifted.
template <class P, class Row>
[[nodiscard]] constexpr auto lift_row(const Row& row) noexcept {
    lifted_inputs<P::lengths, P::velocities, P::normals> r;
    lift(r.length, row.data());
    lift(r.velocity, row.data() + P::lengths);
    lift(r.normal, row.data() + P::lengths + P::velocities);
    return r;
}

} // namespace graze::inline v0_1::detail
