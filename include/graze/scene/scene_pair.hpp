// The two of an event in a scene.
#pragma once

#include <compare>
#include <cstdint>
#include <string>

namespace graze::inline v0_1 {

// What a ball meets.
enum class partner : std::uint8_t { ball, plane, wall, triangle };

[[nodiscard]] constexpr const char* to_string(partner p) noexcept {
    return p == partner::ball ? "ball" : p == partner::plane ? "plane" : p == partner::wall ? "wall" : "triangle";
}

// A ball, plane, wall or triangle: an index into one of the spans of the scene.
struct participant {
    partner kind = partner::ball;
    int index = 0;

    [[nodiscard]] friend constexpr auto operator<=>(const participant&, const participant&) = default;
};

// Ball `a` and ball, plane, wall or triangle `b`: indices into the spans of the scene.
struct scene_pair {
    partner with = partner::ball;
    int a = 0;
    int b = 0;

    [[nodiscard]] friend constexpr auto operator<=>(const scene_pair&, const scene_pair&) = default;
};

// "ball 3".
[[nodiscard]] inline std::string to_string(const participant& p) {
    return std::string(to_string(p.kind)) + " " + std::to_string(p.index);
}
// "ball 3 and plane 0".
[[nodiscard]] inline std::string to_string(const scene_pair& m) {
    return "ball " + std::to_string(m.a) + " and " + to_string(m.with) + " " + std::to_string(m.b);
}

} // namespace graze::inline v0_1
