// The question to every contestant: does a ball that flies straight touch a thing before the horizon, and when?
#pragma once

#include <graze/shape/ball.hpp>
#include <graze/shape/wall.hpp>

#include <array>
#include <string>
#include <variant>
#include <vector>

namespace peers {

// A box is a solid whose sides are parallel to the axes; an edge, a segment of the plane.
enum class thing { ball, box, edge };

// As graze takes it: a ball, and another one or the walls that bound the thing.
template <int N>
struct scene {
    graze::ball<N> a{}, b{};
    std::vector<graze::wall<N>> walls; // none: b is met
};

// As the libraries take it: the thing stands still in the origin, the ball moves relative to it. The coordinates are
// differences, rounded once to doubles; in the plane the third is 0.
struct question {
    using vector = std::array<double, 3>;
    thing what = thing::ball;
    vector from{}, velocity{};
    double radius = 0; // of the ball that moves
    double other = 0;  // of the other ball
    vector half{};     // of a box: half its sides; of an edge: from its middle to its end
    double horizon = 1;
};

template <int N>
struct scenes {
    std::vector<scene<N>> all;
};

// Questions of one kind, and how hard they are.
struct trial {
    std::string name, description;
    thing what = thing::ball;
    std::variant<scenes<2>, scenes<3>> exactly;
    std::vector<question> questions;
    std::string hardness_name{}; // what the k of the questions means, and the k of each; empty where there is none
    std::vector<int> hardness{};

    [[nodiscard]] bool in_space() const { return exactly.index() == 1; }
};

} // namespace peers
