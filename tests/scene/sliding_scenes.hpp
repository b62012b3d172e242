// A point that comes to slide above a floor.
#pragma once

#include "point_scenes.hpp"

// Off a wall through the origin a point turns to slide above a floor that comes after it, in one piece or more, to
// where another wall crosses that floor, or hangs from it; also mirrored, and with the walls turned round, which
// changes their canonical order. Wall 0 is the first, wall 1 the one at the end.
[[nodiscard]] inline std::vector<point_scene<2>> sliding_scenes() {
    std::vector<point_scene<2>> result;
    for (const double mirror : {1.0, -1.0}) {
        for (const bool turned : {false, true}) {
            const auto wall = [&](double x, double y, double to_x, double to_y) {
                const graze::vec<2, double> from{{mirror * x, y}}, to{{mirror * to_x, to_y}};
                return turned ? graze::wall<2>{to, {{from - to}}} : graze::wall<2>{from, {{to - from}}};
            };
            const std::vector<std::vector<graze::wall<2>>> floors{
                {wall(0, 0, 6, 0)},
                {wall(0, 0, 1, 0), wall(1, 0, 6, 0)},
                {wall(0, 0, 1, 0), wall(2, 0, 6, 0)},
                {wall(0, 0, 2, 0), wall(1, 0, 4, 0), wall(4, 0, 6, 0)}};
            for (const auto& end : {wall(2, 1, 4, -1), wall(3, 0, 4, -1)}) {
                for (const auto& floor : floors) {
                    point_scene<2> s{{{{{0, 2}}, {{0, -1}}, 0, 1}}, {wall(-1.5, 1.5, 0.5, -0.5), end}};
                    s.walls.insert(s.walls.end(), floor.begin(), floor.end());
                    result.push_back(s);
                }
            }
        }
    }
    return result;
}

// In space, as it is in the plane across an axis.
[[nodiscard]] inline point_scene<3> raised(const point_scene<2>& s) {
    const auto in_space = [](const graze::vec<2, double>& x, double z) {
        return graze::vec<3, double>{{x[0], x[1], z}};
    };
    point_scene<3> result{{{in_space(s.point[0].position, 0.25), in_space(s.point[0].velocity, 0), 0, 1}}, {}};
    for (const auto& w : s.walls) {
        result.walls.push_back({in_space(w.corner, 0), {{in_space(w.edge[0], 0), {{0, 0, 1}}}}});
    }
    return result;
}
