// The planes, walls and triangles of a run.
#pragma once

#include <graze/formula/wall_features.hpp>
#include <graze/pair/pair.hpp>
#include <graze/scene/body.hpp>
#include <graze/scene/canonical_order.hpp>
#include <graze/scene/images.hpp>
#include <graze/scene/inner_edges.hpp>
#include <graze/scene/mechanics.hpp>
#include <graze/scene/records.hpp>
#include <graze/scene/scene.hpp>
#include <graze/scene/scene_pair.hpp>
#include <graze/scene/standing_extent.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <utility>

namespace graze::inline v0_1::detail {

// Parts of a scene in their canonical order.
template <class Part>
[[nodiscard]] records<Part> sorted(std::span<const Part> pieces, const records<int>& order) {
    records<Part> result;
    result.reserve(order.size());
    for (const int i : order) {
        result.push_back(pieces[static_cast<std::size_t>(i)]);
    }
    return result;
}

// Planes, then walls, then triangles, each in canonical order, numbered as bodies from `first` on.
template <mechanics M>
class standing_shapes {
  public:
    static constexpr int dimension = M::dimension;
    using number = typename M::number;
    using state = typename M::state;

    // Throws std::domain_error for triangles if M does not support them.
    standing_shapes(const scene<dimension, number>& s, body first)
        : plane_names_(canonical_order(s.planes)), wall_names_(canonical_order(s.walls)),
          triangle_names_(canonical_order(triangles_of(s), inner_edges_of(s))), planes_(sorted(s.planes, plane_names_)),
          walls_(sorted(s.walls, wall_names_)), triangles_(sorted(triangles_of(s), triangle_names_)), first_(first) {
        if (!mechanics_of_triangles<M> && !triangles_.empty()) {
            throw std::domain_error("triangle 0: these mechanics know no triangles");
        }
        if (const auto marks = inner_edges_of(s); !marks.empty()) {
            inner_edges_ = sorted(marks, triangle_names_);
        }
    }

    [[nodiscard]] body begin() const noexcept { return first_; }
    [[nodiscard]] body end() const noexcept {
        return first_ + static_cast<body>(planes_.size() + walls_.size() + triangles_.size());
    }

    [[nodiscard]] body first_wall() const noexcept { return first_ + static_cast<body>(planes_.size()); }

    // f(plane), f(wall) or f(triangle).
    template <class F>
    decltype(auto) with(body b, F f) const {
        const std::size_t i = b - first_;
        if constexpr (mechanics_of_triangles<M>) {
            if (i >= planes_.size() + walls_.size()) {
                return f(triangles_[i - planes_.size() - walls_.size()]);
            }
        }
        return i < planes_.size() ? f(planes_[i]) : f(walls_[i - planes_.size()]);
    }
    // A ball with that name, and b, by the scene's own indices.
    [[nodiscard]] scene_pair named(int ball, body b) const noexcept {
        std::size_t i = b - first_;
        if (i < planes_.size()) {
            return {partner::plane, ball, plane_names_[i]};
        }
        i -= planes_.size();
        return i < walls_.size() ? scene_pair{partner::wall, ball, wall_names_[i]}
                                 : scene_pair{partner::triangle, ball, triangle_names_[i - walls_.size()]};
    }
    [[nodiscard]] bool is_plane(body b) const noexcept { return b - first_ < planes_.size(); }
    // When x meets b, or its image; not at an inner edge.
    [[nodiscard]] std::optional<typename M::time> meet(const images<M>& all, const state& x, body b,
                                                       image_index periods) const {
        const auto& m = all.rules();
        const auto when_at = [&](const auto& there) {
            auto when = m.meet(x, there);
            if constexpr (mechanics_of_triangles<M>) { // by itself: clang looks into what depends on the shape alone
                if constexpr (is_triangle<std::remove_cvref_t<decltype(there)>>) {
                    if (when && !inner_edges_.empty()) {
                        const unsigned inner = inner_edges_[b - first_ - planes_.size() - walls_.size()];
                        if (inner != 0 && is_inner(m.feature(x, there), inner)) {
                            when.reset();
                        }
                    }
                }
            }
            return when;
        };
        return with(b, [&](const auto& s) { return all.with_image(s, periods, when_at); });
    }

    [[nodiscard]] static vec<dimension, double> in_doubles(const M& m, const vec<dimension, number>& x) {
        return m.about(m.start({x, x, number(0), number(1)})).state.position;
    }
    // Where each of them is.
    [[nodiscard]] records<standing_extent<dimension>> extents(const M& m) const {
        records<standing_extent<dimension>> result;
        for (body b = begin(); b < end(); ++b) {
            result.push_back(extent(m, b));
        }
        return result;
    }

    // Where b is, in doubles.
    [[nodiscard]] standing_extent<dimension> extent(const M& m, body b) const {
        return with(b, [&](const auto& s) { return extent_in_doubles(m, s); });
    }

  private:
    [[nodiscard]] static standing_extent<dimension> extent_in_doubles(const M& m, const plane<dimension, number>& p) {
        return endless_extent(in_doubles(m, p.point), in_doubles(m, p.normal));
    }
    template <class W>
    [[nodiscard]] static standing_extent<dimension> extent_in_doubles(const M& m, const W& w) {
        std::array<vec<dimension, double>, dimension - 1> edge;
        std::transform(w.edge.begin(), w.edge.end(), edge.begin(), [&](const auto& e) { return in_doubles(m, e); });
        return extent_of(in_doubles(m, w.corner), edge);
    }

    records<int> plane_names_, wall_names_, triangle_names_;
    records<plane<dimension, number>> planes_;
    records<wall<dimension, number>> walls_;
    records<triangle<number>> triangles_;
    records<std::uint8_t> inner_edges_; // of the triangles, if any are
    body first_;
};

} // namespace graze::inline v0_1::detail
