// classify for exact number types (rationals, integers of any library): the formulas as they are, which are then
// decisions.
#pragma once

#include <graze/exact/binary.hpp>
#include <graze/formula/solve_wall.hpp>
#include <graze/machine/failure.hpp>

#include <string>

namespace graze::inline v0_1 {

namespace detail {

template <int N, class T>
constexpr void require_radius(const ball<N, T>& b, const char* argument) {
    if (graze::sign(b.radius) < 0) {
        detail::fail<std::domain_error>(std::string(argument) + ": radius is negative");
    }
}

// wall_decision's questions answered in an exact type, whose sums and products may be other types than T.
template <class M>
class exact_signs {
  public:
    constexpr explicit exact_signs(const M& m) : m_(m) {}

    template <class F>
    [[nodiscard]] constexpr int operator()(wall_view view, F f) const {
        return graze::sign(f(seen_from(m_, view)));
    }
    template <class P, class Q, class D>
    [[nodiscard]] constexpr int root(wall_view view, P p, Q q, D d, int flip) const {
        const auto m = seen_from(m_, view);
        return flip < 0 ? sign_of_root_sum(p(m), -q(m), d(m)) : sign_of_root_sum(p(m), q(m), d(m));
    }
    [[nodiscard]] constexpr int edge_discriminant(wall_view view) const {
        return (*this)(view, edge_reduced_discriminant{});
    }
    [[nodiscard]] constexpr int corner_discriminant(wall_view view) const {
        return (*this)(view, corner_formula<discriminant_lagrange>{});
    }

  private:
    const M& m_;
};

} // namespace detail

// What becomes of a pair, exactly. Throws std::domain_error for a negative radius, a zero normal, a zero edge or
// parallel edges.
template <int N, exact_number T>
requires(!is_binary_input<T>) [[nodiscard]] constexpr encounter classify(const ball<N, T>& a, const ball<N, T>& b) {
    detail::require_radius(a, "ball a");
    detail::require_radius(b, "ball b");
    const auto m = relative_motion_of(a, b);
    const auto q = quadratic_of(m);
    return encounter_of([&] { return graze::sign(q.h); }, [&] { return graze::sign(q.c); },
                        [&] { return graze::sign(discriminant_halved{}(q)); });
}
template <int N, exact_number T>
requires(!is_binary_input<T>) [[nodiscard]] constexpr encounter classify(const ball<N, T>& b, const plane<N, T>& p) {
    detail::require_radius(b, "ball");
    const auto m = relative_motion_of(b, p);
    if (graze::sign(graze::squared_norm(m.n)) == 0) {
        detail::fail<std::domain_error>("plane: normal is zero");
    }
    return encounter_of([&] { return graze::sign(plane_height{}(m)) * graze::sign(plane_speed{}(m)); },
                        [&] { return graze::sign(plane_clearance{}(m)); }, [] { return 1; });
}
template <int N, exact_number T>
requires(!is_binary_input<T>) [[nodiscard]] constexpr encounter classify(const ball<N, T>& b, const wall<N, T>& w) {
    detail::require_radius(b, "ball");
    const auto m = relative_motion_of(b, w);
    for (const auto& e : w.edge) {
        if (graze::sign(graze::squared_norm(e)) == 0) {
            detail::fail<std::domain_error>("wall: edge is zero");
        }
    }
    if (graze::sign(graze::squared_norm(m.n)) == 0) {
        detail::fail<std::domain_error>("wall: edges are parallel");
    }
    detail::exact_signs<std::remove_cvref_t<decltype(m)>> signs(m);
    return wall_decision<N, decltype(signs)>(signs)().what;
}

// In an inexact type that classify has no proven filter for, the formulas promise nothing.
template <int N, number T, class Other>
requires(!is_binary_input<T> && !exact_number<T>) constexpr encounter classify(const ball<N, T>&, const Other&) {
    static_assert(is_binary_input<T>,
                  "graze::classify decides exactly, for float, double, std::int32_t, std::int64_t and exact "
                  "number types; for the formulas in another inexact type call graze::solve");
    return encounter::recede;
}

} // namespace graze::inline v0_1
