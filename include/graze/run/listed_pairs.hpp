// The pairs of a run's balls that may meet while these are in their shells.
#pragma once

#include <graze/machine/fetch.hpp>
#include <graze/run/meeting_times.hpp>
#include <graze/run/outlines.hpp>
#include <graze/scene/records.hpp>
#include <graze/scene/surroundings.hpp>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <type_traits>
#include <utility>

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
        everyone_.resize(scene_.bodies());
        std::iota(everyone_.begin(), everyone_.end(), body{0});
        changed_.resize(scene_.balls());
        for (clock_ = 0; clock_ < scene_.balls(); ++clock_) {
            changed_[clock_] = clock_;
        }
        for (body a = 0; a < scene_.balls(); ++a) {
            note_place(a);
        }
    }
    void note_change(body a) noexcept { changed_[a] = ++clock_; }
    // Fetches from memory a ball, its shell and where its list is; then its neighbours, when the list is there.
    void fetch_ball(body a) const noexcept {
        scene_.fetch(a);
        surroundings_.fetch(a);
        detail::fetch(changed_[a]);
        if constexpr (has_outlines) {
            outlines_.fetch(a);
        }
    }
    void fetch_neighbours(body a, bool leaves) const noexcept {
        for (const body b : surroundings_.of(a)) {
            if (b < scene_.balls()) {
                if constexpr (has_outlines) {
                    outlines_.fetch(b);
                }
                scene_.fetch(b);
                if (leaves) {
                    surroundings_.fetch(b);
                }
            }
        }
    }
    [[nodiscard]] flight<dimension, double> about(body a) const { return scene_.rules().about(scene_[a].state); }

    // Bodies that a ball may meet. bodies, images: on a list for its shell at `place`, as seen from there. others:
    // balls that are in no shell, or all bodies.
    struct neighbours {
        std::span<const body> bodies;
        std::span<const image_code> images;
        image_index place;
        std::span<const body> others;
        bool is_fresh;
    };
    [[nodiscard]] neighbours listed(body a) const noexcept {
        return {surroundings_.of(a), surroundings_.images_of(a), surroundings_.place(a), surroundings_.everywhere(),
                false};
    }
    // In a's next shell, in which surroundings has looked around.
    [[nodiscard]] neighbours listed_next() const noexcept {
        return {surroundings_.fresh(), surroundings_.fresh_images(), surroundings_.fresh_place(),
                surroundings_.everywhere(), true};
    }
    [[nodiscard]] neighbours everyone() const noexcept { return {{}, {}, {}, everyone_, false}; }
    [[nodiscard]] neighbours neighbours_of(body a) const noexcept {
        return !scene_.is_periodic() && surroundings_.is_everywhere(a) ? everyone() : listed(a);
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
                    place = from.seen_from(outlines_.length_of(near.images[i]));
                }
            }
            return from.is_apart(outlines_[near.bodies[i]], place);
        }
    }
    // listed(b, image) for those of these bodies that a may meet until the time `until`, which it may bring forward,
    // and whose pair belongs to a: all of them, if a has changed. other(b, image): the same of the others, at any time.
    template <class Image, class F, class G>
    [[gnu::always_inline]] void for_each_own(body a, const neighbours& near, bool has_changed, const double& until,
                                             const F& listed, const G& other) const {
        if (scene_.balls() > fit_into_cache) {
            for (const body b : near.bodies) {
                if (b < scene_.balls()) {
                    if (!has_changed) {
                        detail::fetch(changed_[b]);
                    }
                    if constexpr (has_outlines) {
                        outlines_.fetch(b);
                    }
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
                listed(b, no_image{});
            } else {
                const image_index there = is_ball ? offset - offsets_[b] : offset;
                listed(b, listed_image{near.images[i] == 0 ? there : there + decoded(near.images[i])});
            }
            mine.look_until(until);
        }
        for (const body b : near.others) {
            if (b != a && (has_changed || b >= balls || changed_[b] < changed_[a])) {
                other(b, Image{});
            }
        }
    }
    // The earliest event of a with one of these, or leaving its shell at `end`.
    [[nodiscard]] plan earliest(body a, double end, const neighbours& near, bool has_changed) const {
        return scene_.is_periodic() ? earliest_among<listed_image>(a, end, near, has_changed)
                                    : earliest_among<no_image>(a, end, near, has_changed);
    }

    surroundings<dimension> surroundings_;

  private:
    template <class Image>
    [[nodiscard, gnu::noinline]] plan earliest_among(body a, double end, const neighbours& near,
                                                     bool has_changed) const {
        return this->template earliest_of<Image>(
            a, end, [&](const double& until, const auto& listed, const auto& other) __attribute__((always_inline)) {
                for_each_own<Image>(a, near, has_changed, until, listed, other);
            });
    }

    outlines<dimension> outlines_;
    records<body> everyone_;
    records<std::uint64_t> changed_; // when a ball's flight or list has changed, counted by clock_
    std::uint64_t clock_ = 0;
    records<image_index> offsets_; // in a scene that has a period: of each ball's shell from its flight
};

} // namespace graze::inline v0_1::detail
