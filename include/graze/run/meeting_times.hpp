// When two bodies of a run meet, in doubles.
#pragma once

#include <graze/run/moving_scene.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <type_traits>
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

// A moving scene, and the bounds on times by which it is predicted what happens in it.
template <mechanics M>
class meeting_times {
  public:
    explicit meeting_times(moving_scene<M> scene) : scene_(std::move(scene)) {}

    [[nodiscard]] moving_scene<M>& scene() noexcept { return scene_; }
    [[nodiscard]] const moving_scene<M>& scene() const noexcept { return scene_; }

  protected:
    static constexpr double never = std::numeric_limits<double>::max();

    // Which image of a body: in a scene without periods itself; of one on a list, so many periods away as the two fly.
    struct no_image {};
    struct listed_image {
        image_index periods;
    };
    [[nodiscard]] image_index index_of(body, body, no_image) const noexcept { return {}; }
    [[nodiscard]] image_index index_of(body a, body b, const listed_image& image) const noexcept {
        return scene_.has_images(b) ? image.periods + scene_.gone(a) - scene_.gone(b) : image_index{};
    }

    [[nodiscard]] std::uint32_t count(body b) const noexcept { return b < scene_.balls() ? scene_.count(b) : 0; }
    // Bounds on when a and b meet; never, if they don't or it is certainly later than `latest`.
    [[nodiscard, gnu::noinline]] time_bounds when(body a, body b, image_index image, double latest) const {
        if (scene_.have_just_met(a, b, image)) {
            return {never, never};
        }
        const time_bounds bounds =
            b < a ? scene_.meet_until(b, a, image_index{} - image, latest) : scene_.meet_until(a, b, image, latest);
        return certain(bounds);
    }
    // The same in the loop that most of a run's time goes into.
    template <class Image>
    [[nodiscard, gnu::always_inline]] time_bounds when_listed(body a, body b, const Image& image, double latest) const {
        if (b >= scene_.balls() || scene_.may_have_just_met(a, b)) [[unlikely]] {
            return when(a, b, index_of(a, b, image), latest);
        }
        const bool first = a < b;
        const body x = first ? a : b, y = first ? b : a;
        if constexpr (std::is_same_v<Image, listed_image>) {
            if (image.periods != image_index{}) {
                return certain(scene_.meet_across(x, y, first ? image.periods : image_index{} - image.periods, latest));
            }
        }
        return certain(scene_.meet_across(x, y, {}, latest));
    }

    // The earliest event of a with the bodies that `each` passes on, each with an image of that type, or leaving its
    // shell at `end`. each(until, listed, other): calls listed(b, image) in one loop, other(b, image) of what is seldom
    // looked at. What certainly comes after the time `until` may be left out.
    template <class Image, class Each>
    [[nodiscard, gnu::always_inline]] plan earliest_of(body a, double end, Each each) const {
        plan p{never, end};
        Image best{};
        double second = never;
        const auto take = [&](body b, const Image& image, const time_bounds& bounds) __attribute__((always_inline)) {
            if (bounds.lower < never) {
                second = std::min(second, std::max(p.lower, bounds.lower));
                if (bounds.lower < p.lower) {
                    p.lower = bounds.lower;
                    p.b = b;
                    best = image;
                }
                p.upper = std::min(p.upper, bounds.upper);
            }
        };
        each(
            p.upper,
            [&](body b, const Image& image)
                __attribute__((always_inline)) { take(b, image, when_listed(a, b, image, p.upper)); },
            [&](body b, const Image& image) { take(b, image, when(a, b, index_of(a, b, image), p.upper)); });
        if (p.upper < end || end == never) {
            p.contested = second <= p.upper && second < never;
            if (p.b != no_body) {
                p.count_b = count(p.b);
                p.image = index_of(a, p.b, best);
            }
        } else {
            p.lower = std::min(p.lower, end);
            p.b = no_body;
        }
        return p;
    }
    moving_scene<M> scene_;
    double start_ = 0; // of the predictions

  private:
    // None for what is not a number, or a time of mirrors before the predictions: their flights began before.
    [[nodiscard, gnu::always_inline]] time_bounds certain(const time_bounds& x) const noexcept {
        return x.lower < never && !(x.upper < start_) ? x : time_bounds{never, never};
    }
};

} // namespace graze::inline v0_1::detail
