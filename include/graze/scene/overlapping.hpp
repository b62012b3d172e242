// Which parts of a scene are inside each other at the start.
#pragma once

#include <graze/predicate/overlaps_of_numbers.hpp>
#include <graze/predicate/overlaps_of_shapes.hpp>
#include <graze/scene/check_scene.hpp>
#include <graze/scene/meeting.hpp>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace graze::inline v0_1 {

namespace detail {

// f(i, j), i < j, for the balls whose shadows on the first axis overlap, all that overlap among them.
template <int N, class T, class F>
void for_each_close_pair(std::span<const ball<N, T>> balls, F f) {
    using number = std::conditional_t<exact_number<T>, T, double>;
    struct shadow {
        number low, high;
        int index;
    };
    std::vector<shadow> shadows;
    shadows.reserve(balls.size());
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const auto x = static_cast<number>(balls[i].position[0]);
        const auto r = static_cast<number>(balls[i].radius);
        number low = x - r, high = x + r;
        if constexpr (!exact_number<T>) {
            const double rounding = 0x1p-50 * ((x < 0 ? -x : x) + r);
            low -= rounding;
            high += rounding;
        }
        shadows.push_back({low, high, static_cast<int>(i)});
    }
    std::sort(shadows.begin(), shadows.end(), [](const shadow& x, const shadow& y) { return x.low < y.low; });
    for (std::size_t i = 0; i < shadows.size(); ++i) {
        for (std::size_t j = i + 1; j < shadows.size() && !(shadows[i].high < shadows[j].low); ++j) {
            f(std::min(shadows[i].index, shadows[j].index), std::max(shadows[i].index, shadows[j].index));
        }
    }
}

} // namespace detail

// The pairs that overlap, exactly: balls with balls, planes, walls and triangles, in this order and by their indices. A
// run resolves those that approach and leaves the others alone; a scene in which they are a mistake is one that this
// shows. Of floats, doubles or an exact type. Throws std::domain_error as check does, and for parallel edges.
template <int N, class T>
requires is_binary_input<T> || exact_number<T>
[[nodiscard]] std::vector<meeting> overlapping(const scene<N, T>& s) {
    check(s);
    std::vector<meeting> found;
    detail::for_each_close_pair(s.balls, [&](int i, int j) {
        if (overlaps(s.balls[static_cast<std::size_t>(i)], s.balls[static_cast<std::size_t>(j)])) {
            found.push_back({partner::ball, i, j});
        }
    });
    std::sort(found.begin(), found.end());
    const auto add = [&](partner with, const auto& pieces) {
        for (std::size_t i = 0; i < s.balls.size(); ++i) {
            for (std::size_t j = 0; j < pieces.size(); ++j) {
                const meeting who{with, static_cast<int>(i), static_cast<int>(j)};
                try {
                    if (overlaps(s.balls[i], pieces[j])) {
                        found.push_back(who);
                    }
                } catch (const std::domain_error& e) {
                    throw std::domain_error(to_string(who) + ": " + e.what());
                }
            }
        }
    };
    add(partner::plane, s.planes);
    add(partner::wall, s.walls);
    if constexpr (N == 3) {
        add(partner::triangle, s.triangles);
    }
    return found;
}

} // namespace graze::inline v0_1
