// QD's double-doubles: conversion from and to exact values.
#pragma once

#include "../reader.hpp"

#include <graze/number/adapter/qd.hpp>

namespace compare {

// The nearest double, and the nearest to what is left.
template <>
struct converter<dd_real> {
    [[nodiscard]] static dd_real from(const exact& x) {
        const double high = nearest_double(x);
        return std::isfinite(high) ? dd_real(high, nearest_double(exact(x - exact_of(high)))) : dd_real(high);
    }
};

template <>
struct reader<dd_real> {
    [[nodiscard]] static computed read(const dd_real& x, const true_value&) {
        const bool finite = std::isfinite(x.x[0]) && std::isfinite(x.x[1]);
        return finite ? computed(wide(wide_of(x.x[0]) + wide_of(x.x[1]))) : computed(not_finite{});
    }
};

} // namespace compare
