// What a mechanics answers about images, in a space with periods or without.
#pragma once

#include <graze/scene/body.hpp>
#include <graze/scene/mechanics.hpp>
#include <graze/scene/period.hpp>

#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

namespace graze::inline v0_1::detail {

// `periods` says how many periods the image of the second one is from itself. If it is zero, the mechanics is asked as
// if there were no images.
template <mechanics M>
class images {
  public:
    static constexpr int dimension = M::dimension;
    using number = typename M::number;
    using state = typename M::state;
    using time = typename M::time;

    // Throws std::domain_error if there is a period and the mechanics does not support any.
    images(M m, const vec<dimension, number>& period, bool is_periodic)
        : mechanics_(std::move(m)), period_(period), is_periodic_(is_periodic) {
        if (is_periodic && !mechanics_of_periods<M>) {
            throw std::domain_error("period: these mechanics know none");
        }
    }

    [[nodiscard]] const M& rules() const noexcept { return mechanics_; }
    [[nodiscard]] bool is_periodic() const noexcept { return is_periodic_; }
    [[nodiscard]] const vec<dimension, number>& period() const noexcept { return period_; }

    [[nodiscard]] std::optional<time> meet(const state& a, const state& b, image_index periods) const {
        if constexpr (mechanics_of_periods<M>) {
            if (is_elsewhere(periods)) {
                return mechanics_.meet(a, b, shift(periods));
            }
        }
        return mechanics_.meet(a, b);
    }
    // Doubles around that time, by meet_until if the mechanics has it.
    [[nodiscard, gnu::always_inline]] time_bounds meet_until(const state& a, const state& b, image_index periods,
                                                             double latest) const {
        if constexpr (requires { mechanics_.meet_until(a, b, latest); }) {
            if (!is_elsewhere(periods)) {
                return mechanics_.meet_until(a, b, latest);
            }
        }
        if constexpr (requires { mechanics_.meet_until(a, b, shift(periods), latest); }) {
            if (is_elsewhere(periods)) {
                return mechanics_.meet_until(a, b, shift(periods), latest);
            }
        }
        const std::optional<time> when = meet(a, b, periods);
        constexpr double never = std::numeric_limits<double>::max();
        return when ? mechanics_.bounds(*when) : time_bounds{never, never};
    }
    void bounce(state& a, state& b, image_index periods, const time& when) const {
        if constexpr (mechanics_of_periods<M>) {
            if (is_elsewhere(periods)) {
                mechanics_.bounce(a, b, shift(periods), when);
                return;
            }
        }
        mechanics_.bounce(a, b, when);
    }
    // f(s or its image) for a plane or wall s. A plane is its own image: its normal has no component along a period.
    template <class S, class F>
    auto with_image(const S& s, image_index periods, F f) const {
        if constexpr (mechanics_of_periods<M> && requires { s.edge; }) {
            if (is_elsewhere(periods)) {
                const S there = mechanics_.displaced(s, shift(periods));
                return f(there);
            }
        }
        return f(s);
    }
    // Brings a position to within half a period of 0. Returns by how many periods.
    [[nodiscard]] image_index bring_back(state& a) const {
        if constexpr (mechanics_of_periods<M>) {
            if (is_periodic_) {
                return mechanics_.wrap(a, period_);
            }
        }
        return {};
    }

  private:
    [[nodiscard]] bool is_elsewhere(image_index periods) const noexcept {
        return is_periodic_ && periods != image_index{};
    }
    [[nodiscard]] image_shift<dimension, number> shift(image_index periods) const { return {periods, period_}; }

    M mechanics_;
    vec<dimension, number> period_;
    bool is_periodic_;
};

} // namespace graze::inline v0_1::detail
