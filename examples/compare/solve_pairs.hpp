// Pairs in one number type, and graze::solve on a row of them.
#pragma once

#include "convert.hpp"
#include "reader.hpp"
#include "score.hpp"

#include <graze/solve.hpp>

#include <cstddef>
#include <exception>

namespace compare {

// A pair in T. valid: T can hold its numbers.
template <int N, class T>
struct input {
    pair_kind kind = pair_kind::ball_ball;
    bool valid = true;
    graze::ball<N, T> a{}, b{};
    T inverse_a{0}, inverse_b{0};
    graze::plane<N, T> plane{};
    graze::wall<N, T> wall{};
};

template <class T, int N>
[[nodiscard]] input<N, T> convert_pair(const problem<N>& pair) {
    input<N, T> result;
    result.kind = pair.kind;
    try {
        result.a = convert<T>(pair.a);
        switch (pair.kind) {
        case pair_kind::ball_ball:
            result.b = convert<T>(pair.b);
            result.inverse_a = convert<T>(pair.a.inverse_mass);
            result.inverse_b = convert<T>(pair.b.inverse_mass);
            break;
        case pair_kind::ball_plane:
            result.plane = convert<T>(pair.plane);
            break;
        case pair_kind::ball_wall:
            result.wall = convert<T>(pair.wall);
            break;
        }
    } catch (const std::exception&) {
        result.valid = false;
    }
    return result;
}

// Where solutions go. The compiler does not see to whom, so that none is optimised away.
template <int N, class T>
class solution_sink {
  public:
    virtual ~solution_sink() = default;
    virtual void take(const graze::ball_solution<N, T>& s) = 0;
    virtual void take(const graze::wall_solution<N, T>& s) = 0;
};

// A plane's equation is linear: the variants are one there.
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
    }
}

// What an exception that a type throws stands for.
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

// Solves count pairs from first on; returns how the last one ended. One function for scoring and for timing.
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
