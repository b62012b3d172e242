// The formulas of graze, as the precision regression measures them.
#pragma once

#include <graze/formula/closest_approach.hpp>
#include <graze/formula/root_order.hpp>
#include <graze/formula/solve_balls.hpp>
#include <graze/formula/solve_flat.hpp>
#include <graze/formula/solve_plane.hpp>
#include <graze/precision/subject.hpp>

#include <concepts>
#include <type_traits>

namespace graze::inline v0_1::precision {

// a, h and c of two balls.
struct coefficients {
    static constexpr const char* name = "quadratic";
    static constexpr quantity measures = quantity::coefficient_h;
    template <int N, number T>
    [[nodiscard]] answer operator()(const ball<N, T>& a, const ball<N, T>& b) const {
        const quadratic<T, T, T> q = quadratic_of(relative_motion_of(a, b));
        return answered(quantity::coefficient_a, q.a)
            .and_(quantity::coefficient_h, q.h)
            .and_(quantity::coefficient_c, q.c);
    }
};

namespace detail {

template <variant V>
inline constexpr const char* name_of_variant = V == variant::textbook ? "textbook"
                                               : V == variant::halved ? "halved"
                                               : V == variant::kahan  ? "kahan"
                                                                      : "lagrange";
template <variant V, root_form F>
inline constexpr const char* name_of_method = "";
template <variant V>
inline constexpr const char* name_of_method<V, root_form::stable> = V == variant::textbook ? "textbook.stable"
                                                                    : V == variant::halved ? "halved.stable"
                                                                    : V == variant::kahan  ? "kahan.stable"
                                                                                           : "lagrange.stable";
template <variant V>
inline constexpr const char* name_of_method<V, root_form::printed> = V == variant::textbook ? "textbook.printed"
                                                                     : V == variant::halved ? "halved.printed"
                                                                     : V == variant::kahan  ? "kahan.printed"
                                                                                            : "lagrange.printed";

} // namespace detail

// D of two balls in variant V.
template <variant V>
struct discriminant_in {
    static constexpr const char* name = detail::name_of_variant<V>;
    static constexpr quantity measures = quantity::discriminant;
    template <int N, number T>
    requires has_variant<V, T>
    [[nodiscard]] answer operator()(const ball<N, T>& a, const ball<N, T>& b) const {
        const auto m = relative_motion_of(a, b);
        const quadratic<T, T, T> q = quadratic_of(m);
        return answered(quantity::discriminant,
                        graze::detail::discriminant_by<V, T>(q, [&] { return T(discriminant_lagrange{}(m)); }));
    }
};

// D of two balls by way of the closest approach; balls that rest relative to each other, which it cannot divide for,
// have D = 0. F is discriminant_closest or discriminant_factored.
template <class F>
struct discriminant_by_approach {
    static constexpr const char* name = std::is_same_v<F, discriminant_closest> ? "closest" : "factored";
    static constexpr quantity measures = quantity::discriminant;
    template <int N, number T>
    requires std::invocable<F, relative_motion<N, T, T, T>>
    [[nodiscard]] answer operator()(const ball<N, T>& a, const ball<N, T>& b) const {
        const auto m = relative_motion_of(a, b);
        return answered(quantity::discriminant, graze::sign(coefficient_a{}(m)) == 0 ? T(0) : T(F{}(m)));
    }
};

// The whole solution of graze::solve, in variant V and root form F.
template <variant V, root_form F>
struct solution_in {
    static constexpr const char* name = detail::name_of_method<V, F>;
    static constexpr quantity measures = quantity::encounter;
    template <int N, number T>
    requires has_variant<V, T>
    [[nodiscard]] answer operator()(const ball<N, T>& a, const ball<N, T>& b) const {
        return answered(solve_with_inverse_masses<V, F, T, N>(a, b, inverse(a.mass), inverse(b.mass)));
    }
    template <int N, number T>
    [[nodiscard]] answer operator()(const ball<N, T>& b, const plane<N, T>& p) const {
        return answered(solve<V, F>(b, p));
    }
    template <int N, number T>
    requires has_variant<V, T>
    [[nodiscard]] answer operator()(const ball<N, T>& b, const wall<N, T>& w) const {
        return answered(solve<V, F>(b, w));
    }
    template <number T>
    requires has_variant<V, T>
    [[nodiscard]] answer operator()(const ball<3, T>& b, const triangle<T>& t) const {
        return answered(solve<V, F>(b, t));
    }

  private:
    // The inverse of a mass. That of an infinite mass is 0, also under flags that promise finite numbers.
    template <class T>
    [[nodiscard]] static T inverse(const T& mass) {
        return detail::exponent_field(number_access<T>::read(mass).parts.front()) == 0x7ff ? T(0) : T(T(1) / mass);
    }
};

// The order of two pairs' times from their quadratics.
struct order_of_roots {
    static constexpr const char* name = "root_order";
    static constexpr quantity measures = quantity::order;
    template <int N, number T>
    [[nodiscard]] answer operator()(const ball<N, T>& a, const ball<N, T>& b, const ball<N, T>& c,
                                    const ball<N, T>& d) const {
        answer found;
        found.order = root_order{}(quadratic<T, T, T>(quadratic_of(relative_motion_of(a, b))),
                                   quadratic<T, T, T>(quadratic_of(relative_motion_of(c, d))));
        return found;
    }
};

// Every formula that T can run.
template <number T>
requires field_number<T> && has_sqrt<T>
void add_formulas(subjects& list) {
    add<coefficients, T>(list);
    add<discriminant_in<variant::textbook>, T>(list);
    add<discriminant_in<variant::halved>, T>(list);
    add<discriminant_in<variant::lagrange>, T>(list);
    add<solution_in<variant::textbook, root_form::printed>, T>(list);
    add<solution_in<variant::halved, root_form::printed>, T>(list);
    add<solution_in<variant::halved, root_form::stable>, T>(list);
    add<solution_in<variant::lagrange, root_form::printed>, T>(list);
    add<solution_in<variant::lagrange, root_form::stable>, T>(list);
    if constexpr (has_fma<T>) {
        add<discriminant_in<variant::kahan>, T>(list);
        add<solution_in<variant::kahan, root_form::stable>, T>(list);
    }
    add<order_of_roots, T>(list);
}

} // namespace graze::inline v0_1::precision
