// The contact of a flight and an image of another one, in a space with periods.
#pragma once

#include <graze/contact/collide_balls.hpp>
#include <graze/pair/stand_in.hpp>

#include <array>
#include <cstdint>
#include <optional>

namespace graze::inline v0_1::detail {

inline constexpr component_set position_components =
    three_from(contact_component::position_a) | three_from(contact_component::position_b);

// The real positions of two flights when their stand-ins hit, at about `time` from their start. False if nothing is
// known.
template <int N, class T>
struct position_step {
    rounded_components<N, T>& taken;
    const flight<N, T>&a, &b;
    const stand_ins<N, T>& pair;
    double time;

    template <bool Fused>
    [[nodiscard, gnu::always_inline]] bool operator()(std::bool_constant<Fused>) const noexcept {
        const lane_movers f = lane_movers_of<Fused>(pair.a, pair.b);
        const auto r = approach_near<Fused, N>(f.motion, time, f.length2);
        if (!(r.good && r.sharp)) {
            return false;
        }
        bound_positions(a, b, time_since(f.before_a, r), time_since(f.before_b, r), r.error, taken);
        return true;
    }
};

// Fills in the positions of which doubles are certain; returns the others.
template <int N, class T>
[[nodiscard, gnu::noinline]] component_set positions_in_doubles(contact<N, T>& c, const flight<N, T>& a,
                                                                const flight<N, T>& b,
                                                                const stand_ins<N, T>& pair) noexcept {
    constexpr component_set wanted = position_components & every_part<N>;
    if constexpr (has_error_free_doubles) {
        if (rounds_to_nearest() && has_usual_size(pair.a, pair.b) && has_usual_size(a, b)) {
            if (const auto f = start_filter(pair.a, pair.b).finish(); f.certain && f.what() == encounter::hit) {
                rounded_components<N, T> taken{c};
                const double time = root_stable{}(f.c, f.h, std::sqrt(f.discriminant));
                if (with_best_products(position_step<N, T>{taken, a, b, pair, time})) {
                    return wanted & ~taken.certain;
                }
            }
        }
    }
    return wanted;
}

// Rounds the positions that are wanted, by integers.
template <int N, class T>
[[gnu::noinline]] void round_positions(contact<N, T>& c, component_set wanted, encounter what, const flight<N, T>& a,
                                       const flight<N, T>& b, const image_shift<N, T>& image) {
    timed_workspace room;
    auto in = lift_timed<two_balls<N>>(packed<two_balls<N>>(a.state, b.state), std::array<T, 2>{a.since, b.since});
    lifted<N> lengths;
    lift(lengths, image.period.component);
    const int unit = std::min(in.unit(), lengths.exponent - in.pair.velocity.exponent);
    in.settle(unit);
    lower(lengths, unit + in.pair.velocity.exponent);
    in.use(room);
    lengths.room = &room;
    const scales units{in.pair.length.exponent, in.pair.velocity.exponent, &room};
    const auto pair = flights_in<N>(in);
    auto displaced = pair;
    for (int i = 0; i < N; ++i) {
        const auto k = static_cast<std::size_t>(i);
        if (image.periods[k] != 0) {
            displaced.b.state.position[i] =
                displaced.b.state.position[i] +
                big_integer::from_shifted(room, image.periods[k], 0) * lengths.template get<big_integer>(k);
        }
    }
    const auto position_a = pair.position(pair.a);
    const auto position_b = pair.position(pair.b);
    if (what == encounter::overlap) {
        round_centres(c, wanted, position_a, position_b, units);
        return;
    }
    const big_integer no_masses[2] = {1, 1};
    round_movers(c, wanted, what, pair, displaced.motion(), position_a, position_b, no_masses, units,
                 from_earlier<big_integer>{pair.start()});
}

// The contact of a and an image of b that is some periods away, every component correctly rounded. Each position is
// that of the ball itself, not of an image.
template <int N, class T>
[[nodiscard]] std::optional<contact<N, T>> collide_image(const flight<N, T>& a, const flight<N, T>& b,
                                                         const image_shift<N, T>& image) {
    const stand_ins<N, T> pair(a, b, image);
    auto c = collide(pair.a, pair.b);
    if (c) {
        if (const component_set wanted = positions_in_doubles(*c, a, b, pair); wanted != 0) {
            round_positions(*c, wanted, classify(pair.a, pair.b), a, b, image);
        }
    }
    return c;
}

} // namespace graze::inline v0_1::detail
