// Where the planes, walls and triangles of a run are: at which places, and how they look from there.
#pragma once

#include <graze/formula/flat_way.hpp>
#include <graze/point/shift.hpp>
#include <graze/point/standing_images.hpp>

#include <algorithm>
#include <optional>
#include <vector>

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
    using standing_images<M>::with;

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
        const auto n = normal_of(m, b);
        const exact speed = graze::dot(velocity, n);
        const exact height = graze::dot(x.sum - x.over * point_of(m, b), n);
        const int sign = graze::sign(speed);
        return sign == 0  ? x
               : sign < 0 ? place{height * velocity - speed * x.sum, -speed * x.over}
                          : place{speed * x.sum - height * velocity, speed * x.over};
    }
    // Whether b, its borders included, contains a place in its plane, or the foot of a place beside its plane.
    [[nodiscard]] bool is_at(const M& m, const standing_image& b, const place& x) const {
        const auto borders = borders_at(m, b, x);
        return std::all_of(borders.begin(), borders.end(), [](const border& k) { return k.inside >= 0; });
    }
    [[nodiscard]] bool is_inside(const M& m, const standing_image& b, const place& x) const {
        const auto borders = borders_at(m, b, x);
        return std::all_of(borders.begin(), borders.end(), [](const border& k) { return k.inside > 0; });
    }
    [[nodiscard]] bool is_in_plane(const M& m, const standing_image& b, const place& x) const {
        return graze::sign(exact(graze::dot(x.sum - x.over * point_of(m, b), normal_of(m, b)))) == 0;
    }
    // 1 or -1 where b and c are in one plane, as their normals have one sense or not; 0 in two planes.
    [[nodiscard]] int common_sense(const M& m, const standing_image& b, const standing_image& c) const {
        const auto n = normal_of(m, b), other = normal_of(m, c);
        return graze::sign(exact(graze::squared_norm(graze::cross(n, other)))) == 0 &&
                       is_in_plane(m, b, {point_of(m, c), exact(1)})
                   ? graze::sign(exact(graze::dot(n, other)))
                   : 0;
    }
    // The place in a wall with the nearest coordinates along each edge; beyond the third border of a triangle, that on
    // the way to the corner.
    [[nodiscard]] place nearest(const M& m, const standing_image& b, const place& x) const {
        return with(b, [&](const auto& w) -> place {
            if constexpr (requires { w.edge; }) {
                const auto seen = seen_from(m, w, x);
                auto along = seen.at;
                for (exact& at : along) {
                    at = graze::sign(at) < 0 ? exact(0) : at;
                }
                exact length = seen.facing;
                if constexpr (is_triangle<std::remove_cvref_t<decltype(w)>>) {
                    const exact sum = along[0] + along[1];
                    length = graze::sign(exact(sum - length)) > 0 ? sum : length;
                } else {
                    for (exact& at : along) {
                        at = graze::sign(exact(at - length)) > 0 ? length : at;
                    }
                }
                place result{length * shapes::exactly(m, w.corner), length};
                const auto edges = shapes::edges_of(m, w);
                for (std::size_t i = 0; i < along.size(); ++i) {
                    result.sum = result.sum + along[i] * edges[i];
                }
                return result;
            } else {
                return x;
            }
        });
    }
    // b seen from a place x in b; without x, as from any place inside.
    [[nodiscard]] cone<dimension, exact> cone_at(const M& m, const standing_image& b, int side, approach way,
                                                 const std::optional<place>& x) const {
        cone<dimension, exact> result{b, side, way, normal_of(m, b), {}, 0};
        if (x) {
            for (const border& k : borders_at(m, b, *x)) {
                if (k.inside <= 0) {
                    result.inward[static_cast<std::size_t>(result.borders++)] = inward_of(m, b, k.number);
                }
            }
        }
        return result;
    }

  private:
    using standing_images<M>::normal_of;
    using standing_images<M>::point_of;

    // Where a place is along the sides, times n·n.
    template <class W>
    [[nodiscard]] static flat_place<dimension, exact> seen_from(const M& m, const W& w, const place& x) {
        const auto edges = shapes::edges_of(m, w);
        return {x.over * graze::squared_norm(face_normal(edges)),
                along_sides<dimension, exact>(x.sum - x.over * shapes::exactly(m, w.corner), edges)};
    }

    // On which side of a border a place is: 1 inside, 0 on it.
    struct border {
        int number, inside;
    };
    [[nodiscard]] std::vector<border> borders_at(const M& m, const standing_image& b, const place& x) const {
        std::vector<border> result;
        with(b, [&](const auto& w) {
            if constexpr (requires { w.edge; }) {
                constexpr bool triangular = is_triangle<std::remove_cvref_t<decltype(w)>>;
                const auto seen = seen_from(m, w, x);
                for (int k = 0; k < borders_of(dimension, triangular); ++k) {
                    result.push_back({k, graze::sign(inside_border{k, triangular}(seen))});
                }
            }
        });
        return result;
    }
    // The direction in the face that leads straight away from a border.
    [[nodiscard]] vec<dimension, exact> inward_of(const M& m, const standing_image& b, int k) const {
        return with(b, [&](const auto& w) -> vec<dimension, exact> {
            if constexpr (requires { w.edge; }) {
                constexpr bool triangular = is_triangle<std::remove_cvref_t<decltype(w)>>;
                const auto edges = shapes::edges_of(m, w);
                return make_vec<dimension>([&](int i) {
                    auto axis = make_vec<dimension>([&](int j) { return exact(i == j ? 1 : 0); });
                    return inwards_of_border<dimension, exact>(k, triangular,
                                                               along_sides<dimension, exact>(axis, edges));
                });
            } else {
                return shapes::exactly(m, w.normal);
            }
        });
    }
};

} // namespace graze::inline v0_1::detail
