// Checks that a point passes through nothing, and notes from which side it came.
#include "check_words.hpp"
#include "event_check.hpp"

#include <algorithm>
#include <utility>

namespace compare::run {

// Whether a point slides along something and keeps to the side from which it came.
template <int N>
bool event_check<N>::keeps_aside(const mover& x) const {
    return std::any_of(x.sides.begin(), x.sides.end(), [&](const side& kept) {
        return with_standing(kept.standing, [&](const auto& s) {
            return graze::dot(x.now.state.velocity, normal_of<N>(s)).certain_sign() == 0;
        });
    });
}

// A point crosses a plane when its height, a linear function of time, changes sign.
template <int N>
void event_check<N>::check_point(int a, std::size_t b, const certified* t, bool meet) const {
    const mover& x = movers_[static_cast<std::size_t>(a)];
    const graze::scene_pair who = named(a, b);
    if (meet || x.last == who) { // at one end of its way it is there, so nowhere in between
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
            for (const side& kept : x.sides) { // it starts at the plane
                if (kept.standing == b && kept.sign * *then < 0) {
                    const std::optional<int> place = place_in<N>(s, from);
                    if (!place) {
                        leave_open(who, "whether it passes", x.now.since);
                    }
                    if (*place > 0) {
                        refute(who, "met, which was not reported", x.now.since);
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
            if (place == 0 && keeps_aside(x)) { // what it slides along may shield the border
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

// For a point in a plane with this normal: the side from which it came there; 0 if unknown.
template <int N>
int event_check<N>::side_along(const mover& x, const vector_of<N>& normal) const {
    for (const side& kept : x.sides) {
        const int sense = with_standing(kept.standing, [&](const auto& s) {
            return may_be_along<N>(normal_of<N>(s), normal)
                       ? graze::dot(normal_of<N>(s), normal).certain_sign().value_or(0)
                       : 0;
        });
        if (sense != 0) {
            return sense * kept.sign;
        }
    }
    return 0;
}

template <int N>
void event_check<N>::note_sides(int a, const certified& t, const graze::scene_pair& who) {
    mover& x = movers_[static_cast<std::size_t>(a)];
    const bool stands_still = (t - x.now.since).certain_sign() == 0;
    std::vector<side> sides;
    for (std::size_t b = 0; b < standing(); ++b) {
        with_standing(b, [&](const auto& s) {
            const auto height = [&](const certified& at) {
                return graze::dot(place_at<N>(x.now, at) - point_of<N>(s), normal_of<N>(s)).certain_sign();
            };
            const bool met = who == named(a, b);
            if (met || (height(t) == 0 && place_in<N>(s, place_at<N>(x.now, t)) != -1)) {
                const std::optional<int> speed = graze::dot(x.now.state.velocity, normal_of<N>(s)).certain_sign();
                int from = met && speed ? -*speed : height(x.now.since).value_or(0);
                if (from == 0 && (stands_still || speed == 0)) { // the side is the one from which it came earlier
                    from = side_along(x, normal_of<N>(s));
                }
                if (from != 0) {
                    sides.push_back({b, from});
                }
            }
            return 0;
        });
    }
    x.sides = std::move(sides);
}

template class event_check<2>;
template class event_check<3>;

} // namespace compare::run
