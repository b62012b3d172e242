// The letters of the identities: vectors and numbers whose components are variables of their own.
#pragma once

#include <graze/analysis/rational_function.hpp>
#include <graze/linear/vec.hpp>

namespace graze::proof {

using letters = polynomial<>;

template <class T = letters>
[[nodiscard]] constexpr T letter(int index) {
    if constexpr (requires { T::variable(index); }) {
        return T::variable(index);
    } else {
        return T(T::polynomial::variable(index));
    }
}

// The variables from, from + 1, ...
template <int N, class T = letters>
[[nodiscard]] constexpr vec<N, T> vector(int from) {
    return make_vec<N>([&](int i) { return letter<T>(from + i); });
}

} // namespace graze::proof
