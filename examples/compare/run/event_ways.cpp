// That nothing else was met on the way.
#include "check_words.hpp"
#include "event_check.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace compare::run {

namespace {

// Where the answer is open in few bits it is asked for in all.
template <class F>
verdict sharpened(F of) {
    const verdict coarse = of(true);
    return coarse == verdict::open ? of(false) : coarse;
}

template <class A, class B>
verdict verdict_of(const A& a, const B& b, const certified& from, const certified* to, bool meet) {
    const auto of = [&](const certified& t) { return clearance_at(a, b, t); };
    return to != nullptr ? clear_between(of, from, *to, meet) : clear_after(of, from);
}

void judge(verdict v, const graze::meeting& who, const certified& from) {
    if (v == verdict::crossed) {
        refute(who, "met before that, and it was not told", from);
    }
    if (v == verdict::open) {
        leave_open(who, "whether they stay apart", from);
    }
}

// Of x, which is in the plane of the wall: 1 inside the wall, 0 on its border, -1 beside it; empty where that is open.
template <int N>
std::optional<int> place_in(const graze::plane<N, certified>&, const vector_of<N>&) {
    return 1;
}
template <int N>
std::optional<int> place_in(const graze::wall<N, certified>& w, const vector_of<N>& x) {
    std::optional<int> least = 1;
    for (std::size_t i = 0; i < w.edge.size(); ++i) {
        const vector_of<N> from = x - w.corner, &e = w.edge[i];
        vector_of<N> across = e; // within the wall, across its other edge
        if constexpr (N == 3) {
            across = graze::cross(w.edge[1 - i], normal_of<N>(w));
        }
        const certified share = graze::dot(from, across) / graze::dot(e, across);
        const auto low = share.certain_sign(), high = (certified(1) - share).certain_sign();
        if (low == -1 || high == -1) {
            return -1;
        }
        least = least && low && high ? std::optional(std::min({*least, *low, *high})) : std::nullopt;
    }
    return least;
}

} // namespace

template <int N>
void event_check<N>::check_way(int a, const certified& t, const graze::meeting* event) {
    const mover& x = movers_[static_cast<std::size_t>(a)];
    if (x.immovable) {
        return;
    }
    for (int b = 0; b < static_cast<int>(movers_.size()); ++b) {
        if (b != a) {
            const bool meet = event != nullptr && event->with == graze::partner::ball &&
                              ((event->a == a && event->b == b) || (event->a == b && event->b == a));
            check_pair(a, b, &t, meet);
        }
    }
    for (std::size_t b = 0; b < standing(); ++b) {
        const bool meet = event != nullptr && *event == named(a, b);
        check_standing(a, b, &t, meet);
    }
}

template <int N>
void event_check<N>::check_pair(int a, int b, const certified* t, bool meet) const {
    const mover &x = movers_[static_cast<std::size_t>(a)], &y = movers_[static_cast<std::size_t>(b)];
    if ((x.at_rest && y.at_rest) || (x.immovable && y.immovable)) {
        return;
    }
    const graze::meeting who{graze::partner::ball, std::min(a, b), std::max(a, b)};
    if (is_point(x) && is_point(y) && (meet || (x.last == who && y.last == who))) {
        return; // two points are at one place at one instant at most
    }
    const verdict v = sharpened([&](bool coarse) {
        const flight &f = coarse ? x.coarse : x.now, &g = coarse ? y.coarse : y.now;
        return verdict_of(f, g, larger(f.since, g.since), t, meet);
    });
    judge(v, who, larger(x.now.since, y.now.since));
}

template <int N>
void event_check<N>::check_standing(int a, std::size_t b, const certified* t, bool meet) const {
    const mover& x = movers_[static_cast<std::size_t>(a)];
    if (x.at_rest || x.immovable) {
        return;
    }
    if (is_point(x)) {
        check_point(a, b, t, meet);
        return;
    }
    const verdict v = sharpened([&](bool coarse) {
        const flight& f = coarse ? x.coarse : x.now;
        return with_standing(b, [&](const auto& s) { return verdict_of(f, s, f.since, t, meet); });
    });
    judge(v, named(a, b), x.now.since);
}

// Whether a point slides along something, to one side of which it came.
template <int N>
bool event_check<N>::keeps_aside(const mover& x) const {
    return std::any_of(x.sides.begin(), x.sides.end(), [&](const side& kept) {
        return with_standing(kept.standing, [&](const auto& s) {
            return graze::dot(x.now.state.velocity, normal_of<N>(s)).certain_sign() == 0;
        });
    });
}

// A point crosses a plane where its height, a linear function of time, changes its sign.
template <int N>
void event_check<N>::check_point(int a, std::size_t b, const certified* t, bool meet) const {
    const mover& x = movers_[static_cast<std::size_t>(a)];
    const graze::meeting who = named(a, b);
    if (meet || x.last == who) { // it is there at one end of its way, and so nowhere between
        return;
    }
    with_standing(b, [&](const auto& s) {
        const auto height = [&](const vector_of<N>& place) {
            return graze::dot(place - point_of<N>(s), normal_of<N>(s));
        };
        const vector_of<N> from = place_at<N>(x.now, x.now.since);
        const certified before = height(from), speed = graze::dot(x.now.state.velocity, normal_of<N>(s)),
                        after = t != nullptr ? height(place_at<N>(x.now, *t)) : speed;
        const std::optional<int> first = before.certain_sign(), then = after.certain_sign();
        if (t != nullptr && (*t - x.now.since).certain_sign() == 0) {
            return 0;
        }
        if (first == 0 && then) {
            for (const side& kept : x.sides) { // it was at the plane at that instant, and goes on from there
                if (kept.standing == b && kept.sign * *then < 0) {
                    const std::optional<int> place = place_in<N>(s, from);
                    if (!place) {
                        leave_open(who, "whether it passes", x.now.since);
                    }
                    if (*place > 0) {
                        refute(who, "met, and it was not told", x.now.since);
                    }
                }
            }
            return 0;
        }
        if (first && then && *first * *then >= 0) {
            return 0;
        }
        if (first && then) {
            const std::optional<int> place = place_in<N>(s, place_at<N>(x.now, x.now.since - before / speed));
            if (place == 1) {
                judge(verdict::crossed, who, x.now.since);
            }
            if (place == 0 && keeps_aside(x)) { // what it slides along may stand between
                return 0;
            }
        }
        judge(sharpened([&](bool coarse) {
                  const flight& f = coarse ? x.coarse : x.now;
                  return verdict_of(f, s, f.since, t, false);
              }),
              who, x.now.since);
        return 0;
    });
}

template <int N>
void event_check<N>::note_sides(int a, const certified& t, const graze::meeting& who) {
    mover& x = movers_[static_cast<std::size_t>(a)];
    const bool stands_still = (t - x.now.since).certain_sign() == 0;
    std::vector<side> sides;
    for (std::size_t b = 0; b < standing(); ++b) {
        if (who == named(a, b)) {
            continue;
        }
        with_standing(b, [&](const auto& s) {
            const auto height = [&](const certified& at) {
                return graze::dot(place_at<N>(x.now, at) - point_of<N>(s), normal_of<N>(s)).certain_sign();
            };
            if (height(t) == 0) {
                const int from = height(x.now.since).value_or(0);
                if (from != 0) {
                    sides.push_back({b, from});
                } else if (stands_still ||
                           graze::dot(x.now.state.velocity, normal_of<N>(s)).certain_sign() == 0) { // as it came before
                    std::copy_if(x.sides.begin(), x.sides.end(), std::back_inserter(sides),
                                 [&](const side& kept) { return kept.standing == b; });
                }
            }
            return 0;
        });
    }
    x.sides = std::move(sides);
}

template <int N>
void event_check<N>::check_overtaken(int a, const certified& t, const graze::meeting& who) const {
    for (int b = 0; b < static_cast<int>(movers_.size()); ++b) {
        const mover& y = movers_[static_cast<std::size_t>(b)];
        if (b == a || !y.before || (who.with == graze::partner::ball && (b == who.a || b == who.b)) ||
            (t - y.now.since).certain_sign().value_or(-1) >= 0) {
            continue;
        }
        const graze::meeting both{graze::partner::ball, std::min(a, b), std::max(a, b)};
        if ((t - y.before->since).certain_sign().value_or(-1) < 0) {
            leave_open(both, "the order of their events", t);
        }
        judge(verdict_of(movers_[static_cast<std::size_t>(a)].now, *y.before, t, &y.now.since, false), both, t);
    }
}

template class event_check<2>;
template class event_check<3>;

} // namespace compare::run
