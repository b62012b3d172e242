// The question to every contestant: does a ball that flies straight touch a thing before the horizon, and when?
#pragma once

#include <graze/shape/ball.hpp>
#include <graze/shape/wall.hpp>

#include <array>
#include <string>
#include <variant>
#include <vector>

namespace peers {

// A box is a solid with sides parallel to the axes; an edge is a segment of the plane.
enum class thing { ball, box, edge };

// In graze's form: a ball, and another ball or the walls that bound the thing.
template <int N>
struct scene {
    graze::ball<N> a{}, b{};
    std::vector<graze::wall<N>> walls; // if empty, the other thing is b
};

// In the libraries' form: the thing rests at the origin, and the ball moves relative to it. The coordinates are
// differences, rounded once to doubles; in the plane the third is 0.
struct question {
    using vector = std::array<double, 3>;
    thing what = thing::ball;
    vector from{}, velocity{};
    double radius = 0; // of the moving ball
    double other = 0;  // of the other ball
    vector half{};     // for a box, half its sides; for an edge, the vector from its middle to its end
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
    std::string hardness_name{}; // what the questions' k means, and each question's k; empty if there is none
    std::vector<int> hardness{};

    [[nodiscard]] bool in_space() const { return exactly.index() == 1; }
};

} // namespace peers
