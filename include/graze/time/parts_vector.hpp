// Numbers and vectors as sums of two doubles, each with the sizes that bound what its computation loses.
//
// u = 2^-53, doubles rounded to nearest. A number in parts is value + error. Only low parts are rounded, each at most a
// few u of the sizes that are added up on the way. So all roundings and the products of two low parts come to some tens
// of u² = 2^-106 of those sizes.
#pragma once

#include <graze/linear/vec.hpp>
#include <graze/machine/error_free.hpp>
#include <graze/machine/lanes.hpp>

namespace graze::inline v0_1::detail {

// A vector in parts, and for each component the sum of the magnitudes that it was added up from.
template <int N>
struct parts_vector {
    exact_pair<double> component[N];
    double sizes[N];

    [[nodiscard, gnu::always_inline]] const exact_pair<double>& operator[](int i) const noexcept {
        return component[i];
    }
    [[nodiscard, gnu::always_inline]] double size() const noexcept {
        double sum = sizes[0] + sizes[1];
        if constexpr (N == 3) {
            sum += sizes[2];
        }
        return sum;
    }
};
// f(i) gives a component and its size.
struct sized_pair {
    exact_pair<double> value;
    double size;
};
template <int N, class F>
[[nodiscard, gnu::always_inline]] inline parts_vector<N> make_parts(F f) noexcept {
    const sized_pair x = f(0), y = f(1);
    if constexpr (N == 2) {
        return {{x.value, y.value}, {x.size, y.size}};
    } else {
        const sized_pair z = f(2);
        return {{x.value, y.value, z.value}, {x.size, y.size, z.size}};
    }
}
template <int N>
[[nodiscard, gnu::always_inline]] inline parts_vector<N> exact_components(const vec<N, double>& x) noexcept {
    return make_parts<N>([&](int i) { return sized_pair{{x[i], 0}, absolute(x[i])}; });
}
[[nodiscard, gnu::always_inline]] inline sized_pair difference_in_parts(double x, double y) noexcept {
    const auto d = two_difference(x, y);
    return {d, absolute(d.value)};
}
// x - y of doubles, and x - y of parts and doubles.
template <int N>
[[nodiscard, gnu::always_inline]] inline parts_vector<N> difference_in_parts(const vec<N, double>& x,
                                                                             const vec<N, double>& y) noexcept {
    return make_parts<N>([&](int i) { return difference_in_parts(x[i], y[i]); });
}
template <int N>
[[nodiscard, gnu::always_inline]] inline parts_vector<N> difference_in_parts(const parts_vector<N>& x,
                                                                             const vec<N, double>& y) noexcept {
    return make_parts<N>([&](int i) {
        const auto d = two_difference(x[i].value, y[i]);
        return sized_pair{{d.value, d.error + x[i].error}, x.sizes[i] + absolute(y[i])};
    });
}

// x y, with the low part right to a few u² of the sizes.
template <bool Fused>
[[nodiscard, gnu::always_inline]] inline exact_pair<double> product_in_parts(const exact_pair<double>& x,
                                                                             const exact_pair<double>& y) noexcept {
    const auto p = two_product(as_factor<Fused>(x.value), as_factor<Fused>(y.value));
    return {p.value, p.error + (x.value * y.error + x.error * y.value)};
}
[[nodiscard, gnu::always_inline]] inline exact_pair<double> sum_in_parts(const exact_pair<double>& x,
                                                                         const exact_pair<double>& y) noexcept {
    const auto s = two_sum(x.value, y.value);
    return {s.value, s.error + (x.error + y.error)};
}
[[nodiscard, gnu::always_inline]] inline exact_pair<double> negated(const exact_pair<double>& x) noexcept {
    return {-x.value, -x.error};
}

template <bool Fused, int N>
[[nodiscard, gnu::always_inline]] inline exact_pair<double> dot_in_parts(const parts_vector<N>& x,
                                                                         const parts_vector<N>& y) noexcept {
    exact_pair<double> sum = product_in_parts<Fused>(x[0], y[0]);
    for (int i = 1; i < N; ++i) {
        sum = sum_in_parts(sum, product_in_parts<Fused>(x[i], y[i]));
    }
    return sum;
}
template <bool Fused>
[[nodiscard, gnu::always_inline]] inline parts_vector<3> cross_in_parts(const parts_vector<3>& x,
                                                                        const parts_vector<3>& y) noexcept {
    return make_parts<3>([&](int i) {
        const int j = i == 2 ? 0 : i + 1, k = 3 - i - j;
        return sized_pair{
            sum_in_parts(product_in_parts<Fused>(x[j], y[k]), negated(product_in_parts<Fused>(x[k], y[j]))),
            x.sizes[j] * y.sizes[k] + x.sizes[k] * y.sizes[j]};
    });
}
template <int N>
[[nodiscard, gnu::always_inline]] inline double dot_of_sizes(const parts_vector<N>& x,
                                                             const parts_vector<N>& y) noexcept {
    double sum = x.sizes[0] * y.sizes[0];
    for (int i = 1; i < N; ++i) {
        sum += x.sizes[i] * y.sizes[i];
    }
    return sum;
}

// from + u t: the centre relative to a point, where `from` is that at t = 0.
template <bool Fused, int N>
[[nodiscard, gnu::always_inline]] inline parts_vector<N> moved(const parts_vector<N>& from, const vec<N, double>& u,
                                                               double t) noexcept {
    const auto time = as_factor<Fused>(t);
    return make_parts<N>([&](int i) {
        const auto way = two_product(as_factor<Fused>(u[i]), time);
        return sized_pair{sum_in_parts(from[i], way), from.sizes[i] + absolute(way.value)};
    });
}

} // namespace graze::inline v0_1::detail
