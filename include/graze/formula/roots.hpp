// The smaller root τ of a t² + 2 h t + c, given the square root of a discriminant.
#pragma once

#include <graze/number/traits.hpp>

namespace graze::inline v0_1 {

// The forms. printed: (-b - √(b² - 4ac))/(2a), which cancels near contact. stable: c/(-h + √D), which does not cancel
// for h < 0.
enum class root_form { printed, stable };

// (11)'s root as printed; b = 2h, root = √(b² - 4ac).
struct root_printed {
    template <class A, class B, class S>
    [[nodiscard]] constexpr auto operator()(const A& a, const B& b, const S& root) const {
        return (-b - root) / graze::twice(a);
    }
};

// The same root for h < 0, from c and h with √D, or from 2c and 2h with √(4D).
struct root_stable {
    template <class C, class H, class S>
    [[nodiscard]] constexpr auto operator()(const C& c, const H& h, const S& root) const {
        return c / (root - h);
    }
};

// The double root -h/a, where D = 0.
struct root_of_graze {
    template <class A, class H>
    [[nodiscard]] constexpr auto operator()(const A& a, const H& h) const {
        return -h / a;
    }
};

} // namespace graze::inline v0_1
