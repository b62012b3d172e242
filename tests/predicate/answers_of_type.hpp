// The definitions for answers.hpp.
#pragma once

#include "answers.hpp"

#include <graze/overlaps.hpp>
#include <graze/time_of_impact.hpp>

namespace answers {

// One observer for all, so that shared code is compiled once.
struct note {
    graze::stage* told;
    void operator()(graze::stage s) const { *told = s; }
};

template <int N, class T, class Shape>
graze::encounter encounter_of(const graze::ball<N, T>& a, const Shape& b, graze::stage& decided_by) {
    return graze::classify(a, b, note{&decided_by});
}
template <int N, class T, class Shape>
bool overlap_of(const graze::ball<N, T>& a, const Shape& b, graze::stage& decided_by) {
    return graze::overlaps(a, b, note{&decided_by});
}
template <int N, class T, class Shape>
std::optional<graze::impact_time<N, T>> time_of(const graze::ball<N, T>& a, const Shape& b) {
    auto decided_by = graze::stage::filter;
    return graze::time_of_impact(a, b, note{&decided_by});
}

inline int sign_of(std::partial_ordering o) { return o < 0 ? -1 : o > 0 ? 1 : o == 0 ? 0 : 2; }

template <int N, class T>
int order_of(const graze::impact_time<N, T>& x, const graze::impact_time<N, T>& y) {
    const int sign = sign_of(x <=> y);
    return (x == y) == (sign == 0) ? sign : 3;
}
template <int N, class T>
int order_of(const graze::impact_time<N, T>& x, const T& y) {
    const int sign = sign_of(x <=> y);
    return (x == y) == (sign == 0) ? sign : 3;
}

} // namespace answers
