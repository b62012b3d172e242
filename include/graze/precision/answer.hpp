// A formula's answer for a pair, as the precision regression judges it.
#pragma once

#include <graze/formula/solution.hpp>
#include <graze/linear/vec.hpp>
#include <graze/precision/number_access.hpp>

#include <optional>
#include <utility>
#include <vector>

namespace graze::inline v0_1::precision {

// The quantities whose exact values the regression knows. position: those of the balls, or of a ball and of the point
// where it touches. order: the sign of t1 - t2 for two pairs.
enum class quantity {
    coefficient_a,
    coefficient_h,
    coefficient_c,
    discriminant,
    encounter,
    time,
    position,
    normal,
    velocity,
    order
};

inline constexpr quantity all_quantities[] = {quantity::coefficient_a, quantity::coefficient_h, quantity::coefficient_c,
                                              quantity::discriminant,  quantity::encounter,     quantity::time,
                                              quantity::position,      quantity::normal,        quantity::velocity,
                                              quantity::order};

[[nodiscard]] constexpr const char* to_string(quantity q) noexcept {
    constexpr const char* names[] = {"coefficient_a", "coefficient_h", "coefficient_c", "discriminant", "encounter",
                                     "time",          "position",      "normal",        "velocity",     "order"};
    return names[static_cast<int>(q)];
}

// A number, or the components of a vector.
struct value {
    quantity of;
    std::vector<reading> components;
};

// The index in an answer that tells the kind of a wall's feature, but not which one.
inline constexpr int index_unknown = -1;

// Built by `and_`. what: the encounter. where, index: the feature of a wall.
struct answer {
    std::optional<encounter> what;
    std::optional<feature> where;
    int index = 0;
    std::optional<int> order;
    std::vector<value> values; // of one quantity in the order in which graze::solve names them

    template <number T>
    [[nodiscard]] answer and_(quantity of, const T& x) && {
        values.push_back({of, {number_access<T>::read(x)}});
        return std::move(*this);
    }
    template <int N, number T>
    [[nodiscard]] answer and_(quantity of, const vec<N, T>& x) && {
        value v{of, {}};
        for (int i = 0; i < N; ++i) {
            v.components.push_back(number_access<T>::read(x[i]));
        }
        values.push_back(std::move(v));
        return std::move(*this);
    }
};

// An answer of one number or vector.
template <class X>
[[nodiscard]] answer answered(quantity of, const X& x) {
    return answer{}.and_(of, x);
}

// An answer that is a decision.
[[nodiscard]] inline answer answered(encounter what) {
    answer a;
    a.what = what;
    return a;
}
[[nodiscard]] inline answer answered(const wall_encounter& met) {
    answer a;
    a.what = met.what;
    a.where = met.where;
    a.index = met.index;
    return a;
}

// A whole solution, without its discriminant.
template <int N, class T>
[[nodiscard]] answer answered(const ball_solution<N, T>& s) {
    if (!is_collision(s.what)) {
        return answered(s.what);
    }
    return answered(s.what)
        .and_(quantity::time, s.time)
        .and_(quantity::position, s.position_a)
        .and_(quantity::position, s.position_b)
        .and_(quantity::normal, s.normal)
        .and_(quantity::velocity, s.velocity_a)
        .and_(quantity::velocity, s.velocity_b);
}
template <int N, class T>
[[nodiscard]] answer answered(const wall_solution<N, T>& s) {
    const wall_encounter met{s.what, s.where, s.index};
    if (!is_collision(s.what)) {
        return answered(met);
    }
    return answered(met)
        .and_(quantity::time, s.time)
        .and_(quantity::position, s.position)
        .and_(quantity::position, s.point)
        .and_(quantity::normal, s.normal)
        .and_(quantity::velocity, s.velocity);
}
[[nodiscard]] inline answer answered(answer a) { return a; }

} // namespace graze::inline v0_1::precision
