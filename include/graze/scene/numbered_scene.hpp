// The parts of a scene, numbered.
#pragma once

#include <graze/scene/body.hpp>
#include <graze/scene/canonical_order.hpp>
#include <graze/scene/inner_edges.hpp>
#include <graze/scene/scene.hpp>
#include <graze/scene/scene_pair.hpp>
#include <graze/scene/standing_extent.hpp>
#include <graze/shape/flight.hpp>

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <stdexcept>
#include <vector>

namespace graze::inline v0_1::detail {

// By the parts' numbers, or as they come.
enum class numbering { canonical, listed };

// Balls, planes, walls and triangles, each in their order, are the bodies 0, 1, ... The scene must outlive this.
template <int N, class T>
class numbered_scene {
  public:
    numbered_scene(const scene<N, T>& s, numbering by)
        : scene_(s), balls_(order(s.balls, by)), planes_(order(s.planes, by)), walls_(order(s.walls, by)),
          triangles_(order(triangles_of(s), by, inner_edges_of(s))) {}

    [[nodiscard]] body balls() const noexcept { return static_cast<body>(balls_.size()); }
    [[nodiscard]] body bodies() const noexcept {
        return static_cast<body>(balls_.size() + planes_.size() + walls_.size() + triangles_.size());
    }

    // f(ball, other, who, inner) with a ball and another body, and the inner edges of a triangle. An exception of f
    // about a wall or a triangle says which.
    template <class F>
    void with(body a, body b, F f) const {
        const ball<N, T>& x = scene_.balls[index(balls_, a)];
        const auto who = [&](partner kind, std::size_t i) { return scene_pair{kind, balls_[a], static_cast<int>(i)}; };
        const auto with_flat = [&](const auto& w, const scene_pair& m, unsigned inner) {
            try {
                f(x, w, m, inner);
            } catch (const std::domain_error& e) { // parallel edges
                throw std::domain_error(to_string(m) + ": " + e.what());
            }
        };
        std::size_t i = b;
        if (i < balls_.size()) {
            i = index(balls_, i);
            f(x, scene_.balls[i], who(partner::ball, i), 0U);
            return;
        }
        i -= balls_.size();
        if (i < planes_.size()) {
            i = index(planes_, i);
            f(x, scene_.planes[i], who(partner::plane, i), 0U);
            return;
        }
        i -= planes_.size();
        if (i < walls_.size()) {
            i = index(walls_, i);
            with_flat(scene_.walls[i], who(partner::wall, i), 0U);
            return;
        }
        if constexpr (N == 3) {
            i = index(triangles_, i - walls_.size());
            with_flat(scene_.triangles[i], who(partner::triangle, i),
                      scene_.inner_edges.empty() ? 0U : unsigned{scene_.inner_edges[i]});
        }
    }

    [[nodiscard]] std::vector<flight<N, double>> flights() const {
        std::vector<flight<N, double>> result;
        result.reserve(balls_.size());
        for (const int i : balls_) {
            const ball<N, T>& b = scene_.balls[static_cast<std::size_t>(i)];
            result.push_back({{in_doubles(b.position), in_doubles(b.velocity), static_cast<double>(b.radius), 1}, 0});
        }
        return result;
    }
    [[nodiscard]] std::vector<standing_extent<N>> extents() const {
        std::vector<standing_extent<N>> result;
        for (const int i : planes_) {
            const plane<N, T>& p = scene_.planes[static_cast<std::size_t>(i)];
            result.push_back(endless_extent(in_doubles(p.point), in_doubles(p.normal)));
        }
        const auto add = [&](const auto& w) {
            std::array<vec<N, double>, N - 1> edge;
            std::transform(w.edge.begin(), w.edge.end(), edge.begin(), in_doubles);
            result.push_back(extent_of(in_doubles(w.corner), edge));
        };
        for (const int i : walls_) {
            add(scene_.walls[static_cast<std::size_t>(i)]);
        }
        if constexpr (N == 3) {
            for (const int i : triangles_) {
                add(scene_.triangles[static_cast<std::size_t>(i)]);
            }
        }
        return result;
    }

  private:
    template <class Part>
    [[nodiscard]] static std::vector<int> order(std::span<const Part> pieces, numbering by,
                                                std::span<const std::uint8_t> marks = {}) {
        if (by == numbering::canonical) {
            return canonical_order(pieces, marks);
        }
        std::vector<int> all(pieces.size());
        std::iota(all.begin(), all.end(), 0);
        return all;
    }
    [[nodiscard]] static std::size_t index(const std::vector<int>& names, std::size_t i) {
        return static_cast<std::size_t>(names[i]);
    }
    [[nodiscard]] static vec<N, double> in_doubles(const vec<N, T>& x) {
        return make_vec<N>([&](int i) { return static_cast<double>(x[i]); });
    }

    const scene<N, T>& scene_;
    std::vector<int> balls_, planes_, walls_, triangles_;
};

} // namespace graze::inline v0_1::detail
