// A discriminant that loses more than it must: h² - a c with the parentheses of c = |Δx|² - R² multiplied out.
#pragma once

#include <graze/formula/quadratic.hpp>
#include <graze/precision/subject.hpp>

struct careless_discriminant {
    static constexpr const char* name = "careless";
    static constexpr auto measures = graze::precision::quantity::discriminant;

    template <int N, graze::number T>
    T operator()(const graze::relative_motion<N, T, T, T>& m) const {
        const T q = graze::squared_norm(m.du), h = graze::dot(m.dx, m.du);
        return h * h - q * graze::squared_norm(m.dx) + q * m.R * m.R;
    }
};
