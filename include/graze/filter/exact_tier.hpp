// The exact stage of any formula: integers wide enough for the inputs.
#pragma once

#include <graze/exact/binary.hpp>
#include <graze/exact/sparse_integer.hpp>

namespace graze::inline v0_1::detail {

// The inputs of a pair, lifted to one scale each for lengths, velocities and normals: the formulas are homogeneous in
// each.
template <std::size_t L, std::size_t V, std::size_t E>
struct lifted_inputs {
    lifted<L> length;
    lifted<V> velocity;
    lifted<E> normal;

    [[nodiscard]] constexpr int width() const noexcept {
        const int w = length.width > velocity.width ? length.width : velocity.width;
        return w > normal.width ? w : normal.width;
    }
};

// Widths of the lifted inputs: one limb (then a sum of three squares of differences has two limbs), two limbs, and
// everything that doubles can span, from 2^-1074 to 2^1024.
inline constexpr int one_limb_width = 61;
inline constexpr int two_limb_width = 125;
inline constexpr int full_width = 2098;

// f(motion), with Pair's motion in the narrowest of three integer types that holds the inputs. f is called once and
// must return the same type for each. In a constant expression the widest may exceed a compiler's limit of steps.
template <class Pair, class Inputs, class F>
[[nodiscard]] constexpr auto with_exact_motion(const Inputs& in, F f) {
    const int width = in.width();
    if (width <= one_limb_width) {
        return f(Pair::template motion<integer<one_limb_width>>(in));
    }
    if (width <= two_limb_width) {
        return f(Pair::template motion<integer<two_limb_width>>(in));
    }
    return f(Pair::template motion<sparse_integer<full_width>>(in));
}

} // namespace graze::inline v0_1::detail
