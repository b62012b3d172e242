// The pairs of a run's balls that may meet while these are in their shells.
#pragma once

#include <graze/run/meeting_times.hpp>
#include <graze/run/outlines.hpp>
#include <graze/scene/surroundings.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace graze::inline v0_1::detail {

// A moving scene, and each ball's surroundings in it. A pair belongs to that one of its balls whose flight or list
// changed last.
template <mechanics M>
class listed_pairs : public meeting_times<M> {
  public:
    static constexpr int dimension = M::dimension;

    using meeting_times<M>::meeting_times;

    // To be called when ball a flies otherwise, has been brought back by a period, or has another shell.
    void note_place(body a) noexcept {
        if (a >= scene_.balls()) {
            return;
        }
        if (scene_.is_periodic()) {
            offsets_[a] = surroundings_.place(a) - scene_.gone(a);
        }
        if constexpr (has_outlines) {
            outlines_.set(a, about(a), scene_.is_periodic() ? image_index{} - offsets_[a] : image_index{});
        }
    }

  protected:
    using meeting_times<M>::scene_;
    using typename meeting_times<M>::no_image;
    using typename meeting_times<M>::listed_image;

    // Whether outlines tell the truth: the mechanics bounds times of flights in doubles, which are exact.
    static constexpr bool has_outlines = std::is_same_v<typename M::state, flight<dimension, double>> &&
                                         requires(const M& m, const typename M::state& a) {
        m.meet_until(a, a, 0.0);
    };

    // Starts with these surroundings.
    void begin_with(surroundings<dimension> all) {
        surroundings_ = std::move(all);
        offsets_.resize(scene_.is_periodic() ? scene_.balls() : 0);
        outlines_ = outlines<dimension>(has_outlines ? scene_.balls() : 0, scene_.period());
        changed_.resize(scene_.balls());
        for (clock_ = 0; clock_ < scene_.balls(); ++clock_) {
            changed_[clock_] = clock_;
        }
        for (body a = 0; a < scene_.balls(); ++a) {
            note_place(a);
        }
    }
    void note_change(body a) noexcept { changed_[a] = ++clock_; }
    [[nodiscard]] flight<dimension, double> about(body a) const { return scene_.rules().about(scene_[a].state); }

    // The bodies on a list of a's for its shell at `place`, and their images as seen from there.
    struct neighbours {
        std::span<const body> bodies;
        std::span<const image_code> images;
        image_index place;
        bool is_fresh;
    };
    [[nodiscard]] neighbours listed(body a) const noexcept {
        return {surroundings_.of(a), surroundings_.images_of(a), surroundings_.place(a), false};
    }
    // Where the mechanics has no outlines.
    struct no_glance {
        void look_until(double) const noexcept {}
    };
    // As from its shell for which these are listed.
    [[nodiscard]] auto glance_from(body a, const neighbours& near) const noexcept {
        if constexpr (has_outlines) {
            return outlines_.from(near.is_fresh ? outlines_.make(about(a), scene_.gone(a) - near.place) : outlines_[a]);
        } else {
            return no_glance{};
        }
    }
    // Whether the one that looks certainly does not meet the i-th of these, a ball.
    template <class Image, class Glance>
    [[nodiscard, gnu::always_inline]] bool is_apart(const Glance& from, const neighbours& near,
                                                    std::size_t i) const noexcept {
        if constexpr (!has_outlines) {
            return false;
        } else {
            auto place = from.here();
            if constexpr (!std::is_same_v<Image, no_image>) {
                if (near.images[i] != 0) {
                    place = from.seen_from(outlines_.length_of(decoded(near.images[i])));
                }
            }
            return from.is_apart(outlines_[near.bodies[i]], place);
        }
    }
    // f(b, image) for those of these bodies that a may meet until the time `until`, which f may bring forward, and
    // whose pair belongs to a: all of them, if a has changed.
    template <class Image, class F>
    void for_each_own(body a, const neighbours& near, bool has_changed, const double& until, F f) const {
        if (scene_.balls() > fit_into_cache) {
            for (const body b : near.bodies) {
                if (b < scene_.balls()) {
                    if (!has_changed) {
                        __builtin_prefetch(&changed_[b]);
                    }
                    outlines_.fetch(b);
                }
            }
        }
        const image_index offset = near.place - scene_.gone(a);
        auto mine = glance_from(a, near);
        mine.look_until(until);
        const body balls = scene_.balls();
        for (std::size_t i = 0; i < near.bodies.size(); ++i) {
            const body b = near.bodies[i];
            const bool is_ball = b < balls;
            if (is_ball && ((!has_changed && !(changed_[b] < changed_[a])) || is_apart<Image>(mine, near, i))) {
                continue;
            }
            if constexpr (std::is_same_v<Image, no_image>) {
                f(b, no_image{});
            } else {
                const image_index there = is_ball ? offset - offsets_[b] : offset;
                f(b, listed_image{near.images[i] == 0 ? there : there + decoded(near.images[i])});
            }
            mine.look_until(until);
        }
        for (const body b : surroundings_.everywhere()) {
            if (b != a && (has_changed || changed_[b] < changed_[a])) {
                f(b, Image{});
            }
        }
    }
    template <class F>
    void for_each_other(body a, bool has_changed, F f) const {
        for (body b = 0; b < scene_.bodies(); ++b) {
            if (b != a && (has_changed || b >= scene_.balls() || changed_[b] < changed_[a])) {
                f(b, no_image{});
            }
        }
    }
    template <class F>
    void for_each_own(body a, bool has_changed, const double& until, F f) const {
        if (scene_.is_periodic()) {
            for_each_own<listed_image>(a, listed(a), has_changed, until, f);
        } else if (surroundings_.is_everywhere(a)) {
            for_each_other(a, has_changed, f);
        } else {
            for_each_own<no_image>(a, listed(a), has_changed, until, f);
        }
    }

    surroundings<dimension> surroundings_;

  private:
    outlines<dimension> outlines_;
    std::vector<std::uint64_t> changed_; // when a ball's flight or list has changed, counted by clock_
    std::uint64_t clock_ = 0;
    std::vector<image_index> offsets_; // in a scene that has a period: of each ball's shell from its flight
};

} // namespace graze::inline v0_1::detail
