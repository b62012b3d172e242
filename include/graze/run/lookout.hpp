// What one ball of a run may do next.
#pragma once

#include <graze/run/listed_pairs.hpp>
#include <graze/scene/records.hpp>
#include <graze/scene/remaining_pairs.hpp>

#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace graze::inline v0_1::detail {

// A moving scene, its pairs, and who may still meet once the balls have flown apart.
template <mechanics M>
class lookout : public listed_pairs<M> {
  public:
    static constexpr int dimension = M::dimension;

    lookout(moving_scene<M> scene, bool with_cells) : listed_pairs<M>(std::move(scene)), with_cells_(with_cells) {}

    // Whether balls that had long been alone meet again, so that shells are worth their cost.
    [[nodiscard]] bool is_outdated() const noexcept { return remaining_.is_outdated(); }

  protected:
    using meeting_times<M>::never;
    using meeting_times<M>::scene_;
    using meeting_times<M>::start_;
    using listed_pairs<M>::surroundings_;
    using typename listed_pairs<M>::neighbours;
    using listed_pairs<M>::about;
    using listed_pairs<M>::note_change;

    // Lays out the surroundings anew; nothing will happen before `now`.
    void look_out(double now) {
        auto extents = scene_.extents();
        for (body b = scene_.balls(); b < scene_.bodies(); ++b) {
            if (scene_.is_periodic() && scene_.has_images(b) && !extents[b - scene_.balls()].is_bounded()) {
                throw std::domain_error(to_string(scene_.part(b)) + ": too thin to say where its images are");
            }
        }
        this->begin_with(surroundings<dimension>(flights(), now, {std::move(extents), scene_.balls()}, with_cells_,
                                                 scene_.period()));
        for (body a = 0; a < scene_.balls() && scene_.is_periodic(); ++a) {
            if (surroundings_.is_everywhere(a)) {
                refuse(a);
            }
        }
        remaining_ = {};
        start_ = now;
    }
    // In a scene that has a period.
    [[noreturn]] void refuse(body a) const {
        throw std::range_error(to_string(scene_.part(a)) + ": doubles cannot tell in which period it is");
    }
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

    // Those that a may still meet.
    [[nodiscard]] neighbours remaining(body a) {
        if (!remaining_.knows(a)) {
            return this->everyone();
        }
        still_met_.clear();
        remaining_.list(a, alike(), still_met_);
        for (body b = scene_.balls(); b < scene_.bodies(); ++b) {
            still_met_.push_back(b);
        }
        return {{}, {}, {}, still_met_, false};
    }
    [[nodiscard]] plan look(body a, double now, bool has_changed) const {
        const shell_end<dimension> end = surroundings_.end(a, about(a), now, scene_.gone(a));
        if (!end.known) { // it has no shell
            return {now, never};
        }
        return this->earliest(a, end.when, this->neighbours_of(a), has_changed);
    }

  private:
    // Whether two balls have exactly the same velocity.
    [[nodiscard]] auto alike() const noexcept {
        return [this](body a, body b) {
            return order_of(scene_[a].state.state.velocity, scene_[b].state.state.velocity) == 0;
        };
    }
    [[nodiscard]] records<flight<dimension, double>> flights() const {
        records<flight<dimension, double>> all;
        all.reserve(scene_.balls());
        for (body a = 0; a < scene_.balls(); ++a) {
            all.push_back(about(a));
        }
        return all;
    }

    remaining_pairs<dimension> remaining_;
    records<body> still_met_; // a list made for one ball
    bool with_cells_;
};

} // namespace graze::inline v0_1::detail
