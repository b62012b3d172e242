// The earliest event of a scene, exactly.
#pragma once

#include <graze/scene/canonical_order.hpp>
#include <graze/scene/check_scene.hpp>
#include <graze/scene/inner_edges.hpp>
#include <graze/scene/meeting.hpp>
#include <graze/time/time_of_shapes.hpp>
#include <graze/time/time_of_walls.hpp>

#include <optional>
#include <stdexcept>
#include <vector>

namespace graze::inline v0_1 {

// Who meets at that time, in an order that depends on the scene's numbers alone, and of two balls the one first that
// comes first by its numbers; empty, as the time is, if nothing ever meets.
template <int N, class T = double>
struct first_meetings {
    std::optional<impact_time<N, T>> time;
    std::vector<meeting> events;
};

// All that happens at exactly the earliest time, or only the first of it in that order.
enum class simultaneous { all, first };

namespace detail {

template <int N, class T>
class earliest_meetings {
  public:
    explicit earliest_meetings(simultaneous wanted) : wanted_(wanted) {}

    void meet(const std::optional<impact_time<N, T>>& time, const meeting& who) {
        if (!time) {
            return;
        }
        const int order = found_.time ? time->compare(*found_.time) : -1;
        if (order < 0) {
            found_.time = time;
            found_.events.clear();
        }
        if (order < 0 || (order == 0 && wanted_ == simultaneous::all)) {
            found_.events.push_back(who);
        }
    }
    [[nodiscard]] first_meetings<N, T> take() { return std::move(found_); }

  private:
    first_meetings<N, T> found_;
    simultaneous wanted_;
};

} // namespace detail

// Looks at every pair, balls with balls, planes, walls and triangles, by time_of_impact: exact for every finite input.
// Two balls that overlap and approach meet at 0. Throws std::domain_error that names the part at fault ("ball 17:
// radius is negative") as check does, and for parallel edges ("ball 0 and wall 3: wall: edges are parallel").
template <int N, std::floating_point T>
requires is_binary_input<T>
[[nodiscard]] first_meetings<N, T> first_events(const scene<N, T>& s, simultaneous wanted = simultaneous::all) {
    check(s);
    detail::earliest_meetings<N, T> earliest(wanted);
    const auto at = [](const auto& pieces, int i) -> const auto& { return pieces[static_cast<std::size_t>(i)]; };
    const std::vector<int> balls = detail::canonical_order(s.balls);
    const std::vector<int> planes = detail::canonical_order(s.planes);
    const std::vector<int> walls = detail::canonical_order(s.walls);
    [[maybe_unused]] const auto marks = detail::inner_edges_of(s);
    [[maybe_unused]] const std::vector<int> triangles = detail::canonical_order(detail::triangles_of(s), marks);
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const ball<N, T>& a = at(s.balls, balls[i]);
        for (std::size_t j = i + 1; j < balls.size(); ++j) {
            earliest.meet(time_of_impact(a, at(s.balls, balls[j])), {partner::ball, balls[i], balls[j]});
        }
        for (const int p : planes) {
            earliest.meet(time_of_impact(a, at(s.planes, p)), {partner::plane, balls[i], p});
        }
        const auto meet = [&](const auto& piece, partner kind, int index, unsigned inner) {
            const meeting who{kind, balls[i], index};
            try {
                if (inner == 0 || !detail::is_inner(classify_feature(a, piece), inner)) {
                    earliest.meet(time_of_impact(a, piece), who);
                }
            } catch (const std::domain_error& e) { // parallel edges
                throw std::domain_error(to_string(who) + ": " + e.what());
            }
        };
        for (const int w : walls) {
            meet(at(s.walls, w), partner::wall, w, 0);
        }
        if constexpr (N == 3) {
            for (const int t : triangles) {
                meet(at(s.triangles, t), partner::triangle, t, marks.empty() ? 0U : unsigned{at(marks, t)});
            }
        }
    }
    return earliest.take();
}

} // namespace graze::inline v0_1
