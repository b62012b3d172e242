// Well-known billiards, as scenes.
#pragma once

#include "scene_text.hpp"

#include <cstdint>
#include <string>

namespace scenes {

// All mirrors that a photon of speed 1 can reach by t = 10: their centres are within 10 + 1/3 of (1/2, 1/10).
[[nodiscard]] inline std::string photon() {
    scene_text scene(2, "photon",
                     "A photon, a point of speed 1, leaves (1/2, 1/10) eastwards among circular mirrors of radius 1/3 "
                     "around the integer lattice points. How far from the origin is it at t = 10? (SIAM 100-Digit "
                     "Challenge, problem 2, Trefethen 2002.)");
    scene.ball("[0.5, 0.1]", "[1, 0]", "0", "");
    for (std::int64_t x = -10; x <= 11; ++x) {
        for (std::int64_t y = -11; y <= 11; ++y) { // in thirtieths
            if ((30 * x - 15) * (30 * x - 15) + (30 * y - 3) * (30 * y - 3) <= 310 * 310) {
                scene.ball(vector_text({x, y}, 0), "[0, 0]", "\"1/3\"", "\"inf\"");
            }
        }
    }
    return scene.text();
}

// A point in a square table with a round obstacle in the middle.
[[nodiscard]] inline std::string sinai() {
    scene_text scene(2, "Sinai billiard",
                     "A point of speed 1 in a square table of side 1 with a circular obstacle of radius 1/4 in the "
                     "middle (Sinai 1970): every bounce off the obstacle spreads neighbouring paths.");
    scene.ball("[0.1, 0.2]", "[\"12/13\", \"5/13\"]", "0", "");
    scene.ball("[0.5, 0.5]", "[0, 0]", "0.25", "\"inf\"");
    scene.plane("[0, 0]", "[1, 0]");
    scene.plane("[1, 0]", "[1, 0]");
    scene.plane("[0, 0]", "[0, 1]");
    scene.plane("[0, 1]", "[0, 1]");
    return scene.text();
}

// Five balls in a row that touch, between two planes that send each ball back, as gravity does in a real cradle.
[[nodiscard]] inline std::string newtons_cradle() {
    scene_text scene(2, "Newton's cradle",
                     "Five equal balls of radius 1/10 that touch in a row, and a sixth that runs into them. Planes at "
                     "both ends stand for gravity, which brings a ball back.");
    scene.ball("[-1.3, 0]", "[1, 0]", "0.1", "");
    for (std::int64_t i = 0; i < 5; ++i) {
        scene.ball(vector_text({2 * i - 4, 0}, 1), "[0, 0]", "0.1", "");
    }
    scene.plane("[-1.5, 0]", "[1, 0]");
    scene.plane("[1.5, 0]", "[1, 0]");
    return scene.text();
}

// A ball at rest between a wall and an incoming ball 100^n times as heavy: the number of collisions is the first n + 1
// digits of π: 3, 31, 314, ... (Galperin 2003).
[[nodiscard]] inline std::string galperin() {
    scene_text scene(2, "Galperin's billiard",
                     "A ball of mass 1 at rest between a wall and a ball of mass 100^2 that comes in: 314 collisions, "
                     "the first digits of pi (Galperin 2003).");
    scene.ball("[1, 0]", "[0, 0]", "0.1", "1");
    scene.ball("[2, 0]", "[-1, 0]", "0.1", "10000");
    scene.plane("[0, 0]", "[1, 0]");
    return scene.text();
}

} // namespace scenes
