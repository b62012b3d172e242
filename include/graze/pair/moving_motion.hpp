// The relative motion of two movers in doubles at the later epoch, for filters, and how far it is from the exact one.
#pragma once

#include <graze/filter/static_filter.hpp>
#include <graze/formula/flight_motion.hpp>
#include <graze/pair/computed_motion.hpp>
#include <graze/pair/moving.hpp>

#include <cmath>

namespace graze::inline v0_1::detail {

// use(motion, length2, in_range). length2: |Δx|² + R²; for flights |x_a - x_b|² + |u lead|² + R². in_range: whether
// epochs allow a filter. Returned as one object, these would go through memory.
template <int N, class T, class F>
[[nodiscard, gnu::always_inline]] inline auto with_motion_at_start(const ball<N, T>& a, const ball<N, T>& b,
                                                                   F use) noexcept {
    const auto m = computed_motion(a, b);
    return use(m, graze::squared_norm(m.dx) + m.R * m.R, true);
}

// The range, beside that of two balls: a lead of magnitude in [2^-500, 2^500), for floats in [2^-30, 2^30), or of two
// instants with the same bits. A mode that reads subnormals as zero then changes the lead by at most 2^-96 of it. Its
// change of u, 2^-126 for floats, is less than 2^-92 of the scale once it is multiplied with a lead below 2^34 times
// that.
template <int N, class T, class F>
[[nodiscard, gnu::always_inline]] inline auto with_motion_at_start(const flight<N, T>& a, const flight<N, T>& b,
                                                                   F use) noexcept {
    constexpr int range = std::is_same_v<T, float> ? 30 : 500;
    const double lead = wide(b.since) - wide(a.since);
    const vec<N, double> u = wide(lead > 0 ? a.state.velocity : b.state.velocity);
    const auto now = computed_motion(a.state, b.state);
    const double length2 = graze::squared_norm(now.dx) + graze::squared_norm(lead * u) + now.R * now.R;
    const unsigned known_lead = static_cast<unsigned>(bits_of(a.since) == bits_of(b.since)) |
                                static_cast<unsigned>(within_powers<-range, range>(std::fabs(lead)));
    const bool in_range = (known_lead & static_cast<unsigned>(lead * lead * 0x1p-68 < length2)) != 0;
    return use(with_lead(now, u, lead), length2, in_range);
}

// The motion of two movers B for error_bound.
template <class B>
struct moving_bounds;
template <int N, class T>
struct moving_bounds<ball<N, T>> : ball_bounds<N, T> {};
// The scale of lengths bounds |x_a - x_b|, |u lead| and R, each by itself.
template <int N, class T>
struct moving_bounds<flight<N, T>> {
    [[nodiscard]] static consteval auto value() {
        return with_lead(ball_bounds<N, T>::value(), bounded_vector<N>(error_bound::exact_input({0, 1, 0})),
                         error_bound::rounded_input({1, -1, 0}));
    }
};

} // namespace graze::inline v0_1::detail
