// The parts of a scene, numbered.
#pragma once

#include <graze/scene/body.hpp>
#include <graze/scene/canonical_order.hpp>
#include <graze/scene/inner_edges.hpp>
#include <graze/scene/records.hpp>
#include <graze/scene/saying.hpp>
#include <graze/scene/scene.hpp>
#include <graze/scene/scene_pair.hpp>
#include <graze/scene/standing_extent.hpp>
#include <graze/shape/flight.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <stdexcept>

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

    // Of the scene, in doubles.
    [[nodiscard]] vec<N, double> period() const { return in_doubles(scene_.period); }
    [[nodiscard]] bool has_images(body b) const noexcept {
        return b < balls_.size() || b >= balls_.size() + planes_.size();
    }
    // Throws std::range_error for a ball that doubles cannot tell in which period it is.
    [[noreturn]] void refuse(body a) const {
        throw std::range_error(to_string(participant{partner::ball, balls_[a]}) +
                               ": doubles cannot tell in which period it is");
    }
    void refuse_far(body a, const vec<N, double>& position) const {
        for (int i = 0; i < N; ++i) {
            const auto length = static_cast<double>(scene_.period[i]);
            if (length > 0 && !(std::fabs(position[i] / length) < 0x1p30)) {
                refuse(a);
            }
        }
    }

    // f(ball, other, who, inner) with a ball and another body, and the inner edges of a triangle. An exception of f
    // says who they are.
    template <class F>
    void with(body a, body b, F f) const {
        const ball<N, T>& x = scene_.balls[index(balls_, a)];
        const auto ask = [&](const auto& other, partner kind, std::size_t number, unsigned inner = 0) {
            const scene_pair who{kind, balls_[a], static_cast<int>(number)};
            saying([&] { f(x, other, who, inner); }, [&] { return who; });
        };
        std::size_t i = b;
        if (i < balls_.size()) {
            i = index(balls_, i);
            ask(scene_.balls[i], partner::ball, i);
            return;
        }
        i -= balls_.size();
        if (i < planes_.size()) {
            i = index(planes_, i);
            ask(scene_.planes[i], partner::plane, i);
            return;
        }
        i -= planes_.size();
        if (i < walls_.size()) {
            i = index(walls_, i);
            ask(scene_.walls[i], partner::wall, i);
            return;
        }
        if constexpr (N == 3) {
            i = index(triangles_, i - walls_.size());
            ask(scene_.triangles[i], partner::triangle, i,
                scene_.inner_edges.empty() ? 0U : unsigned{scene_.inner_edges[i]});
        }
    }

    [[nodiscard]] records<flight<N, double>> flights() const {
        records<flight<N, double>> result;
        result.reserve(balls_.size());
        for (const int i : balls_) {
            const ball<N, T>& b = scene_.balls[static_cast<std::size_t>(i)];
            result.push_back({{in_doubles(b.position), in_doubles(b.velocity), static_cast<double>(b.radius), 1}, 0});
        }
        return result;
    }
    [[nodiscard]] records<standing_extent<N>> extents() const {
        records<standing_extent<N>> result;
        for (const int i : planes_) {
            const plane<N, T>& p = scene_.planes[static_cast<std::size_t>(i)];
            result.push_back(endless_extent(in_doubles(p.point), in_doubles(p.normal)));
        }
        const auto add = [&](const auto& w, const participant& who) {
            std::array<vec<N, double>, N - 1> edge;
            std::transform(w.edge.begin(), w.edge.end(), edge.begin(), in_doubles);
            result.push_back(extent_of(in_doubles(w.corner), edge));
            if (!result.back().is_bounded() && period() != vec<N, double>{}) {
                throw std::domain_error(to_string(who) + ": too thin to say where its images are");
            }
        };
        for (const int i : walls_) {
            add(scene_.walls[static_cast<std::size_t>(i)], {partner::wall, i});
        }
        if constexpr (N == 3) {
            for (const int i : triangles_) {
                add(scene_.triangles[static_cast<std::size_t>(i)], {partner::triangle, i});
            }
        }
        return result;
    }

  private:
    template <class Part>
    [[nodiscard]] static records<int> order(std::span<const Part> pieces, numbering by,
                                            std::span<const std::uint8_t> marks = {}) {
        if (by == numbering::canonical) {
            return canonical_order(pieces, marks);
        }
        records<int> all(pieces.size());
        std::iota(all.begin(), all.end(), 0);
        return all;
    }
    [[nodiscard]] static std::size_t index(const records<int>& names, std::size_t i) {
        return static_cast<std::size_t>(names[i]);
    }
    [[nodiscard]] static vec<N, double> in_doubles(const vec<N, T>& x) {
        return make_vec<N>([&](int i) { return static_cast<double>(x[i]); });
    }

    const scene<N, T>& scene_;
    records<int> balls_, planes_, walls_, triangles_;
};

} // namespace graze::inline v0_1::detail
