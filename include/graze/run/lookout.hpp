// What one ball of a run may do next.
#pragma once

#include <graze/run/moving_scene.hpp>
#include <graze/scene/remaining_pairs.hpp>
#include <graze/scene/surroundings.hpp>

#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace graze::inline v0_1::detail {

// The ball meets that image of b not before lower and, whatever it meets, not after upper; without b, it leaves its
// shell at lower. contested: it may meet another body before it certainly meets b.
struct plan {
    double lower = std::numeric_limits<double>::max();
    double upper = std::numeric_limits<double>::max();
    body b = no_body;
    image_index image{};
    std::uint32_t count_b = 0;
    bool contested = false;

    [[nodiscard]] bool is_to_leave() const noexcept { return b == no_body; }
};

// A moving scene, and each ball's surroundings in it. A pair belongs to that one of its balls whose flight or list
// changed last.
template <mechanics M>
class lookout {
  public:
    static constexpr int dimension = M::dimension;

    lookout(moving_scene<M> scene, bool with_cells) : scene_(std::move(scene)), with_cells_(with_cells) {}

    [[nodiscard]] moving_scene<M>& scene() noexcept { return scene_; }
    [[nodiscard]] const moving_scene<M>& scene() const noexcept { return scene_; }
    // Whether balls that had long been alone meet again, so that shells are worth their cost.
    [[nodiscard]] bool is_outdated() const noexcept { return remaining_.is_outdated(); }

  protected:
    static constexpr double never = std::numeric_limits<double>::max();

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
    [[nodiscard]] std::uint32_t count(body b) const noexcept { return b < scene_.balls() ? scene_.count(b) : 0; }

    // Bounds on when a and b meet; never, if they don't or it is certainly later than `latest`.
    [[nodiscard, gnu::always_inline]] time_bounds when(body a, body b, image_index image, double latest) const {
        constexpr time_bounds none{never, never};
        if (scene_.have_just_met(a, b, image)) {
            return none;
        }
        const time_bounds bounds =
            b < a ? scene_.meet_until(b, a, image_index{} - image, latest) : scene_.meet_until(a, b, image, latest);
        // not a number, or of mirrors, whose flights began before
        return bounds.lower < never && !(bounds.upper < start_) ? bounds : none;
    }
    // f(b, image) for the bodies that a may meet in its shell and whose pair belongs to a: all of them, if a has
    // changed. image_of(i, b): the image of b, the i-th on the list, in a scene that has a period.
    template <class Image, class F>
    void for_each_own(body a, std::span<const body> list, Image image_of, bool has_changed, F f) const {
        if (scene_.balls() > fit_into_cache) {
            for (const body b : list) {
                if (b < scene_.balls()) {
                    __builtin_prefetch(&changed_[b]);
                    scene_.fetch(b);
                }
            }
        }
        for (std::size_t i = 0; i < list.size(); ++i) {
            const body b = list[i];
            if (has_changed || b >= scene_.balls() || changed_[b] < changed_[a]) {
                f(b, scene_.is_periodic() && scene_.has_images(b) ? image_of(i, b) : image_index{});
            }
        }
        for (const body b : surroundings_.everywhere()) {
            if (b != a && (has_changed || changed_[b] < changed_[a])) {
                f(b, image_index{});
            }
        }
    }
    template <class F>
    void for_each_other(body a, bool has_changed, F f) const {
        for (body b = 0; b < scene_.bodies(); ++b) {
            if (b != a && (has_changed || b >= scene_.balls() || changed_[b] < changed_[a])) {
                f(b, image_index{});
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
        remaining_.for_each(a, alike(), [&](body b) { f(b, image_index{}); });
        for (body b = scene_.balls(); b < scene_.bodies(); ++b) {
            f(b, image_index{});
        }
    }
    template <class F>
    void for_each_own(body a, bool has_changed, F f) const {
        if (surroundings_.is_everywhere(a)) {
            for_each_other(a, has_changed, f);
        } else {
            const auto image_of = [&](std::size_t i, body b) { return surroundings_.image(a, i, b); };
            for_each_own(a, surroundings_.of(a), image_of, has_changed, f);
        }
    }

    // The earliest event of a with the bodies that `each` passes on, or leaving its shell at `end`.
    template <class Each>
    [[nodiscard]] plan earliest_of(body a, double end, Each each) const {
        plan p{never, end};
        double second = never;
        each([&](body b, image_index image) __attribute__((always_inline)) {
            if (const time_bounds bounds = when(a, b, image, p.upper); bounds.lower < never) {
                second = std::min(second, std::max(p.lower, bounds.lower));
                if (bounds.lower < p.lower) {
                    p.lower = bounds.lower;
                    p.b = b;
                    p.image = image;
                }
                p.upper = std::min(p.upper, bounds.upper);
            }
        });
        if (p.upper < end || end == never) {
            p.contested = second <= p.upper && second < never;
            p.count_b = p.b < scene_.bodies() ? count(p.b) : 0;
        } else {
            p.lower = std::min(p.lower, end);
            p.b = no_body;
        }
        return p;
    }
    [[nodiscard]] plan look(body a, double now, bool has_changed) const {
        const shell_end<dimension> end = surroundings_.end(a, about(a), now, scene_.gone(a));
        if (!end.known) { // it has no shell
            return {now, never};
        }
        return earliest_of(a, end.when, [&](auto f) { for_each_own(a, has_changed, f); });
    }

    moving_scene<M> scene_;
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
    bool with_cells_;
    double start_ = 0; // of the predictions
};

} // namespace graze::inline v0_1::detail
