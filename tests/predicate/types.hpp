// The predicates of one input type against the oracle, from small whole numbers to the ends of the type's range.
#pragma once

#include "laws.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <bit>
#include <cstdint>
#include <limits>

namespace types {

// What kind of numbers a pair is of: all of them small whole ones, of any size, or near the ends of the range.
enum class range { small, any, ends };

template <std::signed_integral T>
T number(range from) {
    constexpr T most = std::numeric_limits<T>::max();
    if (from == range::small) {
        return *rc::gen::inRange<T>(-4, 5);
    }
    if (from == range::ends) {
        const T off = *rc::gen::inRange<T>(0, 3);
        return *rc::gen::arbitrary<bool>() ? static_cast<T>(most - off) : static_cast<T>(-most - 1 + off);
    }
    return static_cast<T>(*rc::gen::arbitrary<T>() >> *rc::gen::inRange(0, std::numeric_limits<T>::digits));
}
template <std::floating_point T>
T number(range from) {
    const T small = static_cast<T>(*rc::gen::inRange(-4, 5));
    if (from == range::small) {
        return small;
    }
    if (from == range::ends) {
        return *rc::gen::arbitrary<bool>() ? small * std::numeric_limits<T>::denorm_min()
                                           : small / 4 * std::numeric_limits<T>::max();
    }
    using bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
    const T any = std::bit_cast<T>(*rc::gen::arbitrary<bits>());
    return std::isfinite(any) ? any : small;
}

template <class T>
T radius(range from) {
    const T r = number<T>(from);
    if constexpr (std::signed_integral<T>) {
        return r == std::numeric_limits<T>::min() ? std::numeric_limits<T>::max() : r < 0 ? static_cast<T>(-r) : r;
    } else {
        return r < 0 ? -r : r;
    }
}

template <int N, class T>
graze::vec<N, T> vector(range from) {
    return graze::make_vec<N>([&](int) { return number<T>(from); });
}
template <int N, class T>
graze::ball<N, T> ball(range from) {
    return {vector<N, T>(from), vector<N, T>(from), radius<T>(from)};
}

template <int N, class T>
bool is_zero(const graze::vec<N, T>& x) {
    for (int i = 0; i < N; ++i) {
        if (x[i] != 0) {
            return false;
        }
    }
    return true;
}

// Whether the edges span a wall, found by the oracle.
template <int N, class T>
bool spans(const graze::wall<N, T>& w) {
    oracle::group<T> g;
    for (const auto& e : w.edge) {
        oracle::collect<N>(g, e);
    }
    std::array<oracle::point<N>, N - 1> e;
    for (auto& edge : e) {
        edge = oracle::next<N>(g);
    }
    const mpz_class product = oracle::dot<N>(e.front(), e.back());
    const mpz_class squares = oracle::dot<N>(e.front(), e.front()) * oracle::dot<N>(e.back(), e.back());
    return N == 2 ? squares != 0 : squares != product * product;
}

template <class A, class B>
void check(const A& a, const B& b, bool mirror) {
    const auto answer = answers::of(a, b);
    RC_CLASSIFY(answer.decided_by == graze::stage::exact, "exact");
    RC_ASSERT(answers::is_right(answer, a, b));
    laws::axes(a, b, mirror);
}

// An integer's least value has no negative, so that what may hold it is not mirrored.
template <int N, class T>
void check_all() {
    CHECK(rc::check("two balls", [] {
        const range from = *rc::gen::element(range::small, range::any, range::ends);
        const auto a = ball<N, T>(from);
        const auto b = ball<N, T>(from);
        check(a, b, from == range::small || std::is_floating_point_v<T>);
        laws::presentation(a, b);
    }));
    CHECK(rc::check("a ball and a plane", [] {
        const range from = *rc::gen::element(range::small, range::any, range::ends);
        const graze::plane<N, T> p{vector<N, T>(from), vector<N, T>(from)};
        RC_PRE(!is_zero(p.normal));
        check(ball<N, T>(from), p, from == range::small || std::is_floating_point_v<T>);
    }));
    CHECK(rc::check("a ball and a wall", [] {
        const range from = *rc::gen::element(range::small, range::any, range::ends);
        graze::wall<N, T> w{vector<N, T>(from), {}};
        for (auto& e : w.edge) {
            e = vector<N, T>(from);
        }
        RC_PRE(spans(w));
        const auto a = ball<N, T>(from);
        check(a, w, from == range::small || std::is_floating_point_v<T>);
        laws::presentation(a, w);
    }));
}

} // namespace types
