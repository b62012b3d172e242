// What the parts of event_check have in common.
#pragma once

#include "clearance.hpp"
#include "event_check.hpp"

namespace compare::run {

[[noreturn]] inline void leave_open(const graze::meeting& who, const char* what, const certified& t) {
    graze::undecided open(what, near_double(t));
    open.between(who);
    throw open;
}

[[noreturn]] inline void refute(const graze::meeting& who, const char* what, const certified& t) {
    throw refuted_event(to_string(who), what, near_double(t));
}

template <int N>
[[nodiscard]] const vector_of<N>& normal_of(const graze::plane<N, certified>& p) {
    return p.normal;
}
template <int N>
[[nodiscard]] vector_of<N> normal_of(const graze::wall<N, certified>& w) {
    if constexpr (N == 2) {
        return {{-w.edge[0][1], w.edge[0][0]}};
    } else {
        return graze::cross(w.edge[0], w.edge[1]);
    }
}
template <int N>
[[nodiscard]] const vector_of<N>& point_of(const graze::plane<N, certified>& p) {
    return p.point;
}
template <int N>
[[nodiscard]] const vector_of<N>& point_of(const graze::wall<N, certified>& w) {
    return w.corner;
}

} // namespace compare::run
