// The predicates of one input type, compared with the oracle: from small whole numbers to the ends of the type's range
// and, occasionally, bad input.
#pragma once

#include "../property.hpp"
#include "faults.hpp"
#include "laws.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <limits>

namespace types {

// The kind of numbers in a pair: small whole numbers only, any size, or near the ends of the range.
enum class range { small, any, ends };

template <std::signed_integral T>
T number(range from) {
    constexpr T most = std::numeric_limits<T>::max();
    if (from == range::small) {
        return property::in_range<T>(-4, 5);
    }
    if (from == range::ends) {
        const T off = property::in_range<T>(0, 3);
        return property::any<bool>() ? static_cast<T>(most - off) : static_cast<T>(-most - 1 + off);
    }
    return static_cast<T>(property::any<T>() >> property::in_range(0, std::numeric_limits<T>::digits));
}
template <std::floating_point T>
T number(range from) {
    const T small = static_cast<T>(property::in_range(-4, 5));
    if (from == range::small) {
        return small;
    }
    if (from == range::ends) {
        return property::any<bool>() ? small * std::numeric_limits<T>::denorm_min()
                                     : small / 4 * std::numeric_limits<T>::max();
    }
    using bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
    return std::bit_cast<T>(property::any<bits>()); // may be an infinity or a NaN
}

// One in 32 is negative.
template <class T>
T radius(range from) {
    const T r = number<T>(from);
    if (r >= 0 || property::in_range(0, 16) == 0) {
        return r;
    }
    return r == std::numeric_limits<T>::lowest() ? std::numeric_limits<T>::max() : static_cast<T>(-r);
}

template <int N, class T>
graze::vec<N, T> vector(range from) {
    return graze::make_vec<N>([&](int) { return number<T>(from); });
}
template <int N, class T>
graze::ball<N, T> ball(range from) {
    return {vector<N, T>(from), vector<N, T>(from), radius<T>(from)};
}

template <class A, class B>
void check(const A& a, const B& b, range from) {
    using T = decltype(a.radius);
    auto decided_by = graze::stage::filter;
    const faults::list bad = faults::of(a, b);
    property::tag_if(!bad.empty(), "bad");
    if (!bad.empty()) {
        PROPERTY_ASSERT(faults::told(bad, [&] { (void)answers::encounter_of(a, b, decided_by); }));
        PROPERTY_ASSERT(faults::told(bad, [&] { (void)answers::overlap_of(a, b, decided_by); }));
        PROPERTY_ASSERT(faults::told(bad, [&] { (void)answers::time_of(a, b); }));
        return;
    }
    const auto answer = answers::of(a, b);
    property::tag_if(answer.decided_by == graze::stage::exact, "exact");
    PROPERTY_ASSERT(answers::is_right(answer, a, b));
    // An integer's least value cannot be negated, so pairs that may contain it are not mirrored.
    const bool mirror = from == range::small || std::is_floating_point_v<T>;
    laws::axes(a, b, mirror);
    if constexpr (!std::is_same_v<B, graze::plane<sizeof(a.position) / sizeof(T), T>>) {
        laws::presentation(a, b);
    }
}

template <int N, class T>
void check_all() {
    const auto any_range = [] { return property::one_of(range::small, range::any, range::ends); };
    CHECK(property::check("two balls", [=] {
        const range from = any_range();
        const auto a = ball<N, T>(from);
        check(a, ball<N, T>(from), from);
    }));
    CHECK(property::check("a ball and a plane", [=] {
        const range from = any_range();
        const auto a = ball<N, T>(from);
        const auto point = vector<N, T>(from);
        check(a, graze::plane<N, T>{point, vector<N, T>(from)}, from);
    }));
    CHECK(property::check("a ball and a wall", [=] {
        const range from = any_range();
        const auto a = ball<N, T>(from);
        graze::wall<N, T> w{vector<N, T>(from), {}};
        for (auto& e : w.edge) {
            e = vector<N, T>(from);
        }
        check(a, w, from);
    }));
}

} // namespace types
