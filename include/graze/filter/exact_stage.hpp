// The exact stage of any formula: integers wide enough for the inputs.
#pragma once

#include <graze/exact/binary.hpp>
#include <graze/exact/integer.hpp>

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
    // Where the digits of the resulting integers lie.
    constexpr void use(workspace& w) noexcept { length.room = velocity.room = normal.room = &w; }
};

// The width of lifted inputs with the whole range of doubles, from 2^-1074 to 2^1024.
inline constexpr int full_width = 2098;

// Where big integers of formulas of doubles have their digits: room for all terms of a formula with inputs of full
// width.
using exact_workspace = workspace_of<16384>;

// f(motion) with Pair's motion in integers that hold the inputs.
template <class Pair, class Inputs, class F>
[[nodiscard]] constexpr auto with_exact_motion(const Inputs& in, F f) {
    exact_workspace room;
    Inputs here = in;
    here.use(room);
    return f(Pair::template motion<big_integer>(here));
}

} // namespace graze::inline v0_1::detail
