// Which parts of a scene are inside each other at the start.
#pragma once

#include <graze/predicate/overlaps_of_numbers.hpp>
#include <graze/predicate/overlaps_of_shapes.hpp>
#include <graze/scene/check_scene.hpp>
#include <graze/scene/close_pairs.hpp>
#include <graze/scene/numbered_scene.hpp>
#include <graze/scene/scene_pair.hpp>
#include <graze/scene/standing_cells.hpp>

#include <algorithm>
#include <vector>

namespace graze::inline v0_1 {

// The pairs that overlap, exactly: balls with balls, planes, walls and triangles, in this order and by their indices. A
// run resolves those that approach and leaves the others alone; if overlaps are a mistake in a scene, this function
// shows them. For scenes of floats, doubles or an exact type. Throws std::domain_error as check does, for a scene that
// has a period, and for parallel edges.
template <int N, class T>
requires is_binary_input<T> || exact_number<T>
[[nodiscard]] std::vector<scene_pair> overlapping(const scene<N, T>& s) {
    check(s);
    detail::refuse_period(s, "overlapping");
    std::vector<scene_pair> found;
    const detail::numbered_scene<N, T> parts(s, detail::numbering::listed);
    const auto look = [&](detail::body a, detail::body b) {
        parts.with(a, b, [&](const ball<N, T>& x, const auto& y, const scene_pair& who, unsigned) {
            if (overlaps(x, y)) {
                found.push_back(who);
            }
        });
    };
    const std::vector<flight<N, double>> balls = parts.flights();
    detail::for_each_close_pair<N>(balls, look);
    const detail::standing_cells<N> standing(parts.extents(), parts.balls());
    for (detail::body a = 0; a < parts.balls(); ++a) {
        const ball<N, double>& b = balls[a].state;
        const double reach = detail::reach_of(b);
        const auto look_at = [&](detail::body other) { look(a, other); };
        standing.planes_around(b.position, reach, look_at);
        standing.walls_around(b.position, reach, look_at);
    }
    std::sort(found.begin(), found.end());
    return found;
}

} // namespace graze::inline v0_1
