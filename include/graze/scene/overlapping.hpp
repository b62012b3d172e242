// Which parts of a scene are inside each other at the start.
#pragma once

#include <graze/predicate/overlaps_of_numbers.hpp>
#include <graze/predicate/overlaps_of_shapes.hpp>
#include <graze/scene/check_scene.hpp>
#include <graze/scene/close_pairs.hpp>
#include <graze/scene/image_pair.hpp>
#include <graze/scene/numbered_scene.hpp>
#include <graze/scene/scene_pair.hpp>
#include <graze/scene/standing_cells.hpp>

#include <algorithm>
#include <vector>

namespace graze::inline v0_1 {

// The pairs that overlap, exactly: balls with balls, planes, walls and triangles, or with images of these, in this
// order and by their indices. A run resolves those that approach and leaves the others alone; if overlaps are a mistake
// in a scene, this function shows them. For scenes of floats, doubles or an exact type. Throws std::domain_error as
// check does and for parallel edges, and for a scene that has a period what first_events throws.
template <int N, class T>
requires is_binary_input<T> || exact_number<T>
[[nodiscard]] std::vector<scene_pair> overlapping(const scene<N, T>& s) {
    check(s);
    std::vector<scene_pair> found;
    const detail::numbered_scene<N, T> parts(s, detail::numbering::listed);
    const auto look = [&](detail::body a, detail::body b, detail::image_index image) {
        parts.with(a, b, [&](const ball<N, T>& x, const auto& y, const scene_pair& who, unsigned) {
            detail::with_image(x, y, image, s.period, [&](const auto& here, const auto& there) {
                if (overlaps(here, there)) {
                    found.push_back(who);
                }
            });
        });
    };
    const vec<N, double> period = parts.period();
    const auto balls = parts.flights();
    const detail::standing_cells<N> standing(parts.extents(), parts.balls());
    for (detail::body a = 0; a < parts.balls(); ++a) {
        const ball<N, double>& b = balls[a].state;
        const double reach = detail::reach_of(b);
        parts.refuse_far(a, b.position);
        standing.planes_around(b.position, reach, [&](detail::body other) { look(a, other, {}); });
        standing.for_each_image(b.position, reach, period, [&](const auto& from, detail::image_index image) {
            standing.walls_around(from, reach, [&](detail::body other) { look(a, other, image); });
        });
    }
    detail::for_each_close_pair<N>(balls, period, look);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end()); // several images of one
    return found;
}

} // namespace graze::inline v0_1
