// time_of_impact: the exact time at which two things touch first. Flights as well as balls.
#pragma once

#include <graze/pair/mismatch.hpp>
#include <graze/predicate/either_order.hpp>
#include <graze/time/time_of_flights.hpp>
#include <graze/time/time_of_shapes.hpp>
#include <graze/time/time_of_walls.hpp>

#if defined(GRAZE_COMPILED) && defined(__cpp_exceptions)
#include <graze/predicate/compiled.hpp>
#include <graze/time/compiled.hpp>
#endif

namespace graze::inline v0_1 {

// One readable error instead of a list of candidates.
template <class A, class B, class... Observer>
requires detail::mismatched<A, B>
constexpr void time_of_impact(const A&, const B&, Observer&&...) {
    static_assert(!detail::mismatched<A, B>, "both arguments need the same number type and dimension");
}

} // namespace graze::inline v0_1
