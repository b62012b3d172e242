// classify: the exact encounter of two balls, or of a ball and a plane or a wall. Flights as well as balls.
#pragma once

#include <graze/pair/mismatch.hpp>
#include <graze/predicate/classify_balls.hpp>
#include <graze/predicate/classify_flights.hpp>
#include <graze/predicate/classify_numbers.hpp>
#include <graze/predicate/classify_walls.hpp>
#include <graze/predicate/either_order.hpp>

#if defined(GRAZE_COMPILED) && defined(__cpp_exceptions)
#include <graze/predicate/compiled.hpp>
#endif

namespace graze::inline v0_1 {

// One readable error instead of a list of candidates.
template <class A, class B, class... Observer>
requires detail::mismatched<A, B>
constexpr encounter classify(const A&, const B&, Observer&&...) {
    static_assert(!detail::mismatched<A, B>, "both arguments need the same number type and dimension");
    return {};
}

} // namespace graze::inline v0_1
