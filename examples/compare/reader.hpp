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
        return std::isfinite(x) ? computed(wide(x)) : computed(not_finite{});
    }
};

template <class T>
struct reader<graze::sqrt_extension<T>> {
    using real = graze::sqrt_extension<T>;
    [[nodiscard]] static computed read(const real& x, const true_value& right) {
        const auto part = [&](const T& y) { return std::get<exact_real>(reader<T>::read(y, right)).p(); };
        return exact_real(part(x.p()), part(x.q()), part(x.d()));
    }
    static void settle(const real& x) requires requires(const T& y) { reader<T>::settle(y); }
    {
        reader<T>::settle(x.p());
        reader<T>::settle(x.q());
        reader<T>::settle(x.d());
    }
};

} // namespace compare
