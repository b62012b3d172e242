// Checks that nothing else was met on the way.
#include "check_words.hpp"
#include "event_check.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace compare::run {

template <int N>
void event_check<N>::check_way(int a, const certified& t, const graze::scene_pair* event, const image& periods) {
    const mover& x = movers_[static_cast<std::size_t>(a)];
    if (x.immovable) {
        return;
    }
    for (int b = 0; b < static_cast<int>(movers_.size()); ++b) {
        if (b != a) {
            const bool meet = event != nullptr && event->with == graze::partner::ball &&
                              ((event->a == a && event->b == b) || (event->a == b && event->b == a));
            check_pair(a, b, &t, meet ? &periods : nullptr);
        }
    }
    for (std::size_t b = 0; b < standing(); ++b) {
        const bool meet = event != nullptr && *event == named(a, b);
        check_standing(a, b, &t, meet ? &periods : nullptr);
    }
}

template <int N>
void event_check<N>::check_pair(int a, int b, const certified* t, const image* met) const {
    const mover &x = movers_[static_cast<std::size_t>(a)], &y = movers_[static_cast<std::size_t>(b)];
    if ((x.at_rest && y.at_rest) || (x.immovable && y.immovable)) {
        return;
    }
    const graze::scene_pair who{graze::partner::ball, std::min(a, b), std::max(a, b)};
    if (is_point(x) && is_point(y) && (met != nullptr || (x.last == who && y.last == who))) {
        return; // two points are at the same place at one instant at most
    }
    const certified from = larger(x.now.since, y.now.since);
    const bool known = space_.for_each(x.now, y.now, from, t, [&](const image& periods) {
        const verdict v = sharpened([&](bool coarse) {
            const flight &f = coarse ? x.coarse : x.now, g = space_.image_of(coarse ? y.coarse : y.now, periods);
            return verdict_of(f, g, larger(f.since, g.since), t, met != nullptr && *met == periods);
        });
        judge(v, who, from);
    });
    if (!known) {
        leave_open(who, "which images are met", from);
    }
}

template <int N>
void event_check<N>::check_standing(int a, std::size_t b, const certified* t, const image* met) const {
    const mover& x = movers_[static_cast<std::size_t>(a)];
    if (x.at_rest || x.immovable) {
        return;
    }
    if (is_point(x)) {
        check_point(a, b, t, met != nullptr);
        return;
    }
    const auto check_image = [&](const image& periods) {
        const verdict v = sharpened([&](bool coarse) {
            const flight& f = coarse ? x.coarse : x.now;
            const bool meet = met != nullptr && *met == periods;
            return with_standing(
                b, [&](const auto& s) { return verdict_of(f, s, f.since, t, meet); }, periods);
        });
        if (v == verdict::clear || !may_touch_inner_edge(x, b, periods, t)) {
            judge(v, named(a, b), x.now.since);
        }
    };
    if (b < scene_.planes.size()) { // a plane is its own image: no normal has a component along a period
        check_image({});
    } else if (!with_standing(b,
                              [&](const auto& s) { return space_.for_each(x.now, s, x.now.since, t, check_image); })) {
        leave_open(named(a, b), "which images are met", x.now.since);
    }
}

// Nothing is met at an inner edge of a triangle or at its ends.
template <int N>
bool event_check<N>::may_touch_inner_edge(const mover& x, std::size_t b, const image& periods,
                                          const certified* t) const {
    if constexpr (N == 3) {
        if (b >= first_triangle() && !scene_.inner_edges.empty()) {
            const graze::triangle<certified> s = space_.image_of(scene_.triangles[b - first_triangle()], periods);
            const auto clearance_then = [&](const certified& then) { return clearance_at<3>(x.now, s, then); };
            const vector_of<3> at = place_at<3>(x.now, first_touch(clearance_then, x.now.since, t));
            const certified nearest = graze::squared_norm(at - nearest_point<3>(s, at));
            const std::array<std::pair<vector_of<3>, vector_of<3>>, 3> edges = {
                {{s.corner, s.edge[1]}, {s.corner + s.edge[0], s.edge[1] - s.edge[0]}, {s.corner, s.edge[0]}}};
            for (std::size_t k = 0; k < edges.size(); ++k) {
                const vector_of<3> on_edge = nearest_on_segment<3>(edges[k].first, edges[k].second, at);
                if ((scene_.inner_edges[b - first_triangle()] >> k & 1U) != 0 &&
                    (graze::squared_norm(at - on_edge) - nearest).certain_sign() != 1) {
                    return true;
                }
            }
        }
    }
    return false;
}

template <int N>
void event_check<N>::check_overtaken(int a, const certified& t, const graze::scene_pair& who) const {
    for (int b = 0; b < static_cast<int>(movers_.size()); ++b) {
        const mover& y = movers_[static_cast<std::size_t>(b)];
        if (b == a || !y.before || (who.with == graze::partner::ball && (b == who.a || b == who.b)) ||
            (t - y.now.since).certain_sign().value_or(-1) >= 0) {
            continue;
        }
        const graze::scene_pair both{graze::partner::ball, std::min(a, b), std::max(a, b)};
        if ((t - y.before->since).certain_sign().value_or(-1) < 0) {
            leave_open(both, "the order of their events", t);
        }
        const flight& f = movers_[static_cast<std::size_t>(a)].now;
        if (!space_.for_each(f, *y.before, t, &y.now.since, [&](const image& periods) {
                judge(verdict_of(f, space_.image_of(*y.before, periods), t, &y.now.since, false), both, t);
            })) {
            leave_open(both, "which images are met", t);
        }
    }
}

template class event_check<2>;
template class event_check<3>;

} // namespace compare::run
