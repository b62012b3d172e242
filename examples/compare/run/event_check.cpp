#include "event_check.hpp"

#include "check_words.hpp"

#include <algorithm>
#include <cmath>

namespace compare::run {

namespace {

constexpr long few_bits = 96;

template <int N>
graze::flight<N, certified> coarsened(const graze::flight<N, certified>& a) {
    const auto vector = [](const vector_of<N>& x) {
        return graze::make_vec<N>([&](int i) { return x[i].rounded(few_bits); });
    };
    return {{vector(a.state.position), vector(a.state.velocity), a.state.radius.rounded(few_bits), a.state.mass},
            a.since.rounded(few_bits)};
}

template <int N>
bool is_zero(const vector_of<N>& x) {
    return std::all_of(x.component, x.component + N, [](const certified& c) { return c.certain_sign() == 0; });
}

// Whether they may be equal.
bool agree(const certified& x, const certified& y) { return (x - y).certain_sign().value_or(0) == 0; }

template <int N>
bool agree(const vector_of<N>& x, const vector_of<N>& y) {
    for (int i = 0; i < N; ++i) {
        if (!agree(x[i], y[i])) {
            return false;
        }
    }
    return true;
}

// Whether x may be along n.
template <int N>
bool may_be_along(const vector_of<N>& x, const vector_of<N>& n) {
    const auto across = graze::cross(x, n);
    if constexpr (N == 2) {
        return agree(across, certified(0));
    } else {
        return agree<N>(across, vector_of<N>{});
    }
}

} // namespace

template <int N>
event_check<N>::event_check(const owned_scene<N, certified>& scene) : scene_(scene) {
    const auto reach = [&](const vector_of<N>& x) {
        for (int i = 0; i < N; ++i) {
            size_ = std::max(size_, std::abs(near_double(x[i])));
        }
    };
    for (const auto& b : scene.balls) {
        const flight f{b, certified(0)};
        movers_.push_back({f, coarsened<N>(f), {}, {}, {}, b.mass.is_infinite(), is_zero<N>(b.velocity)});
        reach(b.position);
        size_ = std::max(size_, near_double(b.radius));
    }
    for (const auto& w : scene.walls) {
        reach(w.corner);
        reach(w.edge[0]);
    }
}

template <int N>
graze::meeting event_check<N>::named(int a, std::size_t standing) const {
    return standing < scene_.planes.size()
               ? graze::meeting{graze::partner::plane, a, static_cast<int>(standing)}
               : graze::meeting{graze::partner::wall, a, static_cast<int>(standing - scene_.planes.size())};
}

namespace {

std::size_t standing_of(const graze::meeting& who, std::size_t planes) {
    return static_cast<std::size_t>(who.b) + (who.with == graze::partner::wall ? planes : 0);
}

} // namespace

template <int N>
void event_check<N>::event(const graze::meeting& who, const certified& t, const flight& a, const flight* b) {
    check_place(who, t);
    check_laws(who, t, a, b);
    check_way(who.a, t, &who);
    if (b != nullptr) {
        check_way(who.b, t, &who);
    }
    start(who.a, a, t, who);
    if (b != nullptr) {
        start(who.b, *b, t, who);
    }
}

template <int N>
void event_check<N>::check_place(const graze::meeting& who, const certified& t) const {
    const mover& a = movers_[static_cast<std::size_t>(who.a)];
    const bool two = who.with == graze::partner::ball;
    const mover* b = two ? &movers_[static_cast<std::size_t>(who.b)] : nullptr;
    if ((t - a.now.since).certain_sign() == -1 || (two && (t - b->now.since).certain_sign() == -1)) {
        refute(who, "meet before they fly", t);
    }
    const vector_of<N> x = place_at<N>(a.now, t);
    for (int i = 0; i < N; ++i) {
        const graze::time_bounds around = x[i].bounds();
        if (!(around.upper - around.lower <= 0x1p-20 * std::max(size_, std::abs(around.upper)))) {
            leave_open(who, "where they meet", t);
        }
    }
    const std::size_t standing = two ? 0 : standing_of(who, scene_.planes.size());
    const clearance there = two ? clearance_at<N>(a.now, b->now, t)
                                : with_standing(standing, [&](const auto& s) { return clearance_at<N>(a.now, s, t); });
    const std::optional<int> apart = there.value.certain_sign(), going = there.slope.certain_sign();
    if (apart == 1) {
        refute(who, "do not touch", t);
    }
    // Inside each other they meet as soon as they are seen to come closer, and not on the way.
    const auto starts = [&](const mover& m) { return (t - m.now.since).certain_sign().value_or(0) == 0; };
    if (apart == -1 && !starts(a) && !(two && starts(*b))) {
        refute(who, "are inside each other", t);
    }
    if (going == 1) {
        refute(who, "part", t);
    }
    if (!two && is_point(a)) { // the slope of a point's clearance is 0 there: it is asked for its speed
        const std::optional<int> speed = with_standing(
            standing, [&](const auto& s) { return graze::dot(a.now.state.velocity, normal_of<N>(s)).certain_sign(); });
        if (!speed) {
            leave_open(who, "whether they come closer", t);
        }
        for (const side& s : a.sides) {
            if (s.standing == standing && *speed * s.sign > 0) {
                refute(who, "part", t);
            }
        }
    } else if (!going && !(two && is_point(a) && is_point(*b))) {
        leave_open(who, "whether they come closer", t);
    }
}

template <int N>
void event_check<N>::check_laws(const graze::meeting& who, const certified& t, const flight& a, const flight* b) const {
    const mover& x = movers_[static_cast<std::size_t>(who.a)];
    const vector_of<N> at = place_at<N>(x.now, t), change = a.state.velocity - x.now.state.velocity;
    const auto is_wrong = [&](bool right) {
        if (!right) {
            refute(who, "do not part by the laws of collision", t);
        }
    };
    if (x.immovable) {
        is_wrong(is_zero<N>(change));
    } else {
        is_wrong(agree<N>(place_at<N>(a, t), at));
    }
    if (b == nullptr) {
        with_standing(standing_of(who, scene_.planes.size()), [&](const auto& s) {
            vector_of<N> normal = normal_of<N>(s);
            if (!is_point(x)) {
                const clearance before = clearance_at<N>(x.now, s, t), after = clearance_at<N>(a, s, t);
                is_wrong(agree(before.slope, -after.slope) || x.immovable);
                if constexpr (requires { s.edge; }) {
                    normal = at - nearest_point<N>(s, at);
                }
            }
            is_wrong(may_be_along<N>(change, normal));
            is_wrong(x.immovable ||
                     agree(graze::dot(a.state.velocity, normal), -graze::dot(x.now.state.velocity, normal)));
            is_wrong(agree(graze::squared_norm(a.state.velocity), graze::squared_norm(x.now.state.velocity)));
            return 0;
        });
        return;
    }
    const mover& y = movers_[static_cast<std::size_t>(who.b)];
    const vector_of<N> other = b->state.velocity - y.now.state.velocity;
    is_wrong(y.immovable ? is_zero<N>(other) : agree<N>(place_at<N>(*b, t), place_at<N>(y.now, t)));
    const vector_of<N> apart = at - place_at<N>(y.now, t);
    is_wrong(may_be_along<N>(change, apart) && may_be_along<N>(other, apart));
    const certified inverse_a = certified(1) / a.state.mass, inverse_b = certified(1) / b->state.mass;
    is_wrong(agree<N>(inverse_b * change, -(inverse_a * other))); // momentum, in units of the product of the masses
    const vector_of<N> before = x.now.state.velocity - y.now.state.velocity,
                       after = a.state.velocity - b->state.velocity;
    is_wrong(agree(graze::squared_norm(before), graze::squared_norm(after))); // energy, about the common centre
    const std::optional<int> parts = graze::dot(apart, after).certain_sign();
    is_wrong(parts != -1);
}

template <int N>
void event_check<N>::start(int a, const flight& f, const certified& t, const graze::meeting& who) {
    mover& x = movers_[static_cast<std::size_t>(a)];
    if (x.immovable) {
        return;
    }
    if (is_point(x)) {
        note_sides(a, t, who);
    }
    x.before = std::exchange(x.now, f);
    x.coarse = coarsened<N>(f);
    x.last = who;
    if (who.with == graze::partner::ball && who.b < who.a) {
        std::swap(x.last->a, x.last->b);
    }
    x.at_rest = is_zero<N>(f.state.velocity);
    check_overtaken(a, t, who);
}

template <int N>
void event_check<N>::end(const certified& t) {
    for (int a = 0; a < static_cast<int>(movers_.size()); ++a) {
        check_way(a, t, nullptr);
    }
}

template <int N>
void event_check<N>::end_of_all() {
    for (int a = 0; a < static_cast<int>(movers_.size()); ++a) {
        for (int b = 0; b < a; ++b) {
            check_pair(a, b, nullptr, false);
        }
        for (std::size_t b = 0; b < standing(); ++b) {
            check_standing(a, b, nullptr, false);
        }
    }
}

template class event_check<2>;
template class event_check<3>;

} // namespace compare::run
