// All answers of the predicates about a pair. They are compiled once for each number type: for doubles in answers.cpp,
// for another type where answers_of_type.hpp is included.
#pragma once

#include "../oracle/encounter.hpp"

#include <graze/time/impact_time.hpp>

#include <cmath>
#include <compare>
#include <optional>

namespace answers {

template <int N, class T, class Shape>
graze::encounter encounter_of(const graze::ball<N, T>& a, const Shape& b, graze::stage& decided_by);
template <int N, class T, class Shape>
bool overlap_of(const graze::ball<N, T>& a, const Shape& b, graze::stage& decided_by);
template <int N, class T, class Shape>
std::optional<graze::impact_time<N, T>> time_of(const graze::ball<N, T>& a, const Shape& b);

// x <=> y, with 2 for unordered.
template <int N, class T>
int order_of(const graze::impact_time<N, T>& x, const graze::impact_time<N, T>& y);
template <int N, class T>
int order_of(const graze::impact_time<N, T>& x, const T& y);

template <int N, class T>
struct answer {
    graze::encounter what;
    bool overlaps;
    std::optional<graze::impact_time<N, T>> time;
    graze::stage decided_by; // `what`

    // The stage may differ: it is no part of the answer.
    friend bool operator==(const answer& x, const answer& y) {
        return x.what == y.what && x.overlaps == y.overlaps && x.time.has_value() == y.time.has_value() &&
               (!x.time || order_of(*x.time, *y.time) == 0);
    }
};

template <int N, class T, class Shape>
answer<N, T> of(const graze::ball<N, T>& a, const Shape& b) {
    auto decided_by = graze::stage::filter, other = graze::stage::filter;
    const auto what = encounter_of(a, b, decided_by);
    return {what, overlap_of(a, b, other), time_of(a, b), decided_by};
}

// Whether the oracle gives the same answers; the time is compared at the number nearest to it and at others.
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
        if (m <= 1e9) { // m fits T
            const auto time = static_cast<T>(m);
            if (order_of(*x.time, time) != oracle::compare(*truth.time, mpq_class(oracle::input(time)))) {
                return false;
            }
        }
    }
    return true;
}

} // namespace answers
