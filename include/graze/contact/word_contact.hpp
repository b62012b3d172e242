// The contact of two movers in double words: where doubles leave components in doubt, or leave open whether they meet.
//
// y = Δx + Δu τ comes from its parts across Δu and along it (separation_at_contact), which do not cancel for balls from
// far away; √D is the speed at which they close times R. In the plane and in space, with any lengths and velocities.
#pragma once

#include <graze/contact/contact_in_doubles.hpp>
#include <graze/contact/equal_masses.hpp>
#include <graze/formula/contact.hpp>
#include <graze/time/further_time.hpp>

namespace graze::inline v0_1::detail {

// What y and n = y/R can be off by. The analysis runs separation_at_contact on Δu, and on Δx × Δu and √D over a, 1/a
// being right to 9.2u² with a low part of 2.02u, that of √D up to 1.5u; a itself is off by of_a, relatively, and so are
// its quotients. What Δx × Δu and √D are off by themselves is multiplied by at most Σ|Δu_i|/a. n = y/R takes 22u²
// (lane_steps.hpp).
template <int N>
struct separation_bounds {
    static constexpr auto input = word_rounding::exact_input();
    static constexpr double of_a = graze::squared_norm(make_vec<N>([](int) { return input; })).bound();
    static constexpr double of_y = [] {
        const auto quotient = input * word_rounding(3, 10);
        const auto root = word_rounding(2, 0) * word_rounding(3, 10);
        const auto du = make_vec<N>([](int) { return input; });
        if constexpr (N == 2) {
            return separation_at_contact(du, quotient, root)[0].bound();
        } else {
            return separation_at_contact(du, vec<3, word_rounding>{{quotient, quotient, quotient}}, root)[0].bound();
        }
    }();
};

// How long each of two movers has been on its way, high + low, side by side: before + time, where `before` is 0 for
// the later one.
template <bool Fused>
struct word_times {
    factor<lanes, Fused> high;
    lanes low, error;

    [[gnu::always_inline]] word_times(const lanes& before, const lanes& before_low,
                                      const bounded<double>& time) noexcept {
        const auto sum = two_sum(before, both(time.high));
        high = as_factor<Fused>(sum.value);
        low = sum.error + (before_low + both(time.low));
        error = both(1.01 * time.error) + 0x1p-103 * absolute(sum.value);
    }
};
template <bool Fused, moving B>
[[nodiscard, gnu::always_inline]] inline word_times<Fused> times_of(const B& a, const B& b,
                                                                    const bounded<double>& time) noexcept {
    const lanes none{0, 0};
    if constexpr (is_flight<B>) {
        const auto lead = two_difference(as_stored(b.since), as_stored(a.since));
        return lead.value > 0 ? word_times<Fused>(lanes{lead.value, 0}, lanes{lead.error, 0}, time)
                              : word_times<Fused>(lanes{0, -lead.value}, lanes{0, -lead.error}, time);
    } else {
        return word_times<Fused>(none, none, time);
    }
}

// Both positions, side by side: each from its own time, or from the other's position and y if that is more accurate.
template <bool Fused, moving B, int N, class F>
[[gnu::always_inline]] inline void bound_positions(const B& a, const B& b, const bounded<double>& time,
                                                   const vec<N, loose_word<Fused>>& y, const vec<N, double>& y_error,
                                                   F& take) noexcept {
    const word_times<Fused> times = times_of<Fused>(a, b, time);
    const auto& p = state_of(a);
    const auto& q = state_of(b);
    for (int i = 0; i < N; ++i) {
        const lanes x{p.position[i], q.position[i]};
        const lanes u{p.velocity[i], q.velocity[i]};
        const auto own = position_in_parts(x, u, times.high, times.low);
        const lanes own_error = 0x1p-104 * absolute(x) + 1.25 * absolute(u) * times.error;
        const lanes between{y[i].high, -y[i].high};
        const lanes others = picked(own.value, 1, 0);
        const auto sum = two_sum(others, between);
        const lanes low = sum.error + (picked(own.error, 1, 0) + lanes{y[i].low, -y[i].low});
        const lanes error =
            picked(own_error, 1, 0) + (0x1p-102 * (absolute(others) + absolute(between)) + both(y_error[i]));
        const bool first = error[0] < own_error[0];
        const bool second = error[1] < own_error[1];
        const auto better = [&](const lanes& other, const lanes& mine) __attribute__((always_inline)) {
            return lanes{first ? other[0] : mine[0], second ? other[1] : mine[1]};
        };
        take(bounded<lanes>{better(sum.value, own.value), better(low, own.error),
                            better(error, own_error) + both(underflow)},
             1 + i, 4 + i);
    }
}

// What each component of y can be off by: every term by what its quotient by a is, and by underflow. With |Δu| within
// 2^-150 and 2^131 that is below 2^-1070/|Δu| < 2^-900.
template <bool Fused>
[[nodiscard, gnu::always_inline]] inline vec<2, double> separation_error(const vec<2, loose_word<Fused>>& du,
                                                                         double across, double along) noexcept {
    const double u0 = std::fabs(du[0].high), u1 = std::fabs(du[1].high);
    return {{u1 * across + u0 * along + 0x1p-900, u0 * across + u1 * along + 0x1p-900}};
}
template <bool Fused>
[[nodiscard, gnu::always_inline]] inline vec<3, double>
separation_error(const vec<3, loose_word<Fused>>& du, const vec<3, double>& across, double along) noexcept {
    const double u0 = std::fabs(du[0].high), u1 = std::fabs(du[1].high), u2 = std::fabs(du[2].high);
    return {{u1 * across[2] + u2 * across[1] + u0 * along + 0x1p-900,
             u2 * across[0] + u0 * across[2] + u1 * along + 0x1p-900,
             u0 * across[1] + u1 * across[0] + u2 * along + 0x1p-900}};
}

// For a hit.
template <bool Fused, moving B, class F>
[[gnu::always_inline]] inline void bound_word_contact(const word_approach<Fused, B>& w, const B& a, const B& b,
                                                      double mass_a, double mass_b, F& take) noexcept {
    constexpr int N = dimension_of<B>;
    using word = loose_word<Fused>;
    const bounded<double> time{w.time.high, w.time.low, (1 + 0x1p-40) * w.time_error};
    take(on_clock_of(a, b, time), 0);

    const word ordered_a = w.a.in_order();
    const auto inverse = inverse_of<Fused>(exact_pair<double>{ordered_a.high, ordered_a.low});
    const word per_a(inverse.high.value, inverse.low);
    const word along = w.root * per_a;
    const auto across = w.cross.over(per_a);
    const auto y_loose = separation_at_contact(w.motion.du, across, along);
    const auto y = make_vec<N>([&](int i) { return word(two_sum(y_loose[i].high, y_loose[i].low)); });
    constexpr double relative = 1.0001 * (separation_bounds<N>::of_y + separation_bounds<N>::of_a);
    const auto y_error =
        separation_error(w.motion.du, w.cross.errors_over(across, relative, 1.0001 * inverse.high.value),
                         relative * along.high + 1.0001 * w.root_error * inverse.high.value);
    bound_positions<Fused>(a, b, time, y, y_error, take);

    const lane_motion unused{};
    const lanes zero{0, 0};
    const lane_displacement<Fused> y01{as_factor<Fused>(lanes{y[0].high, y[1].high}), lanes{y[0].low, y[1].low},
                                       as_factor<Fused>(zero)};
    const lane_displacement<Fused> y2{as_factor<Fused>(N == 3 ? lanes{0, y[N - 1].high} : zero),
                                      N == 3 ? lanes{0, y[N - 1].low} : zero, as_factor<Fused>(zero)};
    const lane_contact<Fused> contact{unused, y01, y2, y01.low, y2.low, {w.motion.R.high, w.motion.R.low}};
    const word s = w.root.in_order();
    const double per_length = 1.0001 / w.motion.R.high;
    const error_by_component errors{per_length * lanes{y_error[0], y_error[1]},
                                    per_length * lanes{0, N == 3 ? y_error[N - 1] : 0}, 0x1p-100,
                                    1.0001 * w.root_error / s.high + 0x1p-98};
    narrower_velocities<N, F> velocities{take};
    if (mass_a == mass_b) {
        const exact_pair<double> R{w.motion.R.high, w.motion.R.low};
        velocities.exchanged =
            exchange_velocities(state_of(a).velocity, state_of(b).velocity, w.cross, y, y_error, R, 0);
        velocities.is_known = true;
    }
    bound_impact(state_of(a), state_of(b), mass_a, mass_b, contact, exact_pair<double>{s.high, s.low}, errors,
                 velocities);
}

// The encounter of two movers by double words, as a number, and whether they were in range.
struct words_of_contact {
    int what;
    bool in_range;
};
// Takes the components of a hit.
template <class Taker, int N>
struct contact_in_words {
    Taker& taken;
    const flight<N, double>&a, &b;
    double mass_a, mass_b;

    template <bool Fused>
    [[nodiscard, gnu::always_inline]] words_of_contact operator()(std::bool_constant<Fused>) const noexcept {
        word_approach<Fused, flight<N, double>> w(a, b);
        const bool is_hit = w.what == static_cast<int>(encounter::hit);
        if (is_hit) {
            w.sharpen_root();
        }
        if (is_hit && w.good && is_usable_mass(mass_a) && is_usable_mass(mass_b)) {
            bound_word_contact<Fused>(w, a, b, mass_a, mass_b, taken);
        }
        return {w.what, w.in_range};
    }
};

} // namespace graze::inline v0_1::detail
