// collide: the contact of a pair, every number correctly rounded. Flights as well as balls.
#pragma once

#include <graze/contact/collide_balls.hpp>
#include <graze/contact/collide_flights.hpp>
#include <graze/contact/collide_walls.hpp>
#include <graze/pair/mismatch.hpp>
#include <graze/predicate/either_order.hpp>

#if defined(GRAZE_COMPILED) && defined(__cpp_exceptions)
#include <graze/contact/compiled.hpp>
#include <graze/predicate/compiled.hpp>
#include <graze/time/compiled.hpp>
#endif

namespace graze::inline v0_1 {

// One readable error instead of a list of candidates.
template <class A, class B, class... Observer>
requires detail::mismatched<A, B>
constexpr void collide(const A&, const B&, Observer&&...) {
    static_assert(!detail::mismatched<A, B>, "both arguments need the same number type and dimension");
}

} // namespace graze::inline v0_1
