// Measures one number type: the formulas of graze::solve run in it, in every variant, on every pair.
#pragma once

#include "measurable.hpp"
#include "reader.hpp"
#include "solve_pairs.hpp"

#include <memory>
#include <utility>

namespace compare {

template <class R, int N>
void read_vector(std::vector<computed>& values, const graze::vec<N, R>& x, const std::vector<true_value>& right) {
    for (int i = 0; i < N; ++i) {
        values.push_back(reader<R>::read(x[i], right[values.size()]));
    }
}

// The values that the truth has too.
template <int N, class T>
[[nodiscard]] answer read_answer(const graze::ball_solution<N, T>& s, const truth& right) {
    answer given;
    given.what = s.what;
    given.discriminant = reader<T>::read(s.discriminant, *right.discriminant);
    if (same_decision(given, right) && graze::is_collision(right.what)) {
        given.time = reader<graze::root_type<T>>::read(s.time, right.time);
        read_vector(given.positions, s.position_a, right.positions);
        read_vector(given.positions, s.position_b, right.positions);
        read_vector(given.velocities, s.velocity_a, right.velocities);
        read_vector(given.velocities, s.velocity_b, right.velocities);
    }
    return given;
}

template <int N, class T>
[[nodiscard]] answer read_answer(const graze::wall_solution<N, T>& s, const truth& right) {
    answer given;
    given.what = s.what;
    given.where = s.where;
    given.index = s.index;
    if (same_decision(given, right) && graze::is_collision(right.what)) {
        if (right.discriminant) {
            given.discriminant = reader<T>::read(s.discriminant, *right.discriminant);
        }
        given.time = reader<graze::root_type<T>>::read(s.time, right.time);
        read_vector(given.positions, s.position, right.positions);
        read_vector(given.velocities, s.velocity, right.velocities);
    }
    return given;
}

// Reads one solution, to be held against the truth.
template <int N, class T>
class answering_sink final : public solution_sink<N, T> {
  public:
    explicit answering_sink(const truth& right) : right_(right) {}
    void take(const graze::ball_solution<N, T>& s) override { given = read_answer(s, right_); }
    void take(const graze::wall_solution<N, T>& s) override { given = read_answer(s, right_); }
    answer given;

  private:
    const truth& right_;
};

// Forgets solutions, but lets lazy numbers be computed first.
template <int N, class T>
class forgetting_sink final : public solution_sink<N, T> {
    using real = graze::root_type<T>;

  public:
    void take(const graze::ball_solution<N, T>& s) override {
        if constexpr (is_lazy) {
            if (graze::is_collision(s.what)) {
                reader<real>::settle(s.time);
                settle(s.position_a);
                settle(s.position_b);
                settle(s.velocity_a);
                settle(s.velocity_b);
            }
        }
    }
    void take(const graze::wall_solution<N, T>& s) override {
        if constexpr (is_lazy) {
            if (graze::is_collision(s.what)) {
                reader<real>::settle(s.time);
                settle(s.position);
                settle(s.velocity);
            }
        }
    }

  private:
    static constexpr bool is_lazy = requires(const real& x) { reader<real>::settle(x); };
    static void settle(const graze::vec<N, real>& x) {
        for (int i = 0; i < N; ++i) {
            reader<real>::settle(x[i]);
        }
    }
};

template <int N, class T>
class formula_solver final : public solver {
  public:
    explicit formula_solver(const std::vector<problem<N>>& problems) {
        inputs_.reserve(problems.size());
        for (const problem<N>& pair : problems) {
            inputs_.push_back(convert_pair<T>(pair));
        }
        add<graze::variant::textbook>();
        add<graze::variant::halved>();
        if constexpr (graze::has_variant<graze::variant::kahan, T>) {
            add<graze::variant::kahan>();
        }
        add<graze::variant::lagrange>();
    }

    [[nodiscard]] std::vector<method> methods() const override { return methods_; }

    void run(std::size_t how, std::size_t count) override { solve_[how](inputs_.data(), count, *forgetting_); }

    [[nodiscard]] answer answer_to(std::size_t how, std::size_t pair, const truth& right) override {
        answering_sink<N, T> sink(right);
        const outcome ended = solve_[how](&inputs_[pair], 1, sink);
        sink.given.how = ended;
        return std::move(sink.given);
    }

  private:
    using solve_function = outcome (*)(const input<N, T>*, std::size_t, solution_sink<N, T>&);

    template <graze::variant V>
    void add() {
        methods_.push_back({V, graze::root_form::printed});
        solve_.push_back(&solve_pairs<V, graze::root_form::printed, N, T>);
        methods_.push_back({V, graze::root_form::stable});
        solve_.push_back(&solve_pairs<V, graze::root_form::stable, N, T>);
    }

    std::vector<input<N, T>> inputs_;
    std::vector<method> methods_;
    std::vector<solve_function> solve_;
    std::unique_ptr<solution_sink<N, T>> forgetting_ = std::make_unique<forgetting_sink<N, T>>();
};

template <class T>
[[nodiscard]] std::unique_ptr<solver> prepare(const group& pairs) {
    if (const auto* plane = std::get_if<group_pairs<2>>(&pairs.pairs)) {
        return std::make_unique<formula_solver<2, T>>(plane->problems);
    }
    return std::make_unique<formula_solver<3, T>>(std::get<group_pairs<3>>(pairs.pairs).problems);
}

// What the traits say of T, ready to be completed.
template <class T>
[[nodiscard]] measurable measurable_type(const char* library, bool uses_heap = false, const char* note = "") {
    using traits = graze::number_traits<T>;
    type_information information;
    information.name = traits::name;
    information.library = library;
    information.is_exact = traits::is_exact;
    information.digits = traits::digits;
    information.has_sqrt = graze::has_sqrt<T>;
    information.has_fma = graze::has_fma<T>;
    information.bytes = sizeof(T);
    information.real_bytes = sizeof(graze::root_type<T>);
    information.uses_heap = uses_heap;
    information.note = note;
    return {information, &prepare<T>};
}

} // namespace compare
