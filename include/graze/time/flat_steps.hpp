// When a ball touches a plane, a face, an edge or a corner, as a sum of two doubles with an error: one Newton step from
// a time in doubles, with the residual from error-free transforms.
//
// What parts_vector.hpp loses is bounded by 2^-97 of the sizes, for a face by 2^-98. proofs/contact/flat_steps.cpp
// shows that this is enough.
#pragma once

#include <graze/machine/fence.hpp>
#include <graze/time/certain_rounding.hpp>
#include <graze/time/parts_vector.hpp>

#include <cmath>

namespace graze::inline v0_1::detail {

// A time high + low. If not good, nothing is known of it.
struct flat_time {
    double high, low, error;
    bool good;

    [[nodiscard]] bounded<double> bounds() const noexcept { return {high, low, error}; }
};

// t + rest/rate, where rest has an error of at most `off`, and rate is right to a part `spread` of it. per_rate:
// 1/rate. Not good unless the step is below `longest` of t.
[[nodiscard, gnu::always_inline]] inline flat_time stepped(double t, double rest, double off, double per_rate,
                                                           double spread, double longest) noexcept {
    const double step = rest * per_rate;
    const auto sum = fast_two_sum(t, step);
    return {sum.value, sum.error, 1.01 * (off * per_rate + absolute(step) * (spread + 0x1p-50)),
            absolute(step) < longest * t && spread < 0x1p-16};
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
    f.length = root_in_parts<Fused>(dot_in_parts<Fused, N>(n, n), n.size());
    const auto velocity = exact_components<N>(u);
    f.speed = dot_in_parts<Fused, N>(velocity, n);
    const auto y = moved<Fused, N>(from, u, t);
    const auto height = dot_in_parts<Fused, N>(y, n);
    const auto reach = product_in_parts<Fused>({r, 0}, {f.length.high, f.length.low});
    const double side = std::copysign(1.0, -f.speed.value); // it approaches; no branch, since that is as good as random
    const auto rest = sum_in_parts({side * height.value, side * height.error}, negated(reach));
    const double k = f.length.spread;
    const double off = 0x1p-98 * (dot_of_sizes(y, n) + n.size() * r * (k * k * k));
    const double per_rate = 1 / absolute(f.speed.value);
    const double spread = 0x1p-48 * dot_of_sizes(velocity, n) * per_rate;
    f.time = stepped(t, rest.value + rest.error, off, per_rate, spread, 0x1p-4);
    f.time.good = f.time.good && k < 0x1p8;
    return f;
}

// When the distance from a line or a point is r. With f(t) = |z|² - r² k² and its half slope -h < 0 the step f/2h
// leaves a δ²/2h, a = |ż|², where δ, the way to the root, is within 1/4 of the step if a |step| < h/8. speed_size: of
// what ż is added up from, so that h is right to 2^-48 of that times z's size, and, where it is good at all, ż to
// 2^-20.
template <bool Fused, int N>
[[nodiscard, gnu::always_inline]] inline flat_time touch_round(const parts_vector<N>& z, const vec<N, double>& speed,
                                                               double speed_size, const exact_pair<double>& reach2,
                                                               double reach2_size, double t) noexcept {
    const auto rest = sum_in_parts(dot_in_parts<Fused, N>(z, z), negated(reach2));
    double h = 0, a = 0;
    for (int i = 0; i < N; ++i) {
        h -= z[i].value * speed[i];
        a += speed[i] * speed[i];
    }
    const double value = rest.value + rest.error;
    const double off = 0x1p-97 * (dot_of_sizes(z, z) + reach2_size);
    const double per_h = 1 / h;
    flat_time r = stepped(t, 0.5 * value, off, per_h, 0x1p-48 * (z.size() * speed_size) * per_h, 0x1p-16);
    const double step = 0.5 * value * per_h;
    r.error += 1.01 * (a * step * step) * per_h;
    r.good = r.good && a * absolute(step) < 0x1p-8 * h;
    return r;
}
template <bool Fused, int N>
[[nodiscard, gnu::always_inline]] inline flat_time touch_corner(const parts_vector<N>& from, const vec<N, double>& u,
                                                                double r, double t) noexcept {
    return touch_round<Fused, N>(moved<Fused, N>(from, u, t), u, exact_components<N>(u).size(),
                                 two_square(as_factor<Fused>(r)), r * r, t);
}
template <bool Fused>
[[nodiscard, gnu::always_inline]] inline flat_time touch_edge(const parts_vector<3>& from, const vec<3, double>& u,
                                                              const parts_vector<3>& d, double r, double t) noexcept {
    const auto z = cross_in_parts<Fused>(moved<Fused, 3>(from, u, t), d);
    const auto along = make_vec<3>([&](int i) { return d[i].value; });
    const auto reach2 = product_in_parts<Fused>(two_square(as_factor<Fused>(r)), dot_in_parts<Fused, 3>(d, d));
    return touch_round<Fused, 3>(z, graze::cross(u, along), exact_components<3>(u).size() * d.size(), reach2,
                                 r * r * dot_of_sizes(d, d), t);
}

} // namespace graze::inline v0_1::detail
