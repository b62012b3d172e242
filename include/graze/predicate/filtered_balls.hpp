// The filter of two movers: the encounter from the signs of h, c and D in doubles, with one bound for the three.
#pragma once

#include <graze/filter/static_filter.hpp>
#include <graze/formula/discriminant.hpp>
#include <graze/formula/encounter.hpp>
#include <graze/pair/input_check.hpp>
#include <graze/pair/moving_motion.hpp>
#include <graze/pair/scaled_movers.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace graze::inline v0_1::detail {

struct halved_of_motion {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return discriminant_halved{}(quadratic_of(m));
    }
};

// The constant of D. It serves the two other signs too, by the same product of scales, S = length²·velocity²: h² > K S
// implies |h| > K_h length·velocity, and a|c| > K S is |c| > K length².
template <int N, class T, class Bounds = ball_bounds<N, T>>
struct ball_filter {
    static constexpr double h = filter_constant(coefficient_h{}, Bounds::value());
    static constexpr double c = filter_constant(coefficient_c{}, Bounds::value());
    static constexpr double discriminant = filter_constant(halved_of_motion{}, Bounds::value());

    static_assert(has_degrees(coefficient_h{}, Bounds::value(), 1, 1, 0));
    static_assert(has_degrees(coefficient_c{}, Bounds::value(), 2, 0, 0));
    static_assert(has_degrees(halved_of_motion{}, Bounds::value(), 2, 2, 0));
    static_assert(discriminant > 2 * h * h && discriminant > 2 * c, "one constant must serve all three signs");
};
template <moving B>
using filter_of = ball_filter<dimension_of<B>, number_in<B>, moving_bounds<B>>;

// What the filter knows about a pair: the encounter, if it is certain, and the numbers on which it rests.
struct filtered_balls {
    bool certain = false;
    double h = 0, c = 0, discriminant = 0;

    // Looked up by the three signs, none of which is 0: pairs come in no order that a branch could predict.
    [[nodiscard, gnu::always_inline]] encounter what() const noexcept {
        using enum encounter;
        static constexpr encounter by_signs[8] = {recede, recede, recede, recede, hit, miss, overlap, overlap};
        return by_signs[2 * (2 * (bits_of(h) >> 63) + (bits_of(c) >> 63)) + (bits_of(discriminant) >> 63)];
    }
};

// The range. |Δu|² and length2 above smallest_square keep what underflow loses, or a mode flushes to zero, below 2^-90
// of any scale; for float that is also what is lost when a subnormal input becomes a double. Their product below 2^570
// keeps each of them below 2^1020: then nothing has overflowed, neither to an infinity nor, where rounding is directed,
// to the largest double. A NaN or an infinity makes a comparison false.
template <class T>
inline constexpr double smallest_square = std::is_same_v<T, float> ? 0x1p-64 : 0x1p-450;

// The bits of the larger radius, or more than those of any number if one has its sign set.
template <moving B>
[[nodiscard, gnu::always_inline]] inline std::uint64_t larger_radius(const B& a, const B& b) noexcept {
    return std::max(bits_of(state_of(a).radius), bits_of(state_of(b).radius));
}

// Whether the larger radius has a size that usually is in that range, by its bits. Where it has not, products that
// underflow would take longer than all the rest. R² is then within 2^-440 and 2^562.
[[nodiscard]] constexpr bool is_usual_radius(std::uint64_t bits) noexcept {
    return bits_within_powers<-220, 280>(bits);
}

// Whether no radius has its sign set and, of doubles, the larger one has a usual size.
template <moving B>
[[nodiscard, gnu::always_inline]] inline bool has_usual_size(const B& a, const B& b) noexcept {
    if constexpr (std::is_same_v<number_in<B>, double>) {
        return is_usual_radius(larger_radius(a, b));
    } else {
        return plain_radii(state_of(a).radius, state_of(b).radius);
    }
}

// Constants: those of a ball_filter, for the motion m and the computed |length|². is_long: whether that is known to be
// above smallest_square.
template <class T, class Constants>
struct started_filter {
    quadratic<double, double, double> q;
    double length2;
    double scale;
    bool in_range;

    template <class M>
    [[gnu::always_inline]] constexpr started_filter(const M& m, double square, bool is_long = false) noexcept
        : q(quadratic_of(m)), length2(square), scale(q.a * length2),
          in_range(((is_long ? q.a : std::min(q.a, length2)) > smallest_square<T>)&(scale < 0x1p570)) {}

    // Whether h > 0 is certain. Where a branch on it is worth its cost, it saves the rest of the work.
    [[nodiscard, gnu::always_inline]] bool is_parting() const noexcept {
        return all_hold(q.h * std::fabs(q.h) > Constants::discriminant * scale, in_range);
    }
    // For balls that are not parting: D, and whether a hit is certain, by fewer comparisons than finish() makes. It is
    // certain if D exceeds `clear` times its bound: h² = D + a c then exceeds it as well, but for roundings, and h is
    // negative, or they would be parting.
    static constexpr double clear = 16;
    struct clear_hit {
        double discriminant;
        bool certain;
    };
    [[nodiscard, gnu::always_inline]] clear_hit find_clear_hit() const noexcept {
        const double d = discriminant_halved{}(q);
        return {d, all_hold(std::min(1 / clear * d, q.a * q.c) > Constants::discriminant * scale, in_range)};
    }
    [[nodiscard, gnu::always_inline]] filtered_balls finish() const noexcept {
        filtered_balls r;
        r.h = q.h;
        r.c = q.c;
        r.discriminant = discriminant_halved{}(q);
        const double bound = Constants::discriminant * scale;
        // h² is to be large enough, and |D| and a|c| unless h > 0.
        const double square = r.h * r.h;
        const double least = std::min(std::min(std::fabs(q.a * q.c), square), std::fabs(r.discriminant));
        r.certain = in_range && (least > bound || (r.h > 0 && square > bound));
        return r;
    }
};

// For two movers; is_usual: whether they have that size.
template <moving B>
[[nodiscard, gnu::always_inline]] inline auto start_filter(const B& a, const B& b, bool is_usual = false) noexcept {
    const bool plain = is_usual || plain_radii(state_of(a).radius, state_of(b).radius);
    return with_motion_at_start(
        a, b, [ plain, is_usual ](const auto& m, double length2, bool in_range) __attribute__((always_inline)) {
            started_filter<number_in<B>, filter_of<B>> r(m, length2, is_usual && std::is_same_v<number_in<B>, double>);
            r.in_range = r.in_range & in_range & plain;
            return r;
        });
}

// The filter of two balls whose larger radius has these bits and is scaled or has a usual size.
template <int N>
[[nodiscard, gnu::always_inline]] inline filtered_balls
filter_motion(const relative_motion<N, double, double, double>& m) noexcept {
    return started_filter<double, filter_of<ball<N, double>>>(m, graze::squared_norm(m.dx) + m.R * m.R, true).finish();
}

// The filter of two movers; of two balls in any units.
template <moving B>
[[nodiscard, gnu::always_inline]] inline filtered_balls filter_movers(const B& a, const B& b) noexcept {
    if constexpr (std::is_same_v<B, ball<dimension_of<B>, double>>) {
        auto m = computed_motion(a, b);
        if (const std::uint64_t radius = larger_radius(a, b); !is_usual_radius(radius)) [[unlikely]] {
            const scaled_motion s(m, radius);
            if (!s.safe) {
                return {};
            }
            m = s.motion;
        }
        return filter_motion(m);
    } else {
        return has_usual_size(a, b) ? start_filter(a, b, true).finish() : filtered_balls{};
    }
}

} // namespace graze::inline v0_1::detail
