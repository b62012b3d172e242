// What one ball of a run may do next.
#pragma once

#include <graze/run/meeting_times.hpp>
#include <graze/scene/remaining_pairs.hpp>
#include <graze/scene/surroundings.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace graze::inline v0_1::detail {

// A moving scene, and each ball's surroundings in it. A pair belongs to that one of its balls whose flight or list
// changed last.
template <mechanics M>
class lookout : public meeting_times<M> {
  public:
    static constexpr int dimension = M::dimension;

    lookout(moving_scene<M> scene, bool with_cells) : meeting_times<M>(std::move(scene)), with_cells_(with_cells) {}

    // Whether balls that had long been alone meet again, so that shells are worth their cost.
    [[nodiscard]] bool is_outdated() const noexcept { return remaining_.is_outdated(); }

    // To be called when ball a has been brought back by a period, or has another shell.
    void note_place(body a) noexcept {
        if (a < offsets_.size()) {
            offsets_[a] = surroundings_.place(a) - scene_.gone(a);
        }
    }

  protected:
    using meeting_times<M>::never;
    using meeting_times<M>::scene_;
    using meeting_times<M>::start_;
    using typename meeting_times<M>::no_image;
    using typename meeting_times<M>::listed_image;

    // Lays out the surroundings anew; nothing will happen before `now`.
    void look_out(double now) {
        auto extents = scene_.extents();
        for (body b = scene_.balls(); b < scene_.bodies(); ++b) {
            if (scene_.is_periodic() && scene_.has_images(b) && !extents[b - scene_.balls()].is_bounded()) {
                throw std::domain_error(to_string(scene_.part(b)) + ": too thin to say where its images are");
            }
        }
        surroundings_ =
            surroundings<dimension>(flights(), now, {std::move(extents), scene_.balls()}, with_cells_, scene_.period());
        for (body a = 0; a < scene_.balls() && scene_.is_periodic(); ++a) {
            if (surroundings_.is_everywhere(a)) {
                refuse(a);
            }
        }
        remaining_ = {};
        offsets_.resize(scene_.is_periodic() ? scene_.balls() : 0);
        for (body a = 0; a < offsets_.size(); ++a) {
            note_place(a);
        }
        changed_.resize(scene_.balls());
        start_ = now;
        for (clock_ = 0; clock_ < scene_.balls(); ++clock_) {
            changed_[clock_] = clock_;
        }
    }
    // In a scene that has a period.
    [[noreturn]] void refuse(body a) const {
        throw std::range_error(to_string(scene_.part(a)) + ": doubles cannot tell in which period it is");
    }
    void note_change(body a) noexcept { changed_[a] = ++clock_; }
    void note_flight(body a) noexcept {
        note_change(a);
        remaining_.note_change(a);
    }
    // Whether nothing has happened for so long that it is known who may meet at all. Nothing will happen before `now`.
    [[nodiscard]] bool is_settled(double now) {
        if (!remaining_.is_known() && !scene_.is_periodic() &&
            surroundings_.idle().has_waited(scene_.bodies() - scene_.balls())) {
            if (!remaining_.find(flights(), now, surroundings_.idle().affordable_pairs(), alike())) {
                surroundings_.idle().wait_longer();
            }
        }
        return remaining_.is_known();
    }

    [[nodiscard]] flight<dimension, double> about(body a) const { return scene_.rules().about(scene_[a].state); }

    // The bodies on a list of a's for its shell at `place`, and their images as seen from there.
    struct neighbours {
        std::span<const body> bodies;
        std::span<const image_code> images;
        image_index place;
    };
    [[nodiscard]] neighbours listed(body a) const noexcept {
        return {surroundings_.of(a), surroundings_.images_of(a), surroundings_.place(a)};
    }
    // f(b, image) for those of these bodies whose pair belongs to a: all of them, if a has changed.
    template <class Image, class F>
    void for_each_own(body a, const neighbours& near, bool has_changed, F f) const {
        if (scene_.balls() > fit_into_cache) {
            for (const body b : near.bodies) {
                if (b < scene_.balls()) {
                    __builtin_prefetch(&changed_[b]);
                    scene_.fetch(b);
                }
            }
        }
        const image_index offset = near.place - scene_.gone(a);
        for (std::size_t i = 0; i < near.bodies.size(); ++i) {
            const body b = near.bodies[i];
            const bool is_ball = b < scene_.balls();
            if (!has_changed && is_ball && !(changed_[b] < changed_[a])) {
                continue;
            }
            if constexpr (std::is_same_v<Image, no_image>) {
                f(b, no_image{});
            } else {
                const image_index there = is_ball ? offset - offsets_[b] : offset;
                f(b, listed_image{near.images[i] == 0 ? there : there + decoded(near.images[i])});
            }
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
    // Those that a may still meet.
    template <class F>
    void for_each_remaining(body a, F f) const {
        if (!remaining_.knows(a)) {
            for_each_other(a, true, f);
            return;
        }
        remaining_.for_each(a, alike(), [&](body b) { f(b, no_image{}); });
        for (body b = scene_.balls(); b < scene_.bodies(); ++b) {
            f(b, no_image{});
        }
    }
    template <class F>
    void for_each_own(body a, bool has_changed, F f) const {
        if (scene_.is_periodic()) {
            for_each_own<listed_image>(a, listed(a), has_changed, f);
        } else if (surroundings_.is_everywhere(a)) {
            for_each_other(a, has_changed, f);
        } else {
            for_each_own<no_image>(a, listed(a), has_changed, f);
        }
    }

    [[nodiscard]] plan look(body a, double now, bool has_changed) const {
        const shell_end<dimension> end = surroundings_.end(a, about(a), now, scene_.gone(a));
        if (!end.known) { // it has no shell
            return {now, never};
        }
        if (scene_.is_periodic()) {
            return this->template earliest_of<listed_image>(
                a, end.when, [&](auto f) { for_each_own<listed_image>(a, listed(a), has_changed, f); });
        }
        return this->template earliest_of<no_image>(a, end.when, [&](auto f) {
            surroundings_.is_everywhere(a) ? for_each_other(a, has_changed, f)
                                           : for_each_own<no_image>(a, listed(a), has_changed, f);
        });
    }
    // The same for a's next shell.
    [[nodiscard]] plan look_ahead(body a, double end) const {
        const neighbours near{surroundings_.fresh(), surroundings_.fresh_images(), surroundings_.fresh_place()};
        return scene_.is_periodic() ? this->template earliest_of<listed_image>(
                                          a, end, [&](auto f) { for_each_own<listed_image>(a, near, true, f); })
                                    : this->template earliest_of<no_image>(
                                          a, end, [&](auto f) { for_each_own<no_image>(a, near, true, f); });
    }

    surroundings<dimension> surroundings_;

  private:
    // Whether two balls have exactly the same velocity.
    [[nodiscard]] auto alike() const noexcept {
        return [this](body a, body b) {
            return order_of(scene_[a].state.state.velocity, scene_[b].state.state.velocity) == 0;
        };
    }
    [[nodiscard]] std::vector<flight<dimension, double>> flights() const {
        std::vector<flight<dimension, double>> all;
        all.reserve(scene_.balls());
        for (body a = 0; a < scene_.balls(); ++a) {
            all.push_back(about(a));
        }
        return all;
    }

    remaining_pairs<dimension> remaining_;
    std::vector<std::uint64_t> changed_; // when a ball's flight or list has changed, counted by clock_
    std::uint64_t clock_ = 0;
    std::vector<image_index> offsets_; // in a scene that has a period: of each ball's shell from its flight
    bool with_cells_;
};

} // namespace graze::inline v0_1::detail
