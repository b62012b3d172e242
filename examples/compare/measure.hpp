// One number type: graze::solve in it, in every variant, on every pair.
#pragma once

#include "solve_pairs.hpp"

#include <memory>
#include <stdexcept>
#include <vector>

namespace compare {

template <class R, int N>
void read_position(const graze::vec<N, R>& x, answer_sink& to) {
    for (int i = 0; i < N; ++i) {
        reader<R>::read(x[i], to.position());
    }
}
template <class R, int N>
void read_velocity(const graze::vec<N, R>& x, answer_sink& to) {
    for (int i = 0; i < N; ++i) {
        reader<R>::read(x[i], to.velocity());
    }
}

// Passes one solution on, number by number.
template <int N, class T>
class answering_sink final : public solution_sink<N, T> {
    using real = graze::root_type<T>;

  public:
    explicit answering_sink(answer_sink& to) : to_(to) {}
    void take(const graze::ball_solution<N, T>& s) override {
        const bool due = to_.decided(s.what);
        reader<T>::read(s.discriminant, to_.discriminant());
        if (due) {
            reader<real>::read(s.time, to_.time());
            read_position(s.position_a, to_);
            read_position(s.position_b, to_);
            read_velocity(s.velocity_a, to_);
            read_velocity(s.velocity_b, to_);
        }
    }
    void take(const graze::wall_solution<N, T>& s) override {
        if (to_.decided(s.what, s.where, s.index)) {
            if (to_.has_discriminant()) {
                reader<T>::read(s.discriminant, to_.discriminant());
            }
            reader<real>::read(s.time, to_.time());
            read_position(s.position, to_);
            read_velocity(s.velocity, to_);
        }
    }

  private:
    answer_sink& to_;
};

// Drops solutions, after having lazy numbers computed.
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
    explicit formula_solver(const pair_list& list) {
        inputs_.reserve(list.pairs.size());
        for (const pair_numbers& pair : list.pairs) {
            inputs_.push_back(convert_pair<T, N>(pair));
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

    outcome answer_to(std::size_t how, std::size_t pair, answer_sink& to) override {
        answering_sink<N, T> sink(to);
        return solve_[how](&inputs_[pair], 1, sink);
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

// Whether this program measures pairs in space. graze-compare-plane, which ./graze compare builds for pairs in the
// plane, does not: half of what a type takes to compile is for space.
#ifdef COMPARE_IN_PLANE
constexpr bool measures_in_space = false;
#else
constexpr bool measures_in_space = true;
#endif

template <template <int, class> class Solver, class T>
[[nodiscard]] std::unique_ptr<solver> prepare_with(const pair_list& list) {
    if (list.dimension == 2) {
        return std::make_unique<Solver<2, T>>(list);
    }
    if constexpr (measures_in_space) {
        return std::make_unique<Solver<3, T>>(list);
    } else {
        throw std::invalid_argument(
            "these pairs are in space: graze-compare measures them, graze-compare-plane does not");
    }
}
template <class T>
[[nodiscard]] std::unique_ptr<solver> prepare(const pair_list& list) {
    return prepare_with<formula_solver, T>(list);
}

// What T's traits say; the caller fills in the rest.
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
    return {information, &prepare<T>, traits::is_exact};
}

} // namespace compare
