#include "certified_time.hpp"

#include <graze/formula/root_order.hpp>

namespace compare::run {

namespace {

int order_of(const certified_time::coefficients& q, const certified& t) {
    return graze::root_against(graze::value_at{}(q, t, certified(1)).sign(),
                               graze::slope_at{}(q, t, certified(1)).sign());
}

} // namespace

int order_of(const certified_time& s, const certified_time& t) {
    if (const std::optional<int> certain = (s.value - t.value).certain_sign()) {
        return *certain;
    }
    try {
        if (s.exactly && t.exactly) {
            return graze::root_order{}(s.exactly(), t.exactly());
        }
        if (s.exactly && t.value.is_exact()) {
            return order_of(s.exactly(), t.value);
        }
        if (t.exactly && s.value.is_exact()) {
            return -order_of(t.exactly(), s.value);
        }
    } catch (const undecided_sign&) { // they are of two fields, or too long to be exact
    }
    throw graze::undecided("the order of two times", near_double(s.value));
}

certified_time not_before(const certified& now, const certified& gap, const certified& speed,
                          const std::optional<certified_time::coefficients>& q) {
    if (gap.certain_sign() != 1) {
        throw undecided_sign();
    }
    if (q && q->h.certain_sign() == -1 && q->c.certain_sign() == 1) { // a graze, or nearly one
        const certified root = sqrt(larger(q->h * q->h - q->a * q->c, 0));
        return {not_less(now + q->c / (root - q->h)), nullptr};
    }
    return {not_less(now + gap / highest(speed)), nullptr};
}

} // namespace compare::run
