// Whole numbers in a machine word as a number type, for proofs over many small cases. A constant expression that
// overflows does not compile.
#pragma once

#include <graze/number/traits.hpp>

#include <cstdint>

namespace proof {

struct whole {
    std::int64_t value = 0;
    constexpr whole() = default;
    constexpr whole(int v) : value(v) {}
    static constexpr whole of(std::int64_t v) {
        whole w;
        w.value = v;
        return w;
    }
    constexpr whole operator-() const { return of(-value); }
    friend constexpr whole operator+(whole x, whole y) { return of(x.value + y.value); }
    friend constexpr whole operator-(whole x, whole y) { return of(x.value - y.value); }
    friend constexpr whole operator*(whole x, whole y) { return of(x.value * y.value); }
    friend constexpr bool operator<(whole x, whole y) { return x.value < y.value; }
};

} // namespace proof

template <>
struct graze::number_traits<proof::whole> {
    static constexpr const char* name = "whole";
    static constexpr bool is_exact = true;
    static constexpr int digits = 0;
};
