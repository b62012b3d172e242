// When a ball touches a plane, a wall or a triangle, in doubles with a bound on the error, from the numbers that
// decided that it does.
#pragma once

#include <graze/predicate/classify_walls.hpp>
#include <graze/time/enclosure.hpp>
#include <graze/time/flat_time.hpp>

namespace graze::inline v0_1::detail {

// Around τ = (|w·n| - r|n|)/|u·n| of a ball that certainly touches the plane at a later time, from values with at most
// the given errors; r is exact. Unknown if the doubles leave it open or say little.
//
// u = 2^-52, in any rounding mode, contracted or not. gap = |w·n| - r|n| is off by error_height + r error_length and
// the roundings of r|n| and of the difference, u r|n| + u gap. The quotient t̂ is checked: |t̂ |u·n| - gap| <= 2^-50 gap.
// (Three roundings leave 3/4 of that.)
// With e = error_speed <= |u·n|/8 the time is within
//   (error_height + r error_length + u r|n| + 2^-49 gap + t̂ e)/(|u·n| - e) <= 8/7 (... )/|u·n|,
// in which 2^-49 gap <= 2^-48 t̂ |u·n|; 3/2 of all but this term, and 2^-47 t̂, cover the roundings of the expression
// itself.
[[nodiscard]] inline enclosure enclose_touch(double height, double speed, double length, double r, double error_height,
                                             double error_speed, double error_length) noexcept {
    const double rate = std::fabs(speed);
    const double reach = r * length;
    const double gap = settled(std::fabs(height) - reach);
    const double per_rate = 1 / rate;
    const double time = settled(gap * per_rate);
    const bool good = std::fabs(time * rate - gap) <= 0x1p-50 * gap && rate > 8 * error_speed && gap > 0;
    if (!good) {
        return {};
    }
    const double off = error_height + r * error_length + 0x1p-52 * reach + time * error_speed;
    const enclosure found{time, 1.5 * off * per_rate + 0x1p-47 * time};
    return found.error < 0x1p-10 * time ? found : enclosure{}; // near contact it would be too wide
}

// The same for a ball that certainly touches later but not now, from the numbers known of the plane.
template <int N, class T>
[[nodiscard]] inline enclosure enclose_touch(const filtered_plane<N, T>& f) noexcept {
    const double length = plain_sqrt(f.square);
    if (!(std::fabs(length * length - f.square) <= 0x1p-50 * f.square)) {
        return {};
    }
    // n is exact but for 64-bit integers: the squares and their sum are right to 3u + 2u for each component's rounding.
    constexpr double of_length = (is_wide_integer<T> ? 8 : 4) * error_bound::unit;
    return enclose_touch(f.height, f.speed, length, f.motion.r, f.height_error * f.size,
                         f.speed_error * (f.scales.velocity * f.scales.normal), of_length * length);
}

// Around the smaller root τ = c/(-h + √D), as enclose() in enclosure.hpp with the sharper e that stands there before
// its last step: 7/6 (error_c + t̂ error_root/ŝ)/d̂ + 2^-46 t̂.
[[nodiscard]] inline enclosure enclose_root(double c, double h, double discriminant, double error_c, double error_h,
                                            double error_d) noexcept {
    const double root = settled(plain_sqrt(discriminant));
    const double error_root = error_d + error_h * root;
    const double denominator = settled(root - h);
    const double time = settled(root_stable{}(c, h, root));
    if (!(discriminant > 8 * error_root && c > 0 && h < 0 &&
          std::fabs(root * root - discriminant) <= 0x1p-48 * discriminant &&
          std::fabs(time * denominator - c) <= 0x1p-48 * c)) {
        return {};
    }
    return {time, 1.5 * (error_c + time * error_root / root) / denominator + 0x1p-45 * time};
}

// The enclosure for a certain hit on a feature.
template <int N, class T>
[[nodiscard]] inline enclosure enclose_hit(const filtered_flat<N, T>& f, const flat_way<N, double>& way,
                                           const flat_answer& found) noexcept {
    const auto& judge = f.judge;
    if (found.where == feature::face) {
        double length = 0;
        return judge.root(way.nn, length)
                   ? enclose_touch(way.height, way.speed, length, way.r, judge.error(way_height{}, way),
                                   judge.error(way_speed{}, way), judge.root_error())
                   : enclosure{};
    }
    const flat_decision<N, double, filtered_judge<N, T>> decision(f.motion, way, judge);
    const flat_edge<N, double> x = decision.numbers_of(found);
    if constexpr (N == 3) {
        if (found.where == feature::edge) {
            return enclose_root(border_c{}(x), border_h{}(x), border_whole_discriminant{}(x),
                                judge.error(border_c{}, x), judge.error(border_h{}, x),
                                judge.error(border_whole_discriminant{}, x));
        }
    }
    return enclose_root(corner_c{}(x), corner_h{}(x), corner_discriminant{}(x), judge.error(corner_c{}, x),
                        judge.error(corner_h{}, x), judge.error(corner_discriminant{}, x));
}

// For a hit of which doubles were not certain: an enclosure around the time after one step from theirs.
template <int N, class T, class Shape>
[[nodiscard, gnu::noinline]] enclosure enclose_by_step(const ball<N, T>& b, const Shape& w,
                                                       const flat_answer& found) noexcept {
    if constexpr (has_error_free_doubles && !is_wide_integer<T>) {
        const filtered_flat<N, T> f(b, w);
        if (!(f.in_range && rounds_to_nearest())) {
            return {};
        }
        const auto way = way_of(f.motion);
        double time = 0;
        if (found.where == feature::face) {
            time = (std::fabs(way.height) - way.r * std::sqrt(way.nn)) / std::fabs(way.speed);
        } else {
            const flat_decision<N, double, filtered_judge<N, T>> decision(f.motion, way, f.judge);
            const flat_edge<N, double> x = decision.numbers_of(found);
            const bool is_edge = found.where == feature::edge;
            const double d = is_edge ? border_whole_discriminant{}(x) : corner_discriminant{}(x);
            if (!(d > 0)) {
                return {};
            }
            time = is_edge ? root_stable{}(border_c{}(x), border_h{}(x), std::sqrt(d))
                           : root_stable{}(corner_c{}(x), corner_h{}(x), std::sqrt(d));
        }
        if (!(time > 0)) {
            return {};
        }
        const event_row<N, T> e(ball_and_wall<N>{}, b, w, kind_of<N>(found.where), number_in_wall<Shape>(found), false);
        const flat_time t = flat_time_in_doubles(e, time);
        const double error = absolute(t.low) + t.error + 0x1p-49 * t.high;
        return t.good && error < 0x1p-20 * t.high ? enclosure{t.high, error} : enclosure{};
    }
    return {};
}

// The encounter of a pair, and an enclosure of its time, which is unknown unless doubles are certain of a hit.
struct flat_collision {
    flat_answer found;
    enclosure bounds;
};

// by: the stage that decided.
template <int N, class T, class Shape>
[[nodiscard]] constexpr flat_collision meet_flat(const ball<N, T>& b, const Shape& w, stage& by) {
    by = stage::filter;
    if (!std::is_constant_evaluated()) {
        const filtered_flat<N, T> f(b, w);
        if (f.in_range) [[likely]] {
            if (const flat_answer found = from_afar(f.motion, f.judge); found.certain) {
                return {found, {}};
            }
            const auto way = way_of(f.motion);
            if (const flat_answer found = answer_by_filter<flat_question::feature>(f.motion, way, f.judge);
                found.certain) [[likely]] {
                by = f.judge.decided_by();
                if (found.what != encounter::hit) {
                    return {found, {}};
                }
                const enclosure bounds = enclose_hit(f, way, found);
                return {found, bounds.is_known() ? bounds : enclose_by_step(b, w, found)};
            }
        }
        const flat_answer found = decide_flat_slowly<flat_question::feature>(b, w, by);
        return {found, found.what == encounter::hit ? enclose_by_step(b, w, found) : enclosure{}};
    }
    return {decide_flat<flat_question::feature>(b, w, by), {}};
}
template <int N, class T>
[[nodiscard, gnu::always_inline]] constexpr inline flat_collision meet_flat(const ball<N, T>& b, const plane<N, T>& p,
                                                                            stage& by) {
    by = stage::filter;
    if (!std::is_constant_evaluated()) {
        const filtered_plane<N, T> f(b, p);
        const encounter what = decide_plane(f, b, p, by);
        return {{true, what}, by == stage::filter && what == encounter::hit ? enclose_touch(f) : enclosure{}};
    }
    return {{true, classify(b, p, [&](stage s) { by = s; })}, {}};
}

} // namespace graze::inline v0_1::detail
