// The precision regression for the 32.32 fixed point of examples/fixed_point.hpp, and for graze's decisions on its
// numbers.
#pragma once

#include "../../../examples/fixed_point.hpp"

#include <graze/precision/subject.hpp>
#include <graze/predicate/classify_balls.hpp>

// Converted from double as in the example. What does not fit, such as an infinite mass, is no number of this type.
template <>
struct graze::precision::number_access<fixed_point> {
    static fixed_point from(double x) {
        if (!(x > -0x1p31 && x < 0x1p31)) {
            throw std::overflow_error("beyond 2^31");
        }
        return fixed_point(x);
    }
    // 63 bits in two doubles.
    static reading read(fixed_point x) {
        const std::int64_t low = x.raw() % (std::int64_t{1} << 32);
        return {{static_cast<double>(x.raw() - low) * 0x1p-32, static_cast<double>(low) * 0x1p-32}, 0};
    }
};

// Two balls of fixed-point numbers are two balls of integers, which classify decides exactly.
struct decision_on_the_grid {
    static constexpr const char* name = "classify";
    static constexpr auto measures = graze::precision::quantity::encounter;
    static constexpr bool correctly_rounded = true;

    template <int N>
    graze::precision::answer operator()(const graze::ball<N, fixed_point>& a,
                                        const graze::ball<N, fixed_point>& b) const {
        return graze::precision::answered(graze::classify(steps(a), steps(b)));
    }

  private:
    template <int N>
    static graze::ball<N, std::int64_t> steps(const graze::ball<N, fixed_point>& b) {
        const auto raw = [](const graze::vec<N, fixed_point>& x) {
            return graze::make_vec<N>([&](int i) { return x[i].raw(); });
        };
        return {raw(b.position), raw(b.velocity), b.radius.raw(), 1};
    }
};
