// The contact of two balls in double words: where doubles leave components in doubt, or leave open whether they meet.
//
// y = Δx + Δu τ comes from its parts across Δu and along it (separation_at_contact), which do not cancel for balls from
// far away; √D is the speed at which they close times R. In the plane and in space, with any lengths and velocities.
#pragma once

#include <graze/contact/bounded_components.hpp>
#include <graze/contact/bounded_impact.hpp>
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

// Where both balls are; each from its own time, or from where the other is and y if that is known better.
template <bool Fused, int N, class F>
[[gnu::always_inline]] inline void bound_positions(const ball<N, double>& a, const ball<N, double>& b,
                                                   const bounded<double>& time, const vec<N, loose_word<Fused>>& y,
                                                   double y_error, F& take) noexcept {
    const auto t0 = as_factor<Fused>(time.high);
    const auto by_itself = [&](double x, double u) __attribute__((always_inline)) {
        const auto p = position_in_parts(x, u, t0, time.low);
        return bounded<double>{p.value, p.error, 0x1p-104 * absolute(x) + 1.25 * absolute(u) * time.error};
    };
    const auto by_other = [&](const bounded<double>& x, double high, double low) __attribute__((always_inline)) {
        const auto sum = two_sum(x.high, high);
        return bounded<double>{sum.value, settled(sum.error + (x.low + low)),
                               x.error + y_error + 0x1p-102 * (absolute(x.high) + absolute(high))};
    };
    for (int i = 0; i < N; ++i) {
        const auto p = by_itself(a.position[i], a.velocity[i]);
        const auto q = by_itself(b.position[i], b.velocity[i]);
        const auto p_from_q = by_other(q, y[i].high, y[i].low);
        const auto q_from_p = by_other(p, -y[i].high, -y[i].low);
        auto first = p_from_q.error < p.error ? p_from_q : p;
        auto second = q_from_p.error < q.error ? q_from_p : q;
        first.error += underflow;
        second.error += underflow;
        take(first, 1 + i);
        take(second, 4 + i);
    }
}

// Of a hit.
template <bool Fused, int N, class F>
[[gnu::always_inline]] inline void bound_word_contact(const word_approach<Fused, N>& w, const ball<N, double>& a,
                                                      const ball<N, double>& b, double mass_a, double mass_b,
                                                      F& take) noexcept {
    using word = loose_word<Fused>;
    const bounded<double> time{w.time.high, w.time.low, (1 + 0x1p-40) * w.time_error};
    take(time, 0);

    const word ordered_a = w.a.in_order();
    const auto inverse = inverse_of<Fused>(exact_pair<double>{ordered_a.high, ordered_a.low});
    const word per_a(inverse.high.value, inverse.low);
    const word along = w.root * per_a;
    double cross_size = 0;
    const auto y_loose = [&] {
        if constexpr (N == 2) {
            const word across = w.cross.value * per_a;
            cross_size = std::fabs(across.high);
            return separation_at_contact(w.motion.du, across, along);
        } else {
            const vec<3, word> across = make_vec<3>([&](int i) { return w.cross.value[i] * per_a; });
            cross_size = (std::fabs(across[0].high) + std::fabs(across[1].high)) + std::fabs(across[2].high);
            return separation_at_contact(w.motion.du, across, along);
        }
    }();
    const auto y = make_vec<N>([&](int i) { return word(two_sum(y_loose[i].high, y_loose[i].low)); });
    double speed = 0;
    for (int i = 0; i < N; ++i) {
        speed += std::fabs(w.motion.du[i].high);
    }
    constexpr double relative = 1.0001 * (separation_bounds<N>::of_y + separation_bounds<N>::of_a);
    const double y_error =
        speed * (relative * (cross_size + along.high) + 1.0001 * (w.cross.error + w.root_error) * inverse.high.value);
    bound_positions<Fused>(a, b, time, y, y_error, take);

    const lane_motion unused{};
    const lanes zero{0, 0};
    const lane_displacement<Fused> y01{as_factor<Fused>(lanes{y[0].high, y[1].high}), lanes{y[0].low, y[1].low},
                                       as_factor<Fused>(zero)};
    const lane_displacement<Fused> y2{as_factor<Fused>(N == 3 ? lanes{0, y[N - 1].high} : zero),
                                      N == 3 ? lanes{0, y[N - 1].low} : zero, as_factor<Fused>(zero)};
    const lane_contact<Fused> contact{unused, y01, y2, y01.low, y2.low, {w.motion.R.high, w.motion.R.low}};
    const word s = w.root.in_order();
    bound_impact(a, b, mass_a, mass_b, contact, exact_pair<double>{s.high, s.low},
                 1.0001 * y_error / w.motion.R.high + 0x1p-100, 1.0001 * w.root_error / s.high + 0x1p-98, take);
}

// What becomes of two balls, and the bounded components of their contact.
template <int N>
struct contact_in_words {
    struct answer {
        int what;
        bool in_range;
    };
    bounded_components& found;
    const ball<N, double>&a, &b;
    double mass_a, mass_b;

    template <bool Fused>
    [[nodiscard, gnu::always_inline]] answer operator()(std::bool_constant<Fused>) const noexcept {
        const word_approach<Fused, N> w(a, b);
        if (w.what == static_cast<int>(encounter::hit)) {
            if (w.good && is_usable_mass(mass_a) && is_usable_mass(mass_b)) {
                bound_word_contact<Fused>(w, a, b, mass_a, mass_b, found);
            }
        } else if (w.what == static_cast<int>(encounter::overlap)) {
            (void)bound_overlap<Fused>(a, b, mass_a, mass_b, found);
        }
        return {w.what, w.in_range};
    }
};

// What becomes of two balls, `undecided` where words leave that open; of a hit, and of an overlap that is no matter of
// time and positions, the components that are known, in units of 2^length and 2^velocity.
struct further_contact {
    int what = undecided;
    int length = 0, velocity = 0;
    bounded_components components;
};

// Of balls whose radii are not negative.
template <int N>
[[gnu::noinline]] void find_further_contact(further_contact& r, const ball<N, double>& a, const ball<N, double>& b,
                                            double mass_a, double mass_b) noexcept {
    if constexpr (has_error_free_doubles) {
        if (rounds_to_nearest()) {
            const ball<N, double>* x = &a;
            const ball<N, double>* y = &b;
            scaled_balls<N> s;
            for (bool usual = has_usual_size(a, b);; usual = false) {
                if (!usual) {
                    s = scaled(a, b);
                    if (!s.known) {
                        return;
                    }
                    x = &s.a;
                    y = &s.b;
                }
                const auto answer = with_best_products(contact_in_words<N>{r.components, *x, *y, mass_a, mass_b});
                if (answer.in_range || !usual) {
                    r.what = answer.what;
                    r.length = s.length;
                    r.velocity = s.velocity;
                    return;
                }
            }
        }
    }
}

} // namespace graze::inline v0_1::detail
