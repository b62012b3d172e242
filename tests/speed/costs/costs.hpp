// What graze costs beside what one would take instead: the pairs, and a unit a contestant that answers about them.
#pragma once

#include <graze/formula/encounter.hpp>
#include <graze/shape/ball.hpp>
#include <graze/shape/wall.hpp>

#include <functional>
#include <vector>

namespace costs {

template <class T, class S>
struct pairs_of {
    std::vector<graze::ball<3, T>> a;
    std::vector<S> b;
};
template <class T = double>
using balls = pairs_of<T, graze::ball<3, T>>;
template <class T = double>
using walls = pairs_of<T, graze::wall<3, T>>;

struct pairs {
    balls<> generic, meeting, grazing;
    walls<> aimed; // each ball hits its wall
};

// Each answers about all pairs of its kind; those without an answer are empty. The numbers are a sum of the answers,
// which keeps the compiler from leaving them out.
struct contestant {
    std::function<double()> decide, decide_grazing, collide, collide_wall;
    std::function<std::vector<graze::encounter>()> encounters; // of the grazing pairs
};

[[nodiscard]] contestant in_doubles(const pairs& all);
[[nodiscard]] contestant in_graze(const pairs& all);
[[nodiscard]] contestant in_digits(const pairs& all);
[[nodiscard]] contestant in_rationals(const pairs& all);

// f of each pair, added up.
template <class T, class S, class F>
[[nodiscard]] double sum_of(const pairs_of<T, S>& p, F f) {
    double sum = 0;
    for (std::size_t i = 0; i < p.a.size(); ++i) {
        sum += f(p.a[i], p.b[i]);
    }
    return sum;
}

template <class T, class S, class F>
[[nodiscard]] std::vector<graze::encounter> encounters_of(const pairs_of<T, S>& p, F f) {
    std::vector<graze::encounter> r;
    for (std::size_t i = 0; i < p.a.size(); ++i) {
        r.push_back(f(p.a[i], p.b[i]));
    }
    return r;
}

} // namespace costs
