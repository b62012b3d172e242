// Number types and formulas of the user's as rows beside all others, for graze_add_compare_program.
#pragma once

#include "measure.hpp"

#include <graze/precision/subject.hpp>

#include <concepts>
#include <string>
#include <vector>

namespace compare {

// Passes the reading's exact value on.
void tell(const graze::precision::reading& x, const request& asked);

// Bases for the converter and the reader of a type with a graze::precision::number_access. The type gets the double
// nearest to the exact number.
template <class T>
struct converter_by_access {
    [[nodiscard]] static T from(const exact_view& x) { return graze::precision::number_access<T>::from(x.nearest()); }
};
template <class T>
struct reader_by_access {
    static void read(const T& x, const request& asked) { tell(graze::precision::number_access<T>::read(x), asked); }
};

template <class X>
inline constexpr bool is_solution = false;
template <int N, class T>
inline constexpr bool is_solution<graze::ball_solution<N, T>> = true;
template <int N, class T>
inline constexpr bool is_solution<graze::wall_solution<N, T>> = true;

// Whether F takes an A and a B, and so returns a whole solution.
template <class F, class A, class B>
concept solves = requires(const A& a, const B& b) {
    F{}(a, b);
};

// Whether F computes the discriminant of two balls from their relative motion.
template <class F, int N, class T>
concept discriminant_of_balls = requires(const graze::ball<N, T>& a) {
    { F{}(graze::relative_motion_of(a, a)) } -> std::convertible_to<T>;
};

// Solves by F the pairs that F takes, and all others by graze::solve.
template <class F, int N, class T>
void solve_pair_by(const input<N, T>& pair, solution_sink<N, T>& sink) {
    const auto by_formula = [&](const auto& other) {
        if constexpr (solves<F, graze::ball<N, T>, std::remove_cvref_t<decltype(other)>>) {
            auto s = F{}(pair.a, other);
            static_assert(is_solution<decltype(s)>,
                          "a formula of graze_add_compare_program returns a graze::ball_solution or a "
                          "graze::wall_solution, or is a discriminant of a relative motion");
            sink.take(s);
            return true;
        } else {
            return false;
        }
    };
    bool done = false;
    switch (pair.kind) {
    case pair_kind::ball_ball:
        if constexpr (discriminant_of_balls<F, N, T>) {
            sink.take(graze::detail::solve_balls<graze::root_form::stable>(
                pair.a, pair.b, pair.inverse_a, pair.inverse_b, [](const auto& m, const auto&) { return T(F{}(m)); }));
            done = true;
        } else {
            done = by_formula(pair.b);
        }
        break;
    case pair_kind::ball_plane:
        done = by_formula(pair.plane);
        break;
    case pair_kind::ball_wall:
        done = by_formula(pair.wall);
        break;
    case pair_kind::ball_triangle:
        if constexpr (N == 3) {
            done = by_formula(pair.triangle);
        }
        break;
    }
    if (!done) {
        solve_pair<graze::variant::lagrange, graze::root_form::stable>(pair, sink);
    }
}

template <class F, int N, class T>
class own_solver final : public solver {
  public:
    explicit own_solver(const pair_list& list) {
        for (const pair_numbers& pair : list.pairs) {
            inputs_.push_back(convert_pair<T, N>(pair));
            if (pair.kind == pair_kind::ball_ball) {
                set_mass(inputs_.back(), inputs_.back().a.mass, pair.numbers[2 * N + 1]);
                set_mass(inputs_.back(), inputs_.back().b.mass, pair.numbers[4 * N + 3]);
            }
        }
    }
    [[nodiscard]] std::vector<method> methods() const override {
        return {{graze::variant::lagrange, graze::root_form::stable}};
    }
    void run(std::size_t, std::size_t count) override {
        for (std::size_t i = 0; i < count; ++i) {
            static_cast<void>(solve(i, *forgetting_));
        }
    }
    outcome answer_to(std::size_t, std::size_t pair, answer_sink& to) override {
        answering_sink<N, T> sink(to);
        return solve(pair, sink);
    }

  private:
    outcome solve(std::size_t i, solution_sink<N, T>& sink) const {
        if (!inputs_[i].valid) {
            return outcome::failed;
        }
        try {
            solve_pair_by<F>(inputs_[i], sink);
        } catch (const std::exception&) {
            return outcome_of_exception<T>();
        }
        return outcome::answered;
    }
    static void set_mass(input<N, T>& pair, T& mass, const exact_view& inverse) {
        try {
            using access = graze::precision::number_access<T>;
            mass = inverse.is_zero() ? access::from(std::numeric_limits<double>::infinity())
                                     : access::from(value_of<double>(inverse.inverse_rounded(format_of<double>())));
        } catch (const std::exception&) { // T cannot hold it; graze::solve takes the inverse
            pair.valid = pair.valid && !solves<F, graze::ball<N, T>, graze::ball<N, T>>;
        }
    }

    std::vector<input<N, T>> inputs_;
    std::unique_ptr<solution_sink<N, T>> forgetting_ = std::make_unique<forgetting_sink<N, T>>();
};

// All forms of graze::solve in T.
template <class T>
[[nodiscard]] measurable own_type() {
    static_assert(graze::has_sqrt<T>, "a number type of graze_add_compare_program needs a square root in its traits");
    return measurable_type<T>("own");
}

// The formula F in T, listed as the single form lagrange/stable. Its name is F::name if F has one.
template <class F, class T>
[[nodiscard]] measurable own_formula(std::string name) {
    if constexpr (requires { std::string(F::name); }) {
        name = F::name;
    }
    measurable m = measurable_type<T>("own", false, "a formula of the user's");
    m.information.name = name + " in " + m.information.name;
    m.prepare = [](const pair_list& list) -> std::unique_ptr<solver> {
        if (list.dimension == 2) {
            return std::make_unique<own_solver<F, 2, T>>(list);
        }
        return std::make_unique<own_solver<F, 3, T>>(list);
    };
    return m;
}

} // namespace compare
