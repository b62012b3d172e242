// The constants of the quantities' bounds, as the compiler derives them.
#pragma once

#include "quantities.hpp"

#include <cstddef>
#include <stdexcept>

namespace bounds {

// K relative to norms, as the filters use it: |computed - exact| <= K u length^i velocity^j normal^k.
template <class Q, int N, int Digits>
inline constexpr double constant = [] {
    if constexpr (requires { Q::template compiled<N, Digits>(); }) {
        return Q::template compiled<N, Digits>() * graze::error_bound_slack;
    } else {
        compiled_source<Digits> s;
        const auto bound = Q::template run<N>(s);
        if (bound.degree != Q::degree) {
            throw std::logic_error("a quantity of another degree");
        }
        return bound.error * graze::error_bound_slack;
    }
}();

// The largest quotient of a norm and the largest component m is √N, since N m² - |x|² = Σ (m - x_i)(m + x_i). K times
// this, to each positive power, is the constant relative to components. For R, which is no vector, it is K.
template <class Q, int N>
inline constexpr double norm_factor = [] {
    if constexpr (requires { Q::has_vectors; }) {
        return 1.0;
    }
    int power = 0;
    for (const int d : Q::degree) {
        power += d > 0 ? d : 0;
    }
    double factor = power % 2 == 0 ? 1 : graze::detail::constant_sqrt(double{N});
    for (int i = 1; i < power; i += 2) {
        factor *= N;
    }
    return factor;
}();
template <class Q, int N, int Digits>
inline constexpr double compiled = constant<Q, N, Digits>* norm_factor<Q, N>;

// Counts the numbers that rounded_source and exact_source take.
struct counting_source {
    using number = graze::basic_error_bound<53>;
    std::size_t count = 0;
    [[nodiscard]] constexpr number input(kind k) { return ++count, number::exact_input(degree_of(k)); }
    [[nodiscard]] constexpr number difference(kind k) { return count += 2, number::exact_input(degree_of(k)); }
};
template <class Q, int N>
inline constexpr std::size_t inputs_of = [] {
    counting_source s;
    if constexpr (Q::of_two_balls) {
        (void)balls<N>(s);
    } else {
        (void)ball_and_plane<N>(s);
    }
    return s.count;
}();

} // namespace bounds
