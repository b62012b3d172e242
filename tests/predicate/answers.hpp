// All that the predicates say of a pair.
#pragma once

#include "../oracle/encounter.hpp"

#include <graze/predicate/overlaps.hpp>
#include <graze/predicate/time_of_impact.hpp>

#include <optional>

namespace answers {

template <int N, class T>
struct answer {
    graze::encounter what;
    bool overlaps;
    std::optional<graze::impact_time<N, T>> time;
    graze::stage decided_by; // what

    // The stage may differ: it is not part of the answer.
    friend bool operator==(const answer& x, const answer& y) {
        return x.what == y.what && x.overlaps == y.overlaps && x.time == y.time;
    }
};

template <int N, class T, class Shape>
answer<N, T> of(const graze::ball<N, T>& a, const Shape& b) {
    auto decided_by = graze::stage::filter;
    const auto what = graze::classify(a, b, [&](graze::stage s) { decided_by = s; });
    return {what, graze::overlaps(a, b), graze::time_of_impact(a, b), decided_by};
}

// Whether the oracle says the same, the time at its nearest double and both neighbours apart.
template <int N, class T, class Shape>
bool is_right(const answer<N, T>& x, const graze::ball<N, T>& a, const Shape& b) {
    const oracle::answer truth = oracle::meet(a, b);
    if (static_cast<int>(x.what) != static_cast<int>(truth.what) || x.overlaps != truth.overlaps ||
        x.time.has_value() != truth.time.has_value()) {
        return false;
    }
    if (!truth.time) {
        return true;
    }
    const double nearest = oracle::nearest_double(*truth.time);
    for (const double m : {nearest, nearest / 2, nearest + 1, std::nextafter(nearest, 0.0)}) {
        const bool fits = m >= -1e9 && m <= 1e9;
        if (!fits) {
            continue;
        }
        const T time = static_cast<T>(m); // some time of type T near it
        const auto order = *x.time <=> time;
        const int expected = oracle::compare(*truth.time, mpq_class(oracle::input(time)));
        if (order != (expected <=> 0) || (*x.time == time) != (expected == 0)) {
            return false;
        }
    }
    return true;
}

} // namespace answers
