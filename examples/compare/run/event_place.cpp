// Checks that the two of an event touch, come closer, and part by the laws.
#include "check_words.hpp"
#include "event_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace compare::run {

template <int N>
whole_image<N> event_check<N>::image_at(const graze::scene_pair& who, const certified& t) const {
    const flight& a = movers_[static_cast<std::size_t>(who.a)].now;
    image best{};
    double least = std::numeric_limits<double>::infinity();
    const auto look = [&](const auto& s) {
        const bool known = space_.for_each(a, s, t, &t, [&](const image& periods) {
            const clearance there = clearance_at<N>(a, space_.image_of(s, periods), t);
            const bool may_be_met =
                there.value.certain_sign().value_or(0) <= 0 && there.slope.certain_sign().value_or(0) <= 0;
            const double off = std::abs(near_double(there.value)) * (may_be_met ? 0x1p-100 : 1);
            if (off < least) {
                least = off;
                best = periods;
            }
        });
        if (!known) {
            leave_open(who, "which image is met", t);
        }
        return 0;
    };
    if (who.with == graze::partner::ball) {
        look(movers_[static_cast<std::size_t>(who.b)].now);
    } else if (who.with != graze::partner::plane) { // whose normal has no component along a period
        with_standing(standing_of(who), look);
    }
    return best;
}

template <int N>
void event_check<N>::check_place(const graze::scene_pair& who, const image& periods, const certified& t) const {
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
    const std::size_t standing = two ? 0 : standing_of(who);
    const clearance there = two ? clearance_at<N>(a.now, space_.image_of(b->now, periods), t)
                                : with_standing(
                                      standing, [&](const auto& s) { return clearance_at<N>(a.now, s, t); }, periods);
    const std::optional<int> apart = there.value.certain_sign(), going = there.slope.certain_sign();
    if (apart == 1) {
        refute(who, "do not touch", t);
    }
    // What is inside each other meets at the start of a flight, as soon as they come closer, and not on the way.
    const auto starts = [&](const mover& m) { return (t - m.now.since).certain_sign().value_or(0) == 0; };
    if (apart == -1 && !starts(a) && !(two && starts(*b))) {
        refute(who, "are inside each other", t);
    }
    if (going == 1) {
        refute(who, "part", t);
    }
    if (!two && is_point(a)) { // a point's clearance has slope 0 there, so its speed decides
        const std::optional<int> speed = with_standing(
            standing, [&](const auto& s) { return graze::dot(a.now.state.velocity, normal_of<N>(s)).certain_sign(); });
        if (!speed) {
            leave_open(who, "whether they come closer", t);
        }
        const bool inside = with_standing(standing, [&](const auto& s) { return place_in<N>(s, x) == 1; });
        for (const side& s : a.sides) { // at a border it may have come round from the other side
            if (inside && s.standing == standing && *speed * s.sign > 0) {
                refute(who, "part", t);
            }
        }
    } else if (!going && !(two && is_point(a) && is_point(*b))) {
        leave_open(who, "whether they come closer", t);
    }
}

template <int N>
void event_check<N>::check_laws(const graze::scene_pair& who, const image& periods, const certified& t, const flight& a,
                                const flight* b) const {
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
        is_wrong(agree<N>(space_.brought_to(place_at<N>(a, t), at), at));
    }
    if (b == nullptr) {
        flight left = a; // at the place where it met s
        left.state.position = left.state.position + (space_.brought_to(place_at<N>(a, t), at) - place_at<N>(a, t));
        const auto parts = [&](const auto& s) {
            vector_of<N> normal = normal_of<N>(s);
            if (!is_point(x)) {
                const clearance before = clearance_at<N>(x.now, s, t), after = clearance_at<N>(left, s, t);
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
        };
        with_standing(standing_of(who), parts, periods);
        return;
    }
    const mover& y = movers_[static_cast<std::size_t>(who.b)];
    const vector_of<N> other = b->state.velocity - y.now.state.velocity;
    const vector_of<N> other_at = place_at<N>(y.now, t);
    is_wrong(y.immovable ? is_zero<N>(other) : agree<N>(space_.brought_to(place_at<N>(*b, t), other_at), other_at));
    const vector_of<N> apart = at - place_at<N>(space_.image_of(y.now, periods), t);
    is_wrong(may_be_along<N>(change, apart) && may_be_along<N>(other, apart));
    const certified inverse_a = certified(1) / a.state.mass, inverse_b = certified(1) / b->state.mass;
    is_wrong(agree<N>(inverse_b * change, -(inverse_a * other))); // momentum, in units of the product of the masses
    const vector_of<N> before = x.now.state.velocity - y.now.state.velocity,
                       after = a.state.velocity - b->state.velocity;
    is_wrong(agree(graze::squared_norm(before), graze::squared_norm(after))); // energy, about the common centre
    const std::optional<int> parts = graze::dot(apart, after).certain_sign();
    is_wrong(parts != -1);
}

template class event_check<2>;
template class event_check<3>;

} // namespace compare::run
