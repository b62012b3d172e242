// Reads the value that a number type computed, exactly.
#pragma once

#include "convert.hpp"
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

// For an exact type: whether x is the true value, decided in the type itself.
template <class T>
[[nodiscard]] bool is_exactly_right(const T& x, const true_value& right) {
    return graze::sign(right.exactly().q()) == 0 && graze::sign(T(x - convert<T>(right.exactly().p()))) == 0;
}
template <class T>
[[nodiscard]] bool is_exactly_right(const graze::sqrt_extension<T>& x, const true_value& right) {
    if (graze::sign(x.q()) == 0) {
        return is_exactly_right(x.p(), right);
    }
    const exact_real& due = right.exactly();
    const T q = convert<T>(due.q());
    return graze::sign(x.q()) == graze::sign(q) && graze::sign(T(x.p() - convert<T>(due.p()))) == 0 &&
           graze::sign(T(x.q() * x.q() * x.d() - q * q * convert<T>(due.d()))) == 0;
}

template <class T>
struct reader<graze::sqrt_extension<T>> {
    using real = graze::sqrt_extension<T>;
    [[nodiscard]] static computed read(const real& x, const true_value& right) {
        if (is_exactly_right(x, right)) {
            return exactly_right{};
        }
        return exact_real(reader<T>::value_of(x.p()), reader<T>::value_of(x.q()), reader<T>::value_of(x.d()));
    }
    static void settle(const real& x) requires requires(const T& y) { reader<T>::settle(y); }
    {
        reader<T>::settle(x.p());
        reader<T>::settle(x.q());
        reader<T>::settle(x.d());
    }
};

// A base for readers of exact rational types, which provide
//   static exact value_of(const T& x)
template <class T>
struct exact_reader {
    [[nodiscard]] static computed read(const T& x, const true_value& right) {
        return is_exactly_right(x, right) ? computed(exactly_right{}) : computed(exact_real(reader<T>::value_of(x)));
    }
};

} // namespace compare
