// QD's double-doubles: conversion from and to exact values.
#pragma once

#include "../reader.hpp"

#include <graze/number/adapter/qd.hpp>

#include <cmath>

namespace compare {

// The double nearest to x, and the double nearest to the rest.
template <>
struct converter<dd_real> {
    [[nodiscard]] static dd_real from(const exact_view& x) {
        const double high = x.nearest();
        return std::isfinite(high) ? dd_real(high, x.nearest_to_rest(high)) : dd_real(high);
    }
};

template <>
struct reader<dd_real> {
    static void read(const dd_real& x, const request& asked) {
        if (std::isfinite(x.x[0]) && std::isfinite(x.x[1])) {
            asked.to.sum(taken_apart(x.x[0]), taken_apart(x.x[1]));
        } else {
            asked.to.not_finite();
        }
    }
};

} // namespace compare
