// overlaps: whether two things are inside each other, exactly. Flights as well as balls.
#pragma once

#include <graze/pair/mismatch.hpp>
#include <graze/predicate/either_order.hpp>
#include <graze/predicate/overlaps_of_flights.hpp>
#include <graze/predicate/overlaps_of_numbers.hpp>
#include <graze/predicate/overlaps_of_shapes.hpp>

#if defined(GRAZE_COMPILED) && defined(__cpp_exceptions)
#include <graze/predicate/compiled.hpp>
#endif

namespace graze::inline v0_1 {

// One readable error instead of a list of candidates.
template <class A, class B, class... Observer>
requires detail::mismatched<A, B>
constexpr bool overlaps(const A&, const B&, Observer&&...) {
    static_assert(!detail::mismatched<A, B>, "both arguments need the same number type and dimension");
    return {};
}

} // namespace graze::inline v0_1
