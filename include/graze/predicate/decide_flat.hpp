// The exact encounter of a ball with a wall or a triangle, and the feature that it meets.
#pragma once

#include <graze/pair/flat_stages.hpp>
#include <graze/pair/input_check.hpp>

namespace graze::inline v0_1::detail {

// The first stage: the pair in doubles, and what they decide for certain.
template <int N, class T>
struct filtered_flat {
    flat_motion<N, double> motion;
    filtered_judge<N, T> judge;
    bool in_range;

    template <class Shape>
    [[gnu::always_inline]] constexpr filtered_flat(const ball<N, T>& b, const Shape& shape) noexcept
        : motion(computed_flat_motion(b, shape.corner, shape.edge, is_triangle<Shape>)), judge{magnitudes_of(motion)},
          in_range(usable<T>(judge.scales) && plain_radii(b.radius, b.radius)) {}
};

// Inputs are checked here, where doubles are not certain. Inputs out of the filter's range are not finite, or zero, or
// merely unusual.
template <flat_question Question, int N, class T, class Shape>
[[nodiscard, gnu::noinline]] constexpr flat_answer decide_flat_slowly(const ball<N, T>& b, const Shape& shape,
                                                                      stage& by) {
    check(b, "ball");
    check(shape, name_of(shape));
    const auto row = packed<ball_and_wall<N>>(b, shape);
    const bool rests = is_zero(b.velocity);
    bool filtered = false; // not const: its value would be that of a constant expression
    if (!std::is_constant_evaluated() && !rests) {
        filtered = filtered_flat<N, T>(b, shape).in_range;
    }
    stage widest = by;
    const flat_answer found = refine_flat<Question, N, T>(row, is_triangle<Shape>, rests, filtered, widest);
    if (Question == flat_question::clearance || !rests) {
        by = widest;
    }
    if (!found.certain) {
        tell_parallel_edges(rejecting{name_of(shape)});
    }
    return found;
}

// by: the stage that decided.
template <flat_question Question, int N, class T, class Shape>
[[nodiscard]] constexpr flat_answer decide_flat(const ball<N, T>& b, const Shape& shape, stage& by) {
    by = stage::filter;
    if (!std::is_constant_evaluated() || is_moderate(b, shape)) {
        filtered_flat<N, T> f(b, shape);
        if constexpr (Question == flat_question::clearance) {
            forget_rest_in(f.judge.scales);
            f.in_range = usable<T>(f.judge.scales) && plain_radii(b.radius, b.radius);
        }
        if (f.in_range) [[likely]] {
            if constexpr (Question != flat_question::clearance) {
                if (const flat_answer found = from_afar(f.motion, f.judge); found.certain) {
                    return found;
                }
            }
            if (const flat_answer found = answer_by_filter<Question>(f.motion, way_of(f.motion), f.judge);
                found.certain) [[likely]] {
                by = f.judge.decided_by();
                return found;
            }
        }
    }
    return decide_flat_slowly<Question>(b, shape, by);
}

} // namespace graze::inline v0_1::detail
