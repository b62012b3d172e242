#include "truth.hpp"

#include "conditioning.hpp"

#include <graze/solve.hpp>

#include <stdexcept>

namespace compare {

namespace {

template <int N, class V>
void append(std::vector<true_value>& values, const graze::vec<N, V>& x, root_memory& roots) {
    for (int i = 0; i < N; ++i) {
        values.emplace_back(x[i], roots);
    }
}

template <int N>
void append(std::vector<wide>& values, const graze::vec<N, exact>& x) {
    for (int i = 0; i < N; ++i) {
        values.push_back(to_wide(x[i]));
    }
}

bool is_zero(const exact_real& x) { return x.sign() == 0; }

// The truth must obey the conservation laws, or nothing could be measured against it.
template <int N>
void check_conservation(const problem<N>& pair, const graze::vec<N, exact_real>& after_a,
                        const graze::vec<N, exact_real>* after_b) {
    const auto real = [](const graze::vec<N, exact>& x) {
        return graze::make_vec<N>([&](int i) { return exact_real(x[i]); });
    };
    const exact_real a(after_b != nullptr ? pair.b.inverse_mass : exact(1)), b(pair.a.inverse_mass); // mass ratio
    const auto before_a = real(pair.a.shape.velocity);
    exact_real gained = a * (graze::squared_norm(after_a) - graze::squared_norm(before_a));
    bool kept = true;
    if (after_b != nullptr) {
        const auto before_b = real(pair.b.shape.velocity);
        gained = gained + b * (graze::squared_norm(*after_b) - graze::squared_norm(before_b));
        const auto momentum = a * (after_a - before_a) + b * (*after_b - before_b);
        for (int i = 0; i < N; ++i) {
            kept = kept && is_zero(momentum[i]);
        }
    }
    if (!kept || !is_zero(gained)) {
        throw std::logic_error("the exact solution does not conserve momentum and energy");
    }
}

template <int N>
void fill(truth& t, const problem<N>& pair, const graze::ball_solution<N, exact>& s, root_memory& roots) {
    t.what = s.what;
    t.discriminant.emplace(exact_real(s.discriminant), roots);
    if (!graze::is_collision(s.what)) {
        return;
    }
    t.time = true_value(s.time, roots);
    append(t.positions, s.position_a, roots);
    append(t.positions, s.position_b, roots);
    append(t.velocities, s.velocity_a, roots);
    append(t.velocities, s.velocity_b, roots);
    const exact& w_a = pair.a.inverse_mass;
    const exact& w_b = pair.b.inverse_mass;
    const bool finite = !w_a.is_zero() && !w_b.is_zero();
    t.before = {N,
                finite,
                finite,
                to_wide(exact(numerator(w_b) * denominator(w_a))),
                to_wide(exact(numerator(w_a) * denominator(w_b))),
                {}};
    append(t.before.velocities, pair.a.shape.velocity);
    append(t.before.velocities, pair.b.shape.velocity);
    if (finite) {
        check_conservation<N>(pair, s.velocity_a, &s.velocity_b);
    }
}

template <int N>
void fill(truth& t, const problem<N>& pair, const graze::wall_solution<N, exact>& s, root_memory& roots) {
    t.what = s.what;
    t.where = s.where;
    t.index = s.index;
    if (!graze::is_collision(s.what)) {
        return;
    }
    if (t.where != graze::feature::face && t.what != graze::encounter::overlap) {
        t.discriminant.emplace(exact_real(s.discriminant), roots);
    }
    t.time = true_value(s.time, roots);
    append(t.positions, s.position, roots);
    append(t.velocities, s.velocity, roots);
    t.before = {N, false, true, 1, 0, {}};
    append(t.before.velocities, pair.a.shape.velocity);
    check_conservation<N>(pair, s.velocity, nullptr);
}

} // namespace

template <int N>
truth truth_of(const problem<N>& pair) {
    truth t;
    t.kind = pair.kind;
    root_memory roots;
    switch (pair.kind) {
    case pair_kind::ball_ball:
        fill(t, pair,
             graze::solve_with_inverse_masses(pair.a.shape, pair.b.shape, pair.a.inverse_mass, pair.b.inverse_mass),
             roots);
        break;
    case pair_kind::ball_plane:
        fill(t, pair, graze::solve(pair.a.shape, pair.plane), roots);
        break;
    case pair_kind::ball_wall:
        fill(t, pair, graze::solve(pair.a.shape, pair.wall), roots);
        break;
    case pair_kind::ball_triangle:
        if constexpr (N == 3) {
            fill(t, pair, graze::solve(pair.a.shape, graze::triangle<exact>{pair.wall.corner, pair.wall.edge}), roots);
        }
        break;
    }
    set_conditions(t, pair);
    t.borders = border_distances_of(pair);
    return t;
}

template truth truth_of(const problem<2>&);
template truth truth_of(const problem<3>&);

} // namespace compare
