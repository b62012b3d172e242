// Pairs in one number type, and graze::solve for a list of them.
#pragma once

#include "reader.hpp"

#include <graze/solve.hpp>

#include <cstddef>
#include <exception>

namespace compare {

// A pair in T. valid: whether T can hold its numbers.
template <int N, class T>
struct input {
    pair_kind kind = pair_kind::ball_ball;
    bool valid = true;
    graze::ball<N, T> a{}, b{};
    T inverse_a{0}, inverse_b{0};
    graze::plane<N, T> plane{};
    graze::wall<N, T> wall{};
    graze::triangle<T> triangle{}; // in space
};

// Takes converted numbers, one after the other, from the numbers of a pair.
template <class T>
class number_row {
  public:
    explicit number_row(const pair_numbers& pair) : next_(pair.numbers.data()) {}
    [[nodiscard]] T number() { return convert<T>(*next_++); }
    template <int N>
    void take(graze::vec<N, T>& to) {
        for (int i = 0; i < N; ++i) {
            to[i] = number();
        }
    }
    template <int N>
    void take(graze::ball<N, T>& to) { // the mass stays 1: inverse masses are taken separately
        take(to.position);
        take(to.velocity);
        to.radius = number();
        to.mass = T(1);
    }
    void skip() { ++next_; }

  private:
    const exact_view* next_;
};

template <class T, int N>
[[nodiscard]] input<N, T> convert_pair(const pair_numbers& pair) {
    input<N, T> result;
    result.kind = pair.kind;
    try {
        number_row<T> row(pair);
        row.take(result.a);
        switch (pair.kind) {
        case pair_kind::ball_ball:
            result.inverse_a = row.number();
            row.take(result.b);
            result.inverse_b = row.number();
            break;
        case pair_kind::ball_plane:
            row.skip();
            row.take(result.plane.point);
            row.take(result.plane.normal);
            break;
        case pair_kind::ball_wall:
            row.skip();
            row.take(result.wall.corner);
            for (auto& edge : result.wall.edge) {
                row.take(edge);
            }
            break;
        case pair_kind::ball_triangle:
            row.skip();
            row.take(result.triangle.corner);
            row.take(result.triangle.edge[0]);
            row.take(result.triangle.edge[1]);
            break;
        }
    } catch (const std::exception&) {
        result.valid = false;
    }
    return result;
}

// Receives solutions. The functions are virtual so that the compiler cannot optimise a solution away.
template <int N, class T>
class solution_sink {
  public:
    virtual ~solution_sink() = default;
    virtual void take(const graze::ball_solution<N, T>& s) = 0;
    virtual void take(const graze::wall_solution<N, T>& s) = 0;
};

// A plane's equation is linear, so all variants are the same for it.
template <graze::variant V, graze::root_form F, int N, class T>
void solve_pair(const input<N, T>& pair, solution_sink<N, T>& sink) {
    switch (pair.kind) {
    case pair_kind::ball_ball:
        sink.take(graze::solve_with_inverse_masses<V, F>(pair.a, pair.b, pair.inverse_a, pair.inverse_b));
        break;
    case pair_kind::ball_plane:
        sink.take(graze::solve(pair.a, pair.plane));
        break;
    case pair_kind::ball_wall:
        sink.take(graze::solve<V, F>(pair.a, pair.wall));
        break;
    case pair_kind::ball_triangle:
        if constexpr (N == 3) {
            sink.take(graze::solve<V, F>(pair.a, pair.triangle));
        }
        break;
    }
}

// The outcome that the exception being handled stands for.
template <class T>
[[nodiscard]] outcome outcome_of_exception() {
    if constexpr (requires { typename reader<T>::undecided; }) {
        try {
            throw;
        } catch (const typename reader<T>::undecided&) {
            return outcome::undecided;
        } catch (const std::exception&) {
            return outcome::failed;
        }
    } else {
        return outcome::failed;
    }
}

// Solves count pairs from `first` on; returns the outcome of the last. Scoring and timing share this function.
template <graze::variant V, graze::root_form F, int N, class T>
outcome solve_pairs(const input<N, T>* first, std::size_t count, solution_sink<N, T>& sink) {
    outcome last = outcome::answered;
    for (std::size_t i = 0; i < count; ++i) {
        try {
            last = first[i].valid ? outcome::answered : outcome::failed;
            if (first[i].valid) {
                solve_pair<V, F>(first[i], sink);
            }
        } catch (const std::exception&) {
            last = outcome_of_exception<T>();
        }
    }
    return last;
}

} // namespace compare
