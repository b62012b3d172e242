// Families of hard pairs, as doubles: what collision code gets wrong, by the cause.
//
// Only integers are random, so that a seed gives the same pairs on every platform, with any rounding mode and any
// compiler flag. Needs the standard library and graze's shapes alone.
#pragma once

#include <graze/shape/ball.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/wall.hpp>

#include <cstdint>
#include <string_view>

namespace families {

enum class pair_kind { ball_ball, ball_plane, ball_wall };

// a and, by kind, b, plane or wall. An infinite mass is an infinity. hardness: the family's k, or -1.
template <int N>
struct pair_of_doubles {
    pair_kind kind = pair_kind::ball_ball;
    graze::ball<N, double> a{}, b{};
    graze::plane<N, double> plane{};
    graze::wall<N, double> wall{};
    int hardness = -1;
};

} // namespace families
