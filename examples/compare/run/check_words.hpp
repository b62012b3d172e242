// What the parts of event_check share.
#pragma once

#include "clearance.hpp"
#include "event_check.hpp"

#include <algorithm>
#include <optional>

namespace compare::run {

[[noreturn]] inline void leave_open(const graze::scene_pair& who, const char* what, const certified& t) {
    graze::undecided open(what, near_double(t));
    open.between(who);
    throw open;
}

[[noreturn]] inline void refute(const graze::scene_pair& who, const char* what, const certified& t) {
    throw refuted_event(to_string(who), what, near_double(t));
}

template <int N>
[[nodiscard]] const vector_of<N>& normal_of(const graze::plane<N, certified>& p) {
    return p.normal;
}
template <int N, flat_shape W>
[[nodiscard]] vector_of<N> normal_of(const W& w) {
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
template <int N, flat_shape W>
[[nodiscard]] const vector_of<N>& point_of(const W& w) {
    return w.corner;
}

template <int N>
[[nodiscard]] bool is_zero(const vector_of<N>& x) {
    return std::all_of(x.component, x.component + N, [](const certified& c) { return c.certain_sign() == 0; });
}

// Whether they may be equal.
[[nodiscard]] inline bool agree(const certified& x, const certified& y) {
    return (x - y).certain_sign().value_or(0) == 0;
}

template <int N>
[[nodiscard]] bool agree(const vector_of<N>& x, const vector_of<N>& y) {
    for (int i = 0; i < N; ++i) {
        if (!agree(x[i], y[i])) {
            return false;
        }
    }
    return true;
}

// Whether x may be along n.
template <int N>
[[nodiscard]] bool may_be_along(const vector_of<N>& x, const vector_of<N>& n) {
    const auto across = graze::cross(x, n);
    if constexpr (N == 2) {
        return agree(across, certified(0));
    } else {
        return agree<N>(across, vector_of<N>{});
    }
}

// For x in the plane of a wall or a triangle: 1 if x is inside it, 0 on its border, -1 outside; empty if that is open.
template <int N>
[[nodiscard]] std::optional<int> place_in(const graze::plane<N, certified>&, const vector_of<N>&) {
    return 1;
}
template <int N, flat_shape W>
[[nodiscard]] std::optional<int> place_in(const W& w, const vector_of<N>& x) {
    std::optional<int> least = 1;
    certified left = 1; // in a triangle: 1 less the shares so far
    for (std::size_t i = 0; i < w.edge.size(); ++i) {
        const vector_of<N> from = x - w.corner, &e = w.edge[i];
        vector_of<N> across = e; // in space: in the wall's plane, normal to the other edge
        if constexpr (N == 3) {
            across = graze::cross(w.edge[1 - i], normal_of<N>(w));
        }
        const certified share = graze::dot(from, across) / graze::dot(e, across);
        left = is_triangle<W> ? left - share : certified(1) - share;
        const auto low = share.certain_sign(), high = left.certain_sign();
        if (low == -1 || high == -1) {
            return -1;
        }
        least = least && low && high ? std::optional(std::min({*least, *low, *high})) : std::nullopt;
    }
    return least;
}

// Asks with few bits first, and with all of them only if the answer is open.
template <class F>
[[nodiscard]] verdict sharpened(F of) {
    const verdict coarse = of(true);
    return coarse == verdict::open ? of(false) : coarse;
}

template <class A, class B>
[[nodiscard]] verdict verdict_of(const A& a, const B& b, const certified& from, const certified* to, bool meet) {
    const auto of = [&](const certified& t) { return clearance_at(a, b, t); };
    return to != nullptr ? clear_between(of, from, *to, meet) : clear_after(of, from);
}

inline void judge(verdict v, const graze::scene_pair& who, const certified& from) {
    if (v == verdict::crossed) {
        refute(who, "met before that, which was not reported", from);
    }
    if (v == verdict::open) {
        leave_open(who, "whether they stay apart", from);
    }
}

} // namespace compare::run
