// Vectors of other libraries and of users: how many components they have, of which type, and how to read them.
#pragma once

#include <graze/linear/vec.hpp>

#include <concepts>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

namespace graze::inline v0_1 {

namespace detail {

template <class V>
concept sized_vector = requires(const V& v) {
    v[0];
    std::tuple_size<V>::value;
};
template <class V>
concept calls_of_axes = requires(const V& v) {
    v.x();
    v.y();
};
template <class V>
concept members_of_axes = requires(const V& v) {
    v.x;
    v.y;
}
&&!requires(const V& v) { v.w; };

template <class V>
struct found_vector {};

template <sized_vector V>
struct found_vector<V> {
    static constexpr int dimension = static_cast<int>(std::tuple_size_v<V>);
    using scalar = std::remove_cvref_t<decltype(std::declval<const V&>()[0])>;
    [[nodiscard]] static constexpr scalar element(const V& v, int i) { return v[static_cast<std::size_t>(i)]; }
};

template <class T, std::size_t N>
struct found_vector<T[N]> {
    static constexpr int dimension = static_cast<int>(N);
    using scalar = T;
    [[nodiscard]] static constexpr T element(const T (&v)[N], int i) { return v[i]; }
};

template <class V>
requires(!sized_vector<V> && calls_of_axes<V>) struct found_vector<V> {
    static constexpr int dimension = requires(const V& v) { v.z(); }
    ? 3 : 2;
    using scalar = std::remove_cvref_t<decltype(std::declval<const V&>().x())>;
    [[nodiscard]] static constexpr scalar element(const V& v, int i) {
        if constexpr (dimension == 3) {
            if (i == 2) {
                return v.z();
            }
        }
        return i == 0 ? v.x() : v.y();
    }
};

template <class V>
requires(!sized_vector<V> && !calls_of_axes<V> && members_of_axes<V>) struct found_vector<V> {
    static constexpr int dimension = requires(const V& v) { v.z; }
    ? 3 : 2;
    using scalar = std::remove_cvref_t<decltype(std::declval<const V&>().x)>;
    [[nodiscard]] static constexpr scalar element(const V& v, int i) {
        if constexpr (dimension == 3) {
            if (i == 2) {
                return v.z;
            }
        }
        return i == 0 ? v.x : v.y;
    }
};

} // namespace detail

// How V is read as a vector. Specialise it for a type whose components are found in another way than below:
//   static constexpr int dimension;                     2 or 3
//   using scalar = ...;                                 the number type of the components
//   static constexpr scalar element(const V& v, int i); 0 <= i < dimension
// Without a specialisation, a type with that number of elements (std::tuple_size, or an array) is read by v[i]; any
// other type by v.x(), v.y() and, if it has that, v.z(), or by the members v.x, v.y and v.z.
template <class V>
struct vector_access : detail::found_vector<V> {};

// A type that can be read as a vec, or a vec itself.
template <class V>
concept vector_like = requires {
    typename vector_access<std::remove_cv_t<V>>::scalar;
}
&&(vector_access<std::remove_cv_t<V>>::dimension == 2 || vector_access<std::remove_cv_t<V>>::dimension == 3);

template <int N, class T>
struct vector_access<vec<N, T>> {
    static constexpr int dimension = N;
    using scalar = T;
    [[nodiscard]] static constexpr const T& element(const vec<N, T>& v, int i) noexcept { return v[i]; }
};

// The vec of the same components. A lazy expression of a library is evaluated here, once.
template <vector_like V>
[[nodiscard]] constexpr auto vec_of(const V& v) {
    using access = vector_access<std::remove_cv_t<V>>;
    return make_vec<access::dimension>([&](int i) -> typename access::scalar { return access::element(v, i); });
}

// A vec as another library's vector: vector_as<Eigen::Vector3d>(contact.normal).
template <class V, int N, class T>
requires(N == 2 &&
         requires(const T& x) {
             V{x, x};
         }) ||
    (N == 3 && requires(const T& x) {
        V{x, x, x};
    }) [[nodiscard]] constexpr V vector_as(const vec<N, T>& v) {
    if constexpr (N == 2) {
        return V{v[0], v[1]};
    } else {
        return V{v[0], v[1], v[2]};
    }
}

} // namespace graze::inline v0_1
