// The encounter of a ball with a plane, stage by stage.
#pragma once

#include <graze/formula/encounter.hpp>
#include <graze/pair/flat_stages.hpp>
#include <graze/pair/input_check.hpp>

namespace graze::inline v0_1::detail {

template <int N>
[[nodiscard, gnu::always_inline]] constexpr inline magnitudes
magnitudes_of(const plane_motion<N, double, double, double, double>& m) noexcept {
    return {sum_of_magnitudes(m.w) + m.r, sum_of_magnitudes(m.u), sum_of_magnitudes(m.n)};
}

// In doubles: the height and speed of a motion, times |n|, and what they decide for certain.
template <int N, class T>
struct filtered_plane {
    using bounds = plane_bounds<N, T>;
    static constexpr double height_error = filter_constant(plane_height{}, bounds::value());
    static constexpr double speed_error = filter_constant(plane_speed{}, bounds::value());
    static constexpr double clearance_error = filter_constant(plane_clearance{}, bounds::value());
    static_assert(has_degrees(plane_height{}, bounds::value(), 1, 0, 1));
    static_assert(has_degrees(plane_speed{}, bounds::value(), 0, 1, 1));
    static_assert(has_degrees(plane_clearance{}, bounds::value(), 2, 0, 2));

    plane_motion<N, double, double, double, double> motion;
    magnitudes scales;
    double height, speed, square; // square: n·n
    double size, both;            // of the height, and of height·speed
    unsigned in_range;

    // In range no scale is below the least of usable() and `both` is moderate: the others' products with n are then
    // below 2^500, and losses by underflow are negligible beside them. A NaN or an infinity makes `both` one.
    [[gnu::always_inline]] constexpr filtered_plane(const ball<N, T>& b, const plane<N, T>& p) noexcept
        : motion(computed_motion(b, p)), scales(magnitudes_of(motion)), height(plane_height{}(motion)),
          speed(plane_speed{}(motion)), square(graze::squared_norm(motion.n)), size(scales.length * scales.normal),
          both(size * (scales.velocity * scales.normal)),
          in_range(static_cast<unsigned>(within_powers<-300, 300>(both)) &
                   static_cast<unsigned>(std::min(std::min(scales.length, scales.normal), scales.velocity) >
                                         smallest_scale<T>) &
                   static_cast<unsigned>(plain_radii(b.radius, b.radius))) {}

    // (w·n)² - r² n·n.
    [[nodiscard, gnu::always_inline]] constexpr double clearance() const noexcept {
        return height * height - motion.r * motion.r * square;
    }
    struct answer {
        bool certain;
        encounter what;
    };
    // Neither height nor speed is larger than its scales, so their product says that both are certain. The answer is
    // looked up, since no branch could predict it.
    [[nodiscard, gnu::always_inline]] constexpr answer what() const noexcept {
        constexpr double k = std::max(height_error, speed_error) * (1 + 0x1p-20);
        const double departs = height * speed;
        const double clear = clearance();
        const unsigned sure = magnitude_of(departs) > k * both ? 1 : 0;
        const unsigned known = magnitude_of(clear) > clearance_error * (size * size) ? 1 : 0;
        const auto nears = static_cast<unsigned>(std::bit_cast<std::uint64_t>(departs) >> 63);
        const auto inside = static_cast<unsigned>(std::bit_cast<std::uint64_t>(clear) >> 63);
        constexpr unsigned answers = static_cast<unsigned>(encounter::recede) * 0x11U |
                                     static_cast<unsigned>(encounter::hit) << 8 |
                                     static_cast<unsigned>(encounter::overlap) << 12;
        return {(in_range & sure & ((nears ^ 1) | known)) != 0,
                static_cast<encounter>(answers >> (8 * nears + 4 * inside) & 7)};
    }
    // Whether the clearance is negative. Velocities don't matter; but if they are zero, or read as zero, so is `both`.
    [[nodiscard]] constexpr answer overlap(const ball<N, T>& b) const noexcept {
        const double clear = clearance();
        const unsigned good = static_cast<unsigned>(usable<T>({scales.length, 1, scales.normal})) &
                              static_cast<unsigned>(plain_radii(b.radius, b.radius)) &
                              static_cast<unsigned>(is_finite(b.velocity));
        return {good != 0 && magnitude_of(clear) > clearance_error * (size * size),
                clear < 0 ? encounter::overlap : encounter::miss};
    }
};

template <int N, class M, class Judge>
[[nodiscard]] constexpr flat_answer answer_of_plane(const M& m, const Judge& judge, flat_question question) {
    int departs = -1;
    if (question != flat_question::clearance) {
        const int height = judge(plane_height{}, m);
        const int speed = judge(plane_speed{}, m);
        if (height == 0 || speed == 0) {
            return {true, encounter::recede};
        }
        departs = height == open_sign || speed == open_sign ? open_sign : height * speed;
    }
    if (departs == 1) {
        return {true, encounter::recede};
    }
    const int clear = judge(plane_clearance{}, m);
    const bool is_certain = departs != open_sign && clear != open_sign;
    return {is_certain, clear < 0                              ? encounter::overlap
                        : question == flat_question::clearance ? encounter::miss
                                                               : encounter::hit};
}

template <class T>
struct scaled_plane_row {
    scaled_group<T> length, velocity, normal;
};

template <int N, class T>
[[nodiscard, gnu::noinline]] flat_answer plane_by_words(const T* row, flat_question question) noexcept {
    using P = ball_and_plane<N>;
    const scaled_plane_row<T> in{
        {row, P::lengths}, {row + P::lengths, P::velocities}, {row + P::lengths + P::velocities, P::normals}};
    return in.length.plain && in.velocity.plain && in.normal.plain
               ? answer_of_plane<N>(P::template motion<bounded_word>(in), word_judge{}, question)
               : flat_answer{};
}

// Whether the ball is known to come no closer and move no farther away: at rest, or along an axis that the plane is
// parallel to.
template <int N, class T>
[[nodiscard]] constexpr bool moves_along(const ball<N, T>& b, const plane<N, T>& p) noexcept {
    return plane_speed{}(plane_motion{known_zeros(b.position), known_zeros(b.velocity), known_zeros(p.normal),
                                      known_zero(b.radius)})
        .is_zero();
}

// Inputs are checked here, where doubles are not certain.
template <int N, class T>
[[nodiscard, gnu::noinline]] constexpr flat_answer decide_plane_slowly(const ball<N, T>& b, const plane<N, T>& p,
                                                                       flat_question question, stage& by) {
    using P = ball_and_plane<N>;
    check(b, "ball");
    check(p, name_of(p));
    if (question != flat_question::clearance && moves_along(b, p)) {
        return {true, encounter::recede};
    }
    const auto row = packed<P>(b, p);
    if constexpr (has_error_free_doubles && !is_wide_integer<T>) {
        if (!std::is_constant_evaluated() && rounds_to_nearest()) {
            if (const flat_answer found = plane_by_words<N>(row.data(), question); found.certain) {
                by = wider(by, stage::double_word);
                return found;
            }
        }
    }
    by = stage::exact;
    exact_workspace room;
    auto in = lift_row<P>(row);
    in.use(room);
    return answer_of_plane<N>(P::template motion<big_integer>(in), exact_judge{&room}, question);
}

template <int N, class T>
[[nodiscard, gnu::always_inline]] constexpr inline encounter
decide_plane(const filtered_plane<N, T>& f, const ball<N, T>& b, const plane<N, T>& p, stage& by) {
    const auto found = f.what();
    return found.certain ? found.what : decide_plane_slowly(b, p, flat_question::what, by).what;
}

} // namespace graze::inline v0_1::detail
