// Where a batch finds its balls: one by one, and as many at a time as a register has lanes.
#pragma once

#include <graze/machine/transpose.hpp>
#include <graze/pair/lane_shapes.hpp>
#include <graze/pair/moving.hpp>
#include <graze/shape/columns.hpp>
#include <graze/shape/shape_access.hpp>

#include <array>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>

namespace graze::inline v0_1::detail {

// Every source has: at(i), ball i; lanes_from<V>(i), the balls from i on; lanes_at<V>(i), ball i[k] in lane k.
template <int N, class T>
struct column_source {
    using scalar = T;
    static constexpr int dimension = N;
    columns<N, T> balls;

    [[nodiscard]] std::size_t size() const noexcept { return balls.size; }
    [[nodiscard]] ball<N, T> at(std::size_t i) const noexcept {
        const auto component = [i](const auto& column) {
            return make_vec<N>([&](int k) { return column[static_cast<std::size_t>(k)][i]; });
        };
        return {component(balls.position), component(balls.velocity), balls.radius[i]};
    }
    template <class V>
    [[nodiscard, gnu::always_inline]] ball<N, V> lanes_from(std::size_t i) const noexcept {
        return each<V>([i](const T* column) { return V::load(column + i); });
    }
    template <class V>
    [[nodiscard, gnu::always_inline]] ball<N, V> lanes_at(const std::array<std::size_t, V::lanes>& i) const noexcept {
        return each<V>(
            [&i](const T* column) { return V::made([&](int k) { return column[i[static_cast<std::size_t>(k)]]; }); });
    }

  private:
    template <class V, class F>
    [[nodiscard, gnu::always_inline]] ball<N, V> each(const F& f) const noexcept {
        const auto vector = [&f](const auto& columns) {
            return make_vec<N>([&](int k) { return f(columns[static_cast<std::size_t>(k)]); });
        };
        return {vector(balls.position), vector(balls.velocity), f(balls.radius)};
    }
};

template <int N, class T>
struct array_source {
    using scalar = T;
    static constexpr int dimension = N;
    const ball<N, T>* balls;
    std::size_t count;

    [[nodiscard]] std::size_t size() const noexcept { return count; }
    [[nodiscard]] const ball<N, T>& at(std::size_t i) const noexcept { return balls[i]; }
    template <class V>
    [[nodiscard, gnu::always_inline]] ball<N, V> lanes_from(std::size_t i) const noexcept {
        return transposed_balls<V>([this, i](int k) { return balls + (i + static_cast<std::size_t>(k)); });
    }
    template <class V>
    [[nodiscard, gnu::always_inline]] ball<N, V> lanes_at(const std::array<std::size_t, V::lanes>& i) const noexcept {
        return transposed_balls<V>([this, &i](int k) { return balls + i[static_cast<std::size_t>(k)]; });
    }

  private:
    // For the balls that f(k) points to.
    template <class V, class F>
    [[nodiscard, gnu::always_inline]] ball<N, V> transposed_balls(const F& f) const noexcept {
        constexpr int numbers_a_ball = 2 * N + 2; // the mass comes with the radius
        static_assert(sizeof(ball<N, T>) == numbers_a_ball * sizeof(T) && std::is_standard_layout_v<ball<N, T>>);
        const auto numbers =
            transposed<numbers_a_ball, T, V::lanes>([&f](int k) { return reinterpret_cast<const T*>(f(k)); });
        const auto vector = [&numbers](int from) {
            return make_vec<N>([&numbers, from](int k) { return numbers[static_cast<std::size_t>(from + k)]; });
        };
        return {vector(0), vector(N), numbers[2 * N]};
    }
};

// One thing beside all balls.
template <class S>
struct single_source {
    const S* one;

    [[nodiscard]] const S& at(std::size_t) const noexcept { return *one; }
};
template <int N, class T>
struct single_source<ball<N, T>> {
    const ball<N, T>* one;

    [[nodiscard]] const ball<N, T>& at(std::size_t) const noexcept { return *one; }
    template <class V>
    [[nodiscard, gnu::always_inline]] ball<N, V> lanes_from(std::size_t) const noexcept {
        return filled<V>(*one);
    }
    template <class V>
    [[nodiscard, gnu::always_inline]] ball<N, V> lanes_at(const std::array<std::size_t, V::lanes>&) const noexcept {
        return filled<V>(*one);
    }
};

// A user's balls, in a row, and one thing of a user's type. graze::compiled never sees types that are not graze's own.
template <ball_like B>
struct foreign_source {
    using shape = decltype(shape_of(std::declval<const B&>()));
    using scalar = number_in<shape>;
    static constexpr int dimension = dimension_of<shape>;
    static constexpr bool is_foreign = true;
    const B* balls;
    std::size_t count;

    [[nodiscard]] std::size_t size() const noexcept { return count; }
    [[nodiscard]] shape at(std::size_t i) const { return shape_of(balls[i]); }
    template <class V>
    [[nodiscard, gnu::always_inline]] ball<dimension, V> lanes_from(std::size_t i) const {
        return read<V>([i](int k) { return i + static_cast<std::size_t>(k); });
    }
    template <class V>
    [[nodiscard, gnu::always_inline]] ball<dimension, V> lanes_at(const std::array<std::size_t, V::lanes>& i) const {
        return read<V>([&i](int k) { return i[static_cast<std::size_t>(k)]; });
    }

  private:
    template <class V, class F>
    [[nodiscard, gnu::always_inline]] ball<dimension, V> read(const F& index) const {
        std::array<shape, V::lanes> here;
        for (int k = 0; k < V::lanes; ++k) {
            here[static_cast<std::size_t>(k)] = shape_of(balls[index(k)]);
        }
        return array_source<dimension, scalar>{here.data(), V::lanes}.template lanes_from<V>(0);
    }
};
template <class S>
struct held_source {
    static constexpr bool is_foreign = true;
    S one;

    [[nodiscard]] const S& at(std::size_t) const noexcept { return one; }
    template <class V>
    requires requires(const single_source<S>& s) { s.template lanes_from<V>(0); }
    [[nodiscard, gnu::always_inline]] auto lanes_from(std::size_t) const noexcept { return filled<V>(one); }
    template <class V>
    requires requires(const single_source<S>& s) { s.template lanes_from<V>(0); }
    [[nodiscard, gnu::always_inline]] auto lanes_at(const std::array<std::size_t, V::lanes>&) const noexcept {
        return filled<V>(one);
    }
};
template <class A>
inline constexpr bool is_foreign = false;
template <class A>
requires(A::is_foreign) inline constexpr bool is_foreign<A> = true;

// A caller's argument, as a source.
template <int N, class T>
[[nodiscard]] constexpr column_source<N, T> source_of(const columns<N, T>& x) noexcept {
    return {x};
}
template <int N, class T>
[[nodiscard]] constexpr array_source<N, T> array_of(const ball<N, T>* first, std::size_t count) noexcept {
    return {first, count};
}
template <ball_like B>
requires(!is_flight<decltype(shape_of(std::declval<const B&>()))>)
    [[nodiscard]] constexpr foreign_source<B> array_of(const B* first, std::size_t count) noexcept {
    return {first, count};
}
template <class R>
requires requires(const R& r) { array_of(std::data(r), std::size(r)); }
[[nodiscard]] constexpr auto source_of(const R& r) noexcept { return array_of(std::data(r), std::size(r)); }

template <int N, class T>
[[nodiscard]] constexpr single_source<ball<N, T>> source_of(const ball<N, T>& x) noexcept {
    return {&x};
}
template <int N, class T>
[[nodiscard]] constexpr single_source<plane<N, T>> source_of(const plane<N, T>& x) noexcept {
    return {&x};
}
template <int N, class T>
[[nodiscard]] constexpr single_source<wall<N, T>> source_of(const wall<N, T>& x) noexcept {
    return {&x};
}

template <class T>
[[nodiscard]] constexpr single_source<triangle<T>> source_of(const triangle<T>& x) noexcept {
    return {&x};
}

template <foreign_shape S>
[[nodiscard]] constexpr auto source_of(const S& x) {
    return held_source<decltype(shape_of(x))>{shape_of(x)};
}

template <class A>
using source_for = decltype(source_of(std::declval<const A&>()));

// Whether S is a shape in N dimensions whose numbers are of type T.
template <class S, int N, class T>
inline constexpr bool is_shape_in = false;
template <int N, class T>
inline constexpr bool is_shape_in<ball<N, T>, N, T> = true;
template <int N, class T>
inline constexpr bool is_shape_in<plane<N, T>, N, T> = true;
template <int N, class T>
inline constexpr bool is_shape_in<wall<N, T>, N, T> = true;
template <class T>
inline constexpr bool is_shape_in<triangle<T>, 3, T> = true;

} // namespace graze::inline v0_1::detail
