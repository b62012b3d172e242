// Where the planes, walls and triangles of a run are: at which places, and how they look from there.
#pragma once

#include <graze/formula/flat_way.hpp>
#include <graze/point/shift.hpp>
#include <graze/point/standing_questions.hpp>

#include <algorithm>
#include <optional>

namespace graze::inline v0_1::detail {

template <int N, class State, class X>
class standing_parts : public standing_questions<N, State, X> {
  public:
    using exact = X;
    using state = State;
    using standing_questions<N, State, X>::standing_questions;
    using standing_questions<N, State, X>::exactly;
    using typename standing_questions<N, State, X>::shape;

    // A place, over a positive number.
    struct place {
        vec<N, exact> sum;
        exact over;
    };
    // Where the straight way through x along the velocity of u crosses the plane of b; x, if it never does.
    [[nodiscard]] place crossing(const standing_image& b, const state& x, const state& u) const {
        return crossing(b, place{exactly(x.state.position), exact(1)}, u);
    }
    [[nodiscard]] place crossing(const standing_image& b, const place& x, const state& u) const {
        const auto velocity = exactly(u.state.velocity);
        const shape s = exactly(b);
        const exact speed = graze::dot(velocity, s.normal);
        const exact height = graze::dot(x.sum - x.over * s.point, s.normal);
        const int sign = graze::sign(speed);
        return sign == 0  ? x
               : sign < 0 ? place{height * velocity - speed * x.sum, -speed * x.over}
                          : place{speed * x.sum - height * velocity, speed * x.over};
    }
    // Whether b, its borders included, contains a place in its plane, or the foot of a place beside its plane.
    [[nodiscard]] bool is_at(const standing_image& b, const place& x) const { return least_inside(exactly(b), x) >= 0; }
    [[nodiscard]] bool is_inside(const standing_image& b, const place& x) const {
        return least_inside(exactly(b), x) > 0;
    }
    [[nodiscard]] bool is_in_plane(const standing_image& b, const place& x) const { return is_in_plane(exactly(b), x); }
    // 1 or -1 where b and c are in one plane, as their normals have one sense or not; 0 in two planes.
    [[nodiscard]] int common_sense(const standing_image& b, const standing_image& c) const {
        const shape s = exactly(b), other = exactly(c);
        return graze::sign(exact(graze::squared_norm(graze::cross(s.normal, other.normal)))) == 0 &&
                       is_in_plane(s, {other.point, exact(1)})
                   ? graze::sign(exact(graze::dot(s.normal, other.normal)))
                   : 0;
    }
    // The place in a wall with the nearest coordinates along each edge; beyond the third border of a triangle, that on
    // the way to the corner.
    [[nodiscard]] place nearest(const standing_image& b, const place& x) const {
        const shape s = exactly(b);
        if (s.is_plane) {
            return x;
        }
        const auto seen = seen_from(s, x);
        auto along = seen.at;
        for (exact& at : along) {
            at = graze::sign(at) < 0 ? exact(0) : at;
        }
        exact length = seen.facing;
        if (s.is_triangle) {
            const exact sum = along.front() + along.back();
            length = graze::sign(exact(sum - length)) > 0 ? sum : length;
        } else {
            for (exact& at : along) {
                at = graze::sign(exact(at - length)) > 0 ? length : at;
            }
        }
        place result{length * s.point, length};
        for (std::size_t i = 0; i < along.size(); ++i) {
            result.sum = result.sum + along[i] * s.edges[i];
        }
        return result;
    }
    // b seen from a place x in b; without x, as from any place inside.
    [[nodiscard]] cone<N, exact> cone_at(const standing_image& b, int side, approach way,
                                         const std::optional<place>& x) const {
        const shape s = exactly(b);
        cone<N, exact> result{b, side, way, s.normal, {}, 0};
        if (x && !s.is_plane) {
            const auto seen = seen_from(s, *x);
            for (int k = 0; k < borders_of(N, s.is_triangle); ++k) {
                if (inside(k, s, seen) <= 0) {
                    result.inward[static_cast<std::size_t>(result.borders++)] = inward_of(s, k);
                }
            }
        }
        return result;
    }

  protected:
    ~standing_parts() = default;

  private:
    using seen_place = flat_place<N, exact>;

    [[nodiscard]] static bool is_in_plane(const shape& s, const place& x) {
        return graze::sign(exact(graze::dot(x.sum - x.over * s.point, s.normal))) == 0;
    }
    // Where a place is along the sides, times n·n.
    [[nodiscard]] static seen_place seen_from(const shape& s, const place& x) {
        return {x.over * graze::squared_norm(s.normal), along_sides<N, exact>(x.sum - x.over * s.point, s.edges)};
    }
    // On which side of border k a place is: 1 inside, 0 on it.
    [[nodiscard]] static int inside(int k, const shape& s, const seen_place& seen) {
        return graze::sign(inside_border{k, s.is_triangle}(seen));
    }
    // The least of these.
    [[nodiscard]] static int least_inside(const shape& s, const place& x) {
        int least = 1;
        if (!s.is_plane) {
            const auto seen = seen_from(s, x);
            for (int k = 0; k < borders_of(N, s.is_triangle); ++k) {
                least = std::min(least, inside(k, s, seen));
            }
        }
        return least;
    }
    // The direction in the face that leads straight away from a border.
    [[nodiscard]] static vec<N, exact> inward_of(const shape& s, int k) {
        return make_vec<N>([&](int i) {
            auto axis = make_vec<N>([&](int j) { return exact(i == j ? 1 : 0); });
            return inwards_of_border<N, exact>(k, s.is_triangle, along_sides<N, exact>(axis, s.edges));
        });
    }
};

} // namespace graze::inline v0_1::detail
