// The exact encounter of two balls or two flights.
#pragma once

#include <graze/pair/flight_pair.hpp>
#include <graze/pair/input_check.hpp>
#include <graze/pair/pair.hpp>
#include <graze/pair/stage.hpp>
#include <graze/predicate/filtered_balls.hpp>
#include <graze/predicate/refined_balls.hpp>

#include <concepts>
#include <type_traits>

namespace graze::inline v0_1 {

namespace detail {

template <moving B>
constexpr void check_movers(const B& a, const B& b) {
    check(a, name_of_a<B>);
    check(b, name_of_b<B>);
}

// The inputs of two flights, lifted, in a unit of time of their own.
template <int N, class T>
[[nodiscard]] constexpr timed_inputs<two_balls<N>> lift_flights(const flight<N, T>& a, const flight<N, T>& b) noexcept {
    auto in = lift_timed<two_balls<N>>(packed<two_balls<N>>(a.state, b.state), epochs_of(a, b));
    in.settle(in.unit());
    return in;
}

// The encounter by the signs of exact numbers.
struct exact_encounter {
    template <class M>
    [[nodiscard]] constexpr encounter operator()(const M& m) const {
        const auto h = coefficient_h{}(m);
        const auto c = coefficient_c{}(m);
        return encounter_of([&] { return sign(h); }, [&] { return sign(c); },
                            [&] {
                                return sign(discriminant_halved{}(quadratic{coefficient_a{}(m), h, c}));
                            });
    }
};

// decide(motion) with the exact relative motion, at the later epoch, of two movers. A number that words leave open may
// be seen to be 0 before that. Values are checked.
template <moving B, class F>
[[nodiscard]] constexpr encounter decide_exactly(const B& a, const B& b, const open_number& left, F decide) {
    using P = two_balls<dimension_of<B>>;
    check_movers(a, b);
    if constexpr (is_flight<B>) {
        const auto in = lift_flights(a, b);
        if (left.is_zero(in.pair.length.exponent, in.pair.velocity.exponent)) {
            return left.if_zero();
        }
        return with_exact_flights(in, [&](const auto& pair) { return decide(pair.motion()); });
    } else {
        const auto in = lift_row<P>(packed<P>(a, b));
        return left.is_zero(in.length.unit(), in.velocity.unit()) ? left.if_zero() : with_exact_motion<P>(in, decide);
    }
}

// Whether two movers have equal velocities, for instance none, and so come no closer. Those that do are checked.
template <moving B>
[[nodiscard, gnu::always_inline]] constexpr inline bool rest_together(const B& a, const B& b) {
    if (is_same(state_of(a).velocity, state_of(b).velocity)) [[unlikely]] {
        check_movers(a, b);
        return true;
    }
    return false;
}

// Of movers whose velocities differ.
template <moving B>
[[nodiscard, gnu::noinline]] constexpr encounter classify_exactly(const B& a, const B& b, const open_number& left) {
    return decide_exactly(a, b, left, exact_encounter{});
}

// The encounter of two movers, and the stage that decided it.
struct decided_balls {
    encounter what;
    stage decided_by;
};

// Where the filter is not certain, or was not run.
template <moving B>
[[nodiscard, gnu::noinline]] constexpr decided_balls classify_further(const B& a, const B& b) {
    if (rest_together(a, b)) {
        return {encounter::recede, stage::filter};
    }
    open_number left;
    if constexpr (std::floating_point<number_in<B>>) {
        if (!std::is_constant_evaluated() && plain_radii(state_of(a).radius, state_of(b).radius)) {
            if (const auto r = refine(a, b, left); r.what != undecided) {
                return {static_cast<encounter>(r.what), r.decided_by};
            }
        }
    }
    return {classify_exactly(a, b, left), stage::exact};
}

template <moving B, class Observer>
[[nodiscard, gnu::always_inline]] constexpr inline encounter classify_movers(const B& a, const B& b,
                                                                             Observer&& observer) {
    if (!std::is_constant_evaluated()) [[likely]] {
        if (const auto filtered = filter_movers(a, b); filtered.certain) [[likely]] {
            observer(stage::filter);
            return filtered.what();
        }
    }
    const auto further = classify_further(a, b);
    observer(further.decided_by);
    return further.what;
}

// 32-bit integers as numbers whose widths are part of their types.
template <int N, class T>
[[nodiscard]] constexpr ball<N, integer<32>> as_integers(const ball<N, T>& b) noexcept {
    const auto vector = [](const vec<N, T>& x) { return make_vec<N>([&](int i) { return integer<32>(x[i]); }); };
    return {vector(b.position), vector(b.velocity), integer<32>(b.radius)};
}

} // namespace detail

// The laws of all predicates, for balls, planes and walls. Under these numbers they are proved on hard cases in
// proofs/predicate/laws.cpp and tested on random ones in tests/predicate/laws.hpp. A law of one predicate alone stands
// above it. The answer stays the same
//   1. when the axes are permuted or mirrored;
//   2. when the same things are written in another way: balls exchanged, a normal reversed, a wall's edges exchanged
//      or drawn from the other end;
//   3. when lengths, velocities and normals are each scaled by a power of two, except that times scale;
//   4. in another frame of reference, and elsewhere, if the shifted numbers are exact.
//   5. Times of all pair kinds have one order: of <, == and > exactly one holds, and < is transitive.
//   6. overlap, graze and hit have a time, recede and miss have none; an overlap's time is 0.

// Whether two balls meet, exactly, for every finite input. Throws std::domain_error that names the ball and the field
// when an input is not finite or a radius is negative; in a constant expression such input does not compile. The
// observer is told which stage decided. Eqs. (10) to (12), corrected.
template <int N, class T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard, gnu::always_inline]] constexpr inline encounter classify(const ball<N, T>& a, const ball<N, T>& b,
                                                                      Observer&& observer = {}) {
    if constexpr (std::signed_integral<T> && sizeof(T) == 4) { // one path, no filter: the types hold every value
        if (!detail::plain_radii(a.radius, b.radius)) {
            detail::check_movers(a, b);
        }
        observer(stage::exact);
        return detail::exact_encounter{}(relative_motion_of(detail::as_integers(a), detail::as_integers(b)));
    }
    return detail::classify_movers(a, b, observer);
}

// For flights, encounters mean at t0, the later `since`, what they mean for balls at t = 0. The motion up to t0 is
// exact: nothing is rounded. Laws 1 to 6 hold, with t0 for an overlap's time, and
//   12. flights with the same `since` do what their balls do;
//   13. the answer stays the same when every `since` is shifted by one number, if the sums are exact.

// Whether two flights meet from t0 on, exactly, for every finite input. Throws std::domain_error that names the flight
// and the field when an input is not finite or a radius is negative; in a constant expression such input does not
// compile. The observer is told which stage decided.
template <int N, std::floating_point T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard, gnu::always_inline]] constexpr inline encounter classify(const flight<N, T>& a, const flight<N, T>& b,
                                                                      Observer&& observer = {}) {
    return detail::classify_movers(a, b, observer);
}

} // namespace graze::inline v0_1
