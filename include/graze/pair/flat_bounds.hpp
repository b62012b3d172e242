// Bounds on the errors of doubles in the numbers that decide the encounter of a ball and a flat thing.
#pragma once

#include <graze/analysis/error_bound.hpp>
#include <graze/formula/flat_encounter.hpp>
#include <graze/pair/computed_motion.hpp>

namespace graze::inline v0_1::detail {

// A flat motion's numbers for error_bound. The scale of lengths bounds |w| + r + Σ|e_i|, the third scale each |e_i|,
// and |e₁ - e₀| of a triangle: a number of a lower degree in w may be taken as one of a higher.
template <int N, class T>
struct flat_bounds {
    static constexpr int roundings = is_wide_integer<T> ? 8 : 3; // of w, which up to two edges may shift
    [[nodiscard]] static consteval error_bound edge() { return {1, bounded_input<T>({0, 0, 1}, 1).error, {0, 0, 1}}; }
    [[nodiscard]] static consteval flat_motion<N, error_bound> motion() {
        flat_motion<N, error_bound> m{bounded_vector<N>(detail::rounded(1, 0, 1, roundings, {1, 0, 0})),
                                      bounded_vector<N>(bounded_velocity<T>(0)),
                                      {},
                                      bounded_length<T>(0),
                                      true};
        for (auto& e : m.e) {
            e = bounded_vector<N>(edge());
        }
        return m;
    }
    [[nodiscard]] static consteval error_bound as_length(const error_bound& x) { // one edge of it
        return {x.magnitude, x.error, {x.degree[0] + 1, x.degree[1], x.degree[2] - 1}};
    }
    [[nodiscard]] static consteval flat_way<N, error_bound> way() {
        auto x = way_of(motion());
        x.facing = as_length(x.facing);
        return x;
    }
    [[nodiscard]] static consteval flat_extent<error_bound> extent() {
        const auto m = motion();
        const error_bound ue = as_length(graze::dot(m.u, m.e[0]));
        return {graze::dot(m.w, m.u), ue + ue, ue + ue};
    }
    [[nodiscard]] static consteval flat_edges<N, error_bound> edges() {
        const error_bound ee = graze::squared_norm(motion().e[0]);
        return {ee, ee, ee};
    }
    [[nodiscard]] static consteval flat_hull<N, error_bound> hull() {
        const auto m = motion();
        const error_bound ee = as_length(as_length(graze::squared_norm(m.e[0])));
        return {m.w + m.w, m.u, m.r, ee + ee + graze::twice(ee)};
    }
    [[nodiscard]] static consteval flat_place<N, error_bound> place() {
        auto x = place_of(motion(), way_of(motion()));
        x.facing = as_length(x.facing);
        return x;
    }
    // | |n| - |n̂| | <= |n - n̂|; the root of n̂·n̂, which is right to 4u, is right to 2u + 2u by its square
    // (filtered_judge).
    [[nodiscard]] static consteval flat_touch<N, error_bound> touch() {
        const auto x = way();
        const error_bound n = face_normal(motion().e)[0];
        return {{n.magnitude, n.error + 4 * n.magnitude, n.degree}, x.facing, x.r, x.at, x.pull};
    }
    [[nodiscard]] static consteval flat_edge<N, error_bound> border() {
        const auto m = motion();
        const auto w = way();
        const error_bound wd = graze::dot(m.w, m.e[0]), wu = graze::dot(m.w, m.u), dd = graze::dot(m.e[0], m.e[0]);
        const error_bound ud = graze::dot(m.u, m.e[0]);
        return {graze::dot(m.w, m.w),
                wd,
                wu,
                dd,
                ud,
                graze::dot(m.u, m.u),
                m.r,
                wd - as_length(dd),
                wu - as_length(ud),
                inside_border{}(w),
                inward_speed{}(w),
                w.speed,
                graze::cross(m.w, m.u)};
    }
};

// The numbers that a formula takes.
template <class B, int N>
[[nodiscard]] consteval auto bounds_like(const flat_way<N, double>*) {
    return B::way();
}
template <class B, int N>
[[nodiscard]] consteval auto bounds_like(const flat_place<N, double>*) {
    return B::place();
}
template <class B>
[[nodiscard]] consteval auto bounds_like(const flat_extent<double>*) {
    return B::extent();
}
template <class B, int N>
[[nodiscard]] consteval auto bounds_like(const flat_edges<N, double>*) {
    return B::edges();
}
template <class B, int N>
[[nodiscard]] consteval auto bounds_like(const flat_hull<N, double>*) {
    return B::hull();
}
template <class B, int N>
[[nodiscard]] consteval auto bounds_like(const flat_touch<N, double>*) {
    return B::touch();
}
template <class B, int N>
[[nodiscard]] consteval auto bounds_like(const flat_edge<N, double>*) {
    return B::border();
}

} // namespace graze::inline v0_1::detail
