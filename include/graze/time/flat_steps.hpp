// When a ball touches a plane, a face, an edge or a corner, as a sum of two doubles with an error: one Newton step from
// a time in doubles, with the residual from error-free transforms.
//
// u = 2^-53, doubles rounded to nearest. A number in parts is value + error. Only low parts are rounded, each at most a
// few u of the sizes that are added up on the way. So all roundings and the products of two low parts come to some tens
// of u² = 2^-106 of those sizes; the bound is 2^-97 of them, which proofs/contact/flat_steps.cpp shows to be enough.
#pragma once

#include <graze/linear/vec.hpp>
#include <graze/machine/error_free.hpp>
#include <graze/machine/fence.hpp>
#include <graze/machine/lanes.hpp>
#include <graze/time/certain_rounding.hpp>

#include <array>
#include <cmath>

namespace graze::inline v0_1::detail {

// A vector in parts with the sum of the sizes of the terms of its components.
template <int N>
struct parts_vector {
    exact_pair<double> component[N];
    double size;

    [[nodiscard, gnu::always_inline]] const exact_pair<double>& operator[](int i) const noexcept {
        return component[i];
    }
};
template <int N, class F>
[[nodiscard, gnu::always_inline]] inline parts_vector<N> make_parts(F f) noexcept {
    double size = 0;
    if constexpr (N == 2) {
        const auto x = f(0, size), y = f(1, size);
        return {{x, y}, size};
    } else {
        const auto x = f(0, size), y = f(1, size), z = f(2, size);
        return {{x, y, z}, size};
    }
}
template <int N>
[[nodiscard, gnu::always_inline]] inline parts_vector<N> exact_components(const vec<N, double>& x) noexcept {
    return make_parts<N>([&](int i, double& size) {
        size += absolute(x[i]);
        return exact_pair<double>{x[i], 0};
    });
}
// x - y of doubles, and x - y of parts and doubles.
template <int N>
[[nodiscard, gnu::always_inline]] inline parts_vector<N> difference_in_parts(const vec<N, double>& x,
                                                                             const vec<N, double>& y) noexcept {
    return make_parts<N>([&](int i, double& size) {
        const auto d = two_difference(x[i], y[i]);
        size += absolute(d.value);
        return d;
    });
}
template <int N>
[[nodiscard, gnu::always_inline]] inline parts_vector<N> difference_in_parts(const parts_vector<N>& x,
                                                                             const vec<N, double>& y) noexcept {
    auto r = make_parts<N>([&](int i, double& size) {
        const auto d = two_difference(x[i].value, y[i]);
        size += absolute(y[i]);
        return exact_pair<double>{d.value, d.error + x[i].error};
    });
    r.size += x.size;
    return r;
}

// x y, its low part to a few u² of the sizes.
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
    auto r = make_parts<3>([&](int i, double&) {
        const int j = i == 2 ? 0 : i + 1, k = 3 - i - j;
        return sum_in_parts(product_in_parts<Fused>(x[j], y[k]), negated(product_in_parts<Fused>(x[k], y[j])));
    });
    r.size = x.size * y.size;
    return r;
}

// from + u t: the centre seen from a point, from which it is at `from` at t = 0.
template <bool Fused, int N>
[[nodiscard, gnu::always_inline]] inline parts_vector<N> moved(const parts_vector<N>& from, const vec<N, double>& u,
                                                               double t) noexcept {
    const auto time = as_factor<Fused>(t);
    auto r = make_parts<N>([&](int i, double& size) {
        const auto way = two_product(as_factor<Fused>(u[i]), time);
        size += absolute(way.value);
        return sum_in_parts(from[i], way);
    });
    r.size += from.size;
    return r;
}

// A time high + low; nothing is known unless good.
struct flat_time {
    double high, low, error;
    bool good;

    [[nodiscard]] bounded<double> bounds() const noexcept { return {high, low, error}; }
};

// t + rest/rate, rest to an error of at most `off`, the rate to a part `spread` of it. per_rate: 1/rate.
[[nodiscard, gnu::always_inline]] inline flat_time stepped(double t, double rest, double off, double per_rate,
                                                           double spread) noexcept {
    const double step = rest * per_rate;
    const auto sum = fast_two_sum(t, step);
    return {sum.value, sum.error, 1.01 * (off * per_rate + absolute(step) * (spread + 0x1p-50)),
            absolute(step) < 0x1p-16 * t && spread < 0x1p-16};
}

// √square for a square in parts, the square of something of at most `size`: with κ = size/√square the root of the
// leading part and one correction leave at most 2^-97 size κ³. 1/√square as √square/square: no quotient waits for the
// root.
struct parts_root {
    double high, low, spread; // spread: κ
};
template <bool Fused>
[[nodiscard, gnu::always_inline]] inline parts_root root_in_parts(const exact_pair<double>& square,
                                                                  double size) noexcept {
    const double root = settled(plain_sqrt(square.value));
    const double per_root = root * (1 / square.value);
    const auto back = two_square(as_factor<Fused>(root));
    const double rest = settled(settled(square.value - back.value) - back.error) + square.error;
    return {root, 0.5 * rest * per_root, size * per_root};
}

// A plane or face. τ = t + ρ/|u·n|, ρ = σ y·n - r|n|, exactly, since distances from a plane are linear.
template <int N>
struct face_touch {
    parts_vector<N> n;
    parts_root length;
    exact_pair<double> speed; // u·n
    flat_time time;
};
template <bool Fused, int N>
[[nodiscard, gnu::always_inline]] inline face_touch<N> touch_face(const parts_vector<N>& from, const vec<N, double>& u,
                                                                  const parts_vector<N>& n, double r,
                                                                  double t) noexcept {
    face_touch<N> f{n, {}, {}, {}};
    f.length = root_in_parts<Fused>(dot_in_parts<Fused, N>(n, n), n.size);
    const auto velocity = exact_components<N>(u);
    f.speed = dot_in_parts<Fused, N>(velocity, n);
    const auto y = moved<Fused, N>(from, u, t);
    const auto height = dot_in_parts<Fused, N>(y, n);
    const auto reach = product_in_parts<Fused>({r, 0}, {f.length.high, f.length.low});
    const double side = std::copysign(1.0, -f.speed.value); // it approaches; no branch, since that is as good as random
    const auto rest = sum_in_parts({side * height.value, side * height.error}, negated(reach));
    const double k = f.length.spread;
    const double off = 0x1p-97 * n.size * (y.size + r * (k * k * k));
    const double per_rate = 1 / absolute(f.speed.value);
    f.time = stepped(t, rest.value + rest.error, off, per_rate, 0x1p-48 * (velocity.size * n.size) * per_rate);
    f.time.good = f.time.good && k < 0x1p8;
    return f;
}

// When the distance from a line or a point is r. With f(t) = |z|² - r² k² and its half slope -h < 0 the step f/2h
// leaves a δ²/2h, a = |ż|², where δ, the way to the root, is within 1/4 of the step if a |step| < h/8.
template <bool Fused, int N>
[[nodiscard, gnu::always_inline]] inline flat_time touch_round(const parts_vector<N>& z, const vec<N, double>& speed,
                                                               const exact_pair<double>& reach2, double reach2_size,
                                                               double t) noexcept {
    const auto rest = sum_in_parts(dot_in_parts<Fused, N>(z, z), negated(reach2));
    double h = 0, size = 0, a = 0;
    for (int i = 0; i < N; ++i) {
        h -= z[i].value * speed[i];
        size += absolute(speed[i]);
        a += speed[i] * speed[i];
    }
    const double value = rest.value + rest.error;
    const double off = 0x1p-97 * (z.size * z.size + reach2_size);
    const double per_h = 1 / h;
    flat_time r = stepped(t, 0.5 * value, off, per_h, 0x1p-48 * (z.size * size) * per_h);
    const double step = 0.5 * value * per_h;
    r.error += 1.01 * (a * step * step) * per_h;
    r.good = r.good && a * absolute(step) < 0x1p-8 * h;
    return r;
}
template <bool Fused, int N>
[[nodiscard, gnu::always_inline]] inline flat_time touch_corner(const parts_vector<N>& from, const vec<N, double>& u,
                                                                double r, double t) noexcept {
    return touch_round<Fused, N>(moved<Fused, N>(from, u, t), u, two_square(as_factor<Fused>(r)), r * r, t);
}
template <bool Fused>
[[nodiscard, gnu::always_inline]] inline flat_time touch_edge(const parts_vector<3>& from, const vec<3, double>& u,
                                                              const parts_vector<3>& d, double r, double t) noexcept {
    const auto z = cross_in_parts<Fused>(moved<Fused, 3>(from, u, t), d);
    const auto along = make_vec<3>([&](int i) { return d[i].value; });
    const auto reach2 = product_in_parts<Fused>(two_square(as_factor<Fused>(r)), dot_in_parts<Fused, 3>(d, d));
    return touch_round<Fused, 3>(z, graze::cross(u, along), reach2, r * r * (d.size * d.size), t);
}

} // namespace graze::inline v0_1::detail
