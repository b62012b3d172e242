// The planes and walls of a run.
#pragma once

#include <graze/formula/plane_crossing.hpp>
#include <graze/scene/body.hpp>
#include <graze/scene/canonical_order.hpp>
#include <graze/scene/mechanics.hpp>
#include <graze/scene/meeting.hpp>
#include <graze/scene/scene.hpp>
#include <graze/scene/shift.hpp>
#include <graze/scene/standing_cells.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace graze::inline v0_1::detail {

// Parts of a scene in their canonical order.
template <class Part>
[[nodiscard]] std::vector<Part> sorted(std::span<const Part> pieces, const std::vector<int>& order) {
    std::vector<Part> result;
    result.reserve(order.size());
    for (const int i : order) {
        result.push_back(pieces[static_cast<std::size_t>(i)]);
    }
    return result;
}

// Planes, then walls, each in canonical order, numbered as bodies from `first` on.
template <mechanics M>
class standing_parts {
  public:
    static constexpr int dimension = M::dimension;
    using number = typename M::number;
    using exact = typename M::exact;
    using state = typename M::state;

    standing_parts(const scene<dimension, number>& s, body first)
        : plane_names_(canonical_order(s.planes)), wall_names_(canonical_order(s.walls)),
          planes_(sorted(s.planes, plane_names_)), walls_(sorted(s.walls, wall_names_)), first_(first) {}

    [[nodiscard]] body begin() const noexcept { return first_; }
    [[nodiscard]] body end() const noexcept { return first_ + static_cast<body>(planes_.size() + walls_.size()); }

    // f(plane) or f(wall).
    template <class F>
    decltype(auto) with(body b, F f) const {
        const std::size_t i = b - first_;
        return i < planes_.size() ? f(planes_[i]) : f(walls_[i - planes_.size()]);
    }
    // A ball of that name and b, by the scene's own indices.
    [[nodiscard]] meeting named(int ball, body b) const noexcept {
        const std::size_t i = b - first_;
        return i < planes_.size() ? meeting{partner::plane, ball, plane_names_[i]}
                                  : meeting{partner::wall, ball, wall_names_[i - planes_.size()]};
    }

    // Where each of them is.
    [[nodiscard]] std::vector<standing_extent<dimension>> extents(const M& m) const {
        std::vector<standing_extent<dimension>> result;
        for (body b = begin(); b < end(); ++b) {
            result.push_back(with(b, [&](const auto& s) { return extent_of(m, s); }));
        }
        return result;
    }

    // A place, over a positive number.
    struct place {
        vec<dimension, exact> sum;
        exact over;
    };
    // Where the straight way through x along the velocity of u crosses the plane of b; x, if it never does.
    [[nodiscard]] place crossing(const M& m, body b, const state& x, const state& u) const {
        return crossing(m, b, place{exactly(m, x.state.position), exact(1)}, u);
    }
    [[nodiscard]] place crossing(const M& m, body b, const place& x, const state& u) const {
        const auto velocity = exactly(m, u.state.velocity);
        const auto n = normal_of(m, b);
        const exact speed = graze::dot(velocity, n);
        const exact height = graze::dot(x.sum - x.over * point_of(m, b), n);
        const int sign = graze::sign(speed);
        return sign == 0  ? x
               : sign < 0 ? place{height * velocity - speed * x.sum, -speed * x.over}
                          : place{speed * x.sum - height * velocity, speed * x.over};
    }
    // Whether b, its borders included, is at a place in its plane; or below a place beside that.
    [[nodiscard]] bool is_at(const M& m, body b, const place& x) const {
        const auto borders = borders_at(m, b, x);
        return std::all_of(borders.begin(), borders.end(), [](int at) { return at >= -1 && at <= 1; });
    }
    [[nodiscard]] bool is_inside(const M& m, body b, const place& x) const {
        const auto borders = borders_at(m, b, x);
        return std::all_of(borders.begin(), borders.end(), [](int at) { return at == 0; });
    }
    [[nodiscard]] bool is_in_plane(const M& m, body b, const place& x) const {
        return graze::sign(exact(graze::dot(x.sum - x.over * point_of(m, b), normal_of(m, b)))) == 0;
    }
    // 1 or -1 where b and c are in one plane, as their normals have one sense or not; 0 in two planes.
    [[nodiscard]] int common_sense(const M& m, body b, body c) const {
        const auto n = normal_of(m, b), other = normal_of(m, c);
        return graze::sign(exact(graze::squared_norm(graze::cross(n, other)))) == 0 &&
                       is_in_plane(m, b, {point_of(m, c), exact(1)})
                   ? graze::sign(exact(graze::dot(n, other)))
                   : 0;
    }
    // The place in a wall with the nearest coordinates along each edge.
    [[nodiscard]] place nearest(const M& m, body b, const place& x) const {
        const auto& w = walls_[b - first_ - planes_.size()];
        const auto seen = seen_from(m, w, x);
        const exact length = x.over * graze::squared_norm(seen.n);
        place result{length * exactly(m, w.corner), length};
        const auto add = [&](std::size_t i, const exact& along) {
            const bool low = graze::sign(along)<0, high = graze::sign(exact(along - length))> 0;
            result.sum = result.sum + (low ? exact(0) : high ? length : along) * seen.e[i];
        };
        add(0, side_height<0, 0>{}(seen));
        if constexpr (dimension == 3) {
            add(1, side_height<1, 0>{}(seen));
        }
        return result;
    }
    // b, seen from a place of its own; without one, as if that were anywhere inside.
    [[nodiscard]] cone<dimension, exact> cone_at(const M& m, body b, int side, approach way,
                                                 const std::optional<place>& x) const {
        cone<dimension, exact> result{b, side, way, normal_of(m, b), {}, 0};
        if (x) {
            const auto borders = borders_at(m, b, *x);
            for (std::size_t i = 0; i < borders.size(); ++i) {
                if (borders[i] != 0) {
                    const auto along = sides_of(m, b)[i];
                    result.inward[static_cast<std::size_t>(result.borders++)] = borders[i] < 0 ? along : -along;
                }
            }
        }
        return result;
    }

    // A velocity without rounding.
    [[nodiscard]] static vec<dimension, exact> exactly(const M& m, const vec<dimension, number>& x) {
        return make_vec<dimension>([&](int i) { return m.as_exact(x[i]); });
    }

  private:
    using extent = standing_extent<dimension>;

    [[nodiscard]] static vec<dimension, double> in_doubles(const M& m, const vec<dimension, number>& x) {
        return m.about(m.start({x, x, number(0), number(1)})).state.position;
    }
    [[nodiscard]] static extent endless(const vec<dimension, double>& point, const vec<dimension, double>& n) {
        using limits = std::numeric_limits<double>;
        return {make_vec<dimension>([](int) { return limits::lowest(); }),
                make_vec<dimension>([](int) { return limits::max(); }), point, n};
    }
    [[nodiscard]] static extent extent_of(const M& m, const plane<dimension, number>& p) {
        return endless(in_doubles(m, p.point), in_doubles(m, p.normal));
    }
    template <class W>
    [[nodiscard]] static extent extent_of(const M& m, const W& w) {
        const auto corner = in_doubles(m, w.corner);
        std::array<vec<dimension, double>, dimension - 1> edge;
        std::transform(w.edge.begin(), w.edge.end(), edge.begin(), [&](const auto& e) { return in_doubles(m, e); });
        extent x{corner, corner, corner, face_normal(edge)};
        double largest = 1;
        for (const auto& e : edge) {
            largest *= graze::squared_norm(e);
        }
        if (!(graze::squared_norm(x.n) > 0x1p-60 * largest)) { // parallel edges, or doubles can't tell
            return endless(corner, {});
        }
        for (const auto& e : edge) {
            for (int i = 0; i < dimension; ++i) {
                x.low.component[i] += std::min(e[i], 0.0);
                x.high.component[i] += std::max(e[i], 0.0);
            }
        }
        return x;
    }

    [[nodiscard]] vec<dimension, exact> normal_of(const M& m, body b) const {
        return with(b, [&](const auto& s) {
            if constexpr (requires { s.edge; }) {
                return face_normal(edges_of(m, s));
            } else {
                return exactly(m, s.normal);
            }
        });
    }
    [[nodiscard]] vec<dimension, exact> point_of(const M& m, body b) const {
        return with(b, [&](const auto& s) {
            if constexpr (requires { s.edge; }) {
                return exactly(m, s.corner);
            } else {
                return exactly(m, s.point);
            }
        });
    }
    template <class W>
    [[nodiscard]] static auto edges_of(const M& m, const W& w) {
        std::array<vec<dimension, exact>, dimension - 1> edges;
        std::transform(w.edge.begin(), w.edge.end(), edges.begin(), [&](const auto& e) { return exactly(m, e); });
        return edges;
    }
    // A wall as a motion of which only the place and the wall are looked at.
    template <class W>
    [[nodiscard]] static auto seen_from(const M& m, const W& w, const place& x) {
        const auto from_corner = x.sum - x.over * exactly(m, w.corner);
        return wall_motion_of(from_corner, from_corner, edges_of(m, w), exact(0));
    }
    [[nodiscard]] auto sides_of(const M& m, body b) const {
        return seen_from(m, walls_[b - first_ - planes_.size()], {{}, exact(1)}).side;
    }

    // Where a place is along each edge: -2 before the wall, -1 and 1 at its ends, 0 between them, 2 beyond it.
    [[nodiscard]] std::array<int, dimension - 1> borders_at(const M& m, body b, const place& x) const {
        std::array<int, dimension - 1> result{};
        if (const std::size_t i = b - first_; i >= planes_.size()) {
            const auto seen = seen_from(m, walls_[i - planes_.size()], x);
            const exact length = x.over * graze::squared_norm(seen.n);
            const auto along = [&](const exact& low) {
                const int from_low = graze::sign(low);
                const int from_high = graze::sign(exact(low - length));
                return from_low <= 0 ? from_low - 1 : from_high >= 0 ? from_high + 1 : 0;
            };
            result[0] = along(side_height<0, 0>{}(seen));
            if constexpr (dimension == 3) {
                result[1] = along(side_height<1, 0>{}(seen));
            }
        }
        return result;
    }

    std::vector<int> plane_names_, wall_names_;
    std::vector<plane<dimension, number>> planes_;
    std::vector<wall<dimension, number>> walls_;
    body first_;
};

} // namespace graze::inline v0_1::detail
