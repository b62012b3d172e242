// How the value that a number type computed is read, exactly.
#pragma once

#include "true_value.hpp"

#include <cmath>

namespace compare {

// Specialise for a number type T:
//   static computed read(const T& x, const true_value& right);   right: what it should be, for types that can only
//                                                                compare
//   static void settle(const T& x);   only of lazy types: makes x compute what printing it would need; it is timed
template <class T>
struct reader;

template <class T>
requires std::is_floating_point_v<T>
struct reader<T> {
    [[nodiscard]] static computed read(T x, const true_value&) {
        using widest = std::conditional_t<std::is_same_v<T, float>, double, T>;
        return std::isfinite(x) ? computed(wide_of(static_cast<widest>(x))) : computed(not_finite{});
    }
};

template <class T>
struct reader<graze::sqrt_extension<T>> {
    using real = graze::sqrt_extension<T>;
    [[nodiscard]] static computed read(const real& x, const true_value& right) {
        const computed p = reader<T>::read(x.p(), right), q = reader<T>::read(x.q(), right);
        return with_root(p, q, reader<T>::read(x.d(), right));
    }
    static void settle(const real& x) requires requires(const T& y) { reader<T>::settle(y); }
    {
        reader<T>::settle(x.p());
        reader<T>::settle(x.q());
        reader<T>::settle(x.d());
    }
};

} // namespace compare
