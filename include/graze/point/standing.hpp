// Where the planes, walls and triangles of a run are: at which places, and how they look from there.
#pragma once

#include <graze/formula/flat_way.hpp>
#include <graze/point/shift.hpp>
#include <graze/point/standing_images.hpp>
#include <graze/scene/records.hpp>

#include <algorithm>
#include <optional>

namespace graze::inline v0_1::detail {

template <mechanics M>
class standing_parts : public standing_images<M> {
  public:
    static constexpr int dimension = M::dimension;
    using number = typename M::number;
    using exact = typename M::exact;
    using state = typename M::state;
    using shapes = standing_shapes<M>;
    using standing_images<M>::standing_images;
    using exact_shape = typename standing_images<M>::exact_shape;
    using standing_images<M>::exactly;

    // A place, over a positive number.
    struct place {
        vec<dimension, exact> sum;
        exact over;
    };
    // Where the straight way through x along the velocity of u crosses the plane of b; x, if it never does.
    [[nodiscard]] place crossing(const M& m, const standing_image& b, const state& x, const state& u) const {
        return crossing(m, b, place{shapes::exactly(m, x.state.position), exact(1)}, u);
    }
    [[nodiscard]] place crossing(const M& m, const standing_image& b, const place& x, const state& u) const {
        const auto velocity = shapes::exactly(m, u.state.velocity);
        const exact_shape s = exactly(m, b);
        const exact speed = graze::dot(velocity, s.normal);
        const exact height = graze::dot(x.sum - x.over * s.point, s.normal);
        const int sign = graze::sign(speed);
        return sign == 0  ? x
               : sign < 0 ? place{height * velocity - speed * x.sum, -speed * x.over}
                          : place{speed * x.sum - height * velocity, speed * x.over};
    }
    // Whether b, its borders included, contains a place in its plane, or the foot of a place beside its plane.
    [[nodiscard]] bool is_at(const M& m, const standing_image& b, const place& x) const {
        return least_inside(exactly(m, b), x) >= 0;
    }
    [[nodiscard]] bool is_inside(const M& m, const standing_image& b, const place& x) const {
        return least_inside(exactly(m, b), x) > 0;
    }
    [[nodiscard]] bool is_in_plane(const M& m, const standing_image& b, const place& x) const {
        return is_in_plane(exactly(m, b), x);
    }
    // 1 or -1 where b and c are in one plane, as their normals have one sense or not; 0 in two planes.
    [[nodiscard]] int common_sense(const M& m, const standing_image& b, const standing_image& c) const {
        const exact_shape s = exactly(m, b), other = exactly(m, c);
        return graze::sign(exact(graze::squared_norm(graze::cross(s.normal, other.normal)))) == 0 &&
                       is_in_plane(s, {other.point, exact(1)})
                   ? graze::sign(exact(graze::dot(s.normal, other.normal)))
                   : 0;
    }
    // The place in a wall with the nearest coordinates along each edge; beyond the third border of a triangle, that on
    // the way to the corner.
    [[nodiscard]] place nearest(const M& m, const standing_image& b, const place& x) const {
        const exact_shape s = exactly(m, b);
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
    [[nodiscard]] cone<dimension, exact> cone_at(const M& m, const standing_image& b, int side, approach way,
                                                 const std::optional<place>& x) const {
        const exact_shape s = exactly(m, b);
        cone<dimension, exact> result{b, side, way, s.normal, {}, 0};
        if (x && !s.is_plane) {
            const auto seen = seen_from(s, *x);
            for (int k = 0; k < borders_of(dimension, s.is_triangle); ++k) {
                if (inside(k, s, seen) <= 0) {
                    result.inward[static_cast<std::size_t>(result.borders++)] = inward_of(s, k);
                }
            }
        }
        return result;
    }

  private:
    using seen_place = flat_place<dimension, exact>;

    [[nodiscard]] static bool is_in_plane(const exact_shape& s, const place& x) {
        return graze::sign(exact(graze::dot(x.sum - x.over * s.point, s.normal))) == 0;
    }
    // Where a place is along the sides, times n·n.
    [[nodiscard]] static seen_place seen_from(const exact_shape& s, const place& x) {
        return {x.over * graze::squared_norm(s.normal),
                along_sides<dimension, exact>(x.sum - x.over * s.point, s.edges)};
    }
    // On which side of border k a place is: 1 inside, 0 on it.
    [[nodiscard]] static int inside(int k, const exact_shape& s, const seen_place& seen) {
        return graze::sign(inside_border{k, s.is_triangle}(seen));
    }
    // The least of these.
    [[nodiscard]] static int least_inside(const exact_shape& s, const place& x) {
        int least = 1;
        if (!s.is_plane) {
            const auto seen = seen_from(s, x);
            for (int k = 0; k < borders_of(dimension, s.is_triangle); ++k) {
                least = std::min(least, inside(k, s, seen));
            }
        }
        return least;
    }
    // The direction in the face that leads straight away from a border.
    [[nodiscard]] static vec<dimension, exact> inward_of(const exact_shape& s, int k) {
        return make_vec<dimension>([&](int i) {
            auto axis = make_vec<dimension>([&](int j) { return exact(i == j ? 1 : 0); });
            return inwards_of_border<dimension, exact>(k, s.is_triangle, along_sides<dimension, exact>(axis, s.edges));
        });
    }
};

} // namespace graze::inline v0_1::detail
