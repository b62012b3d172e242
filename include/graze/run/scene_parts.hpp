// The parts of a run's scene, by their numbers.
#pragma once

#include <graze/point/standing_shapes.hpp>
#include <graze/run/numbered_balls.hpp>
#include <graze/scene/check_scene.hpp>
#include <graze/scene/images.hpp>
#include <graze/scene/records.hpp>

#include <utility>

namespace graze::inline v0_1::detail {

// Balls, planes, walls and triangles, numbered in their canonical order, so that nothing depends on the order in which
// the scene lists them.
template <mechanics M>
class scene_parts {
  public:
    static constexpr int dimension = M::dimension;
    using number = typename M::number;
    using state = typename M::state;

    // Throws std::domain_error for what check says of the scene.
    scene_parts(const scene<dimension, number>& s, M m)
        : images_(std::move(m), (check(s), s.period), detail::is_periodic(s)),
          standing_(s, static_cast<body>(s.balls.size())), balls_(s.balls, images_),
          first_standing_(static_cast<body>(s.balls.size())) {}

    [[nodiscard]] const M& rules() const noexcept { return images_.rules(); }
    [[nodiscard]] bool is_periodic() const noexcept { return images_.is_periodic(); }
    // Whether b has several images.
    [[nodiscard]] bool has_images(body b) const noexcept { return b < balls() || !standing_.is_plane(b); }
    // In doubles.
    [[nodiscard]] vec<dimension, double> period() const {
        return is_periodic() ? standing_.in_doubles(rules(), images_.period()) : vec<dimension, double>{};
    }
    [[nodiscard]] body balls() const noexcept { return first_standing_; }
    [[nodiscard]] body bodies() const noexcept { return standing_.end(); }
    [[nodiscard]] mover<state>& operator[](body a) noexcept { return balls_.movers[a]; }
    [[nodiscard]] const mover<state>& operator[](body a) const noexcept { return balls_.movers[a]; }
    [[nodiscard]] int name(body a) const noexcept { return balls_.names[a]; }

    // By the scene's own indices. Of two balls, the one that comes first by its numbers is named first.
    [[nodiscard]] scene_pair named(body a, body b) const noexcept {
        return b < balls() ? scene_pair{partner::ball, name(a), name(b)} : standing_.named(name(a), b);
    }

    // Where planes and walls are.
    [[nodiscard]] records<standing_extent<dimension>> extents() const { return standing_.extents(rules()); }

    [[nodiscard]] participant part(body b) const noexcept {
        const scene_pair m = named(0, b);
        return {m.with, m.b};
    }

  protected:
    images<M> images_;
    standing_shapes<M> standing_;
    numbered_balls<M> balls_;

  private:
    body first_standing_; // the number of balls, which is asked for too often to be computed
};

} // namespace graze::inline v0_1::detail
