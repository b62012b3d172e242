// What graze costs beside its alternatives: the pairs, and a unit for each contestant that answers about them.
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
    walls<> aimed; // every ball hits its wall
};

// Each function answers about all pairs of its kind; it is empty if the contestant cannot answer. The numbers are sums
// of the answers, so that the compiler cannot leave them out.
struct contestant {
    std::function<double()> decide, decide_grazing, collide, collide_wall;
    std::function<std::vector<graze::encounter>()> encounters; // for the grazing pairs
};

[[nodiscard]] contestant in_doubles(const pairs& all);
[[nodiscard]] contestant in_graze(const pairs& all);
[[nodiscard]] contestant in_digits(const pairs& all);
[[nodiscard]] contestant in_rationals(const pairs& all);

// The sum of f over all pairs.
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
