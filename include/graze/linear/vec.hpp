// Vectors of the plane and of space, and the products that the equations use.
#pragma once

#include <graze/number/floating.hpp>

#include <cstddef>

namespace graze::inline v0_1 {

// N Cartesian coordinates, in any consistent unit. An aggregate: vec<2, double>{1, 2}. v[i] reads and writes; x(), y()
// and, in space, z() read.
template <int N, class T>
struct vec {
    static_assert(N == 2 || N == 3, "graze::vec: N is 2 or 3");
    T component[N];

    [[nodiscard]] constexpr T& operator[](int i) noexcept { return component[i]; }
    [[nodiscard]] constexpr const T& operator[](int i) const noexcept { return component[i]; }
    [[nodiscard]] constexpr const T& x() const noexcept { return component[0]; }
    [[nodiscard]] constexpr const T& y() const noexcept { return component[1]; }
    [[nodiscard]] constexpr const T& z() const noexcept requires(N == 3) { return component[2]; }

    [[nodiscard]] friend constexpr bool operator==(const vec& x, const vec& y) {
        for (int i = 0; i < N; ++i) {
            if (!(x[i] == y[i])) {
                return false;
            }
        }
        return true;
    }
};

// The vector of f(0), ..., f(N-1); its component type is what f returns.
template <int N, class F>
[[nodiscard]] constexpr auto make_vec(F f) {
    using T = std::remove_cvref_t<decltype(f(0))>;
    if constexpr (N == 2) {
        return vec<2, T>{{f(0), f(1)}};
    } else {
        return vec<3, T>{{f(0), f(1), f(2)}};
    }
}

template <int N, class T, class U>
[[nodiscard]] constexpr auto operator+(const vec<N, T>& x, const vec<N, U>& y) {
    return make_vec<N>([&](int i) { return x[i] + y[i]; });
}

template <int N, class T, class U>
[[nodiscard]] constexpr auto operator-(const vec<N, T>& x, const vec<N, U>& y) {
    return make_vec<N>([&](int i) { return x[i] - y[i]; });
}

template <int N, class T>
[[nodiscard]] constexpr auto operator-(const vec<N, T>& x) {
    return make_vec<N>([&](int i) { return -x[i]; });
}

template <int N, class S, class T>
[[nodiscard]] constexpr auto operator*(const S& s, const vec<N, T>& x) {
    return make_vec<N>([&](int i) { return s * x[i]; });
}

template <int N, class T, class S>
[[nodiscard]] constexpr auto operator/(const vec<N, T>& x, const S& s) {
    return make_vec<N>([&](int i) { return x[i] / s; });
}

// The inner product ⟨x,y⟩.
template <int N, class T, class U>
[[nodiscard]] constexpr auto dot(const vec<N, T>& x, const vec<N, U>& y) {
    if constexpr (requires { number_traits<T>::dot(x, y); }) {
        return number_traits<T>::dot(x, y);
    } else if constexpr (N == 2) {
        return x[0] * y[0] + x[1] * y[1];
    } else {
        return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
    }
}

// x × y in space: a vector.
template <class T, class U>
[[nodiscard]] constexpr auto cross(const vec<3, T>& x, const vec<3, U>& y) {
    if constexpr (requires { number_traits<T>::cross(x, y); }) {
        return number_traits<T>::cross(x, y);
    } else {
        using V = std::remove_cvref_t<decltype(x[0] * y[0] - x[0] * y[0])>;
        return vec<3, V>{{x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]}};
    }
}

// x × y in the plane: a number.
template <class T, class U>
[[nodiscard]] constexpr auto cross(const vec<2, T>& x, const vec<2, U>& y) {
    if constexpr (requires { number_traits<T>::cross(x, y); }) {
        return number_traits<T>::cross(x, y);
    } else {
        return x[0] * y[1] - x[1] * y[0];
    }
}

// ⟨x,x⟩. For a number, its square, so that |x × y|² is squared_norm(cross(x, y)) in the plane and in space.
template <int N, class T>
[[nodiscard]] constexpr auto squared_norm(const vec<N, T>& x) {
    if constexpr (requires { number_traits<T>::squared_norm(x); }) {
        return number_traits<T>::squared_norm(x);
    } else {
        return dot(x, x);
    }
}
template <number T>
[[nodiscard]] constexpr auto squared_norm(const T& x) {
    return x * x;
}

} // namespace graze::inline v0_1
