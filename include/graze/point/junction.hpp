// A place where a point meets several planes and walls at one instant, and the order in which it meets them.
#pragma once

#include <graze/formula/plane_crossing.hpp>
#include <graze/formula/wall_features.hpp>
#include <graze/point/shift.hpp>
#include <graze/scene/body.hpp>
#include <graze/scene/records.hpp>

#include <algorithm>
#include <iterator>
#include <optional>

namespace graze::inline v0_1::detail {

// Seen from so near that only directions are left, every plane and wall at the point is a cone with its apex there, and
// the point's way is a line. The line leads through the apex until the point meets its first wall. That is one which a
// way shifted by less than any number can reach first; walls that the point meets inside come before those that it
// meets on their border, and equals are in canonical order. From then on the line is the shifted one. It bounces off
// each cone that it comes to. All signs are computed in X, so only X's own operations round; velocities are those with
// which the run goes on.
template <int N, class X>
class junction {
  public:
    using direction = vec<N, X>;
    using cone_list = records<cone<N, X>>;

    // Cones in canonical order, met by a point on its way in along `incoming`.
    junction(cone_list cones, const direction& incoming) : place_(-incoming) {
        for (const bool bordered : {false, true}) { // those that are met inside come first
            std::copy_if(cones.begin(), cones.end(), std::back_inserter(cones_),
                         [&](const auto& c) { return c.is_bordered() == bordered; });
        }
    }

    [[nodiscard]] bool has(standing_image standing) const noexcept { return find(standing) != cones_.end(); }
    // What the point meets next at this instant, if anything.
    [[nodiscard]] standing_image next() const noexcept { return next_; }
    [[nodiscard]] std::size_t size() const noexcept { return cones_.size(); }

    // Whether the point, on its way in along u, cannot reach one of them, because it slides on the other side of
    // another that is between.
    [[nodiscard]] bool is_beyond_reach(standing_image standing, const direction& u) const {
        return keeps_aside() && !is_reached(*find(standing), u);
    }

    // The point has had an event other than a bounce here: it may meet again what it met last.
    void leave_none() noexcept { left_ = {}; }

    // The point goes on with this velocity.
    void head(const direction& u) { next_ = first_met(u); }

    // The point, which came along u, meets one of them and goes on with the velocity `after`.
    void meet(standing_image standing, const direction& u, const direction& after) {
        const auto met = std::find_if(cones_.begin(), cones_.end(), [&](const auto& c) { return is_of(c, standing); });
        left_ = standing;
        next_ = {};
        if (is_through_apex(place_, u)) {
            if (met->way == approach::to_border) { // a graze, which changes nothing
                met->way = approach::along;
                head(after);
                return;
            }
            place_ = shift_into(*met, cones_, u, after).value_or(inside(*met));
        } else {
            place_ = along(*met, crossing(*met, u));
        }
        for (cone<N, X>& c : cones_) { // the side on which the point now is, unless it is in that plane
            if (const int side = is_of(c, standing) ? 0 : graze::sign(graze::dot(place_, c.normal)); side != 0) {
                c.side = side;
            }
        }
        head(after);
    }

    // f(standing, side) with the sides on which the point leaves the planes and walls here. What it would have met next
    // it leaves on the side from which it comes.
    template <class F>
    void leave(const direction& u, F f) const {
        for (const cone<N, X>& c : cones_) {
            const bool keeps = is_of(c, left_) || (is_of(c, next_) && c.side != 0);
            const int heading = keeps ? 0 : graze::sign(graze::dot(u, c.normal));
            if (const int side = heading != 0 ? heading : c.side; side != 0) {
                f(c.standing, side);
            }
        }
    }

  private:
    [[nodiscard]] static bool is_of(const cone<N, X>& c, standing_image standing) noexcept {
        return c.standing == standing;
    }
    [[nodiscard]] auto find(standing_image standing) const noexcept {
        return std::find_if(cones_.begin(), cones_.end(), [&](const auto& c) { return is_of(c, standing); });
    }

    [[nodiscard]] standing_image first_met(const direction& u) const {
        if (is_through_apex(place_, u)) {
            return first_at_apex(u);
        }
        const cone<N, X>* first = nullptr;
        X first_height(0), first_speed(1);
        for (const cone<N, X>& c : cones_) {
            const X speed = graze::dot(u, c.normal);
            if (is_of(c, left_) || graze::sign(speed) * c.side >= 0 || !c.holds(crossing(c, u))) {
                continue;
            }
            X height = magnitude(graze::dot(place_, c.normal));
            X towards = magnitude(speed);
            if (first == nullptr || graze::sign(X(height * first_speed - first_height * towards)) < 0) {
                first = &c;
                first_height = std::move(height);
                first_speed = std::move(towards);
            }
        }
        return first != nullptr ? first->standing : standing_image{};
    }
    [[nodiscard]] standing_image first_at_apex(const direction& u) const {
        const cone<N, X>* blocked = nullptr;
        for (const cone<N, X>& c : cones_) {
            if (is_of(c, left_) || c.way == approach::along) {
                continue;
            }
            if (is_reached(c, u)) {
                return c.standing;
            }
            blocked = blocked != nullptr ? blocked : &c;
        }
        return blocked != nullptr && !keeps_aside() ? blocked->standing : standing_image{}; // where X rounds
    }
    [[nodiscard]] bool is_reached(const cone<N, X>& c, const direction& u) const {
        return c.way == approach::to_border || shift_into(c, cones_, u, u);
    }
    // Whether the point slides on a known side of a plane or wall: it reaches nothing beyond that.
    [[nodiscard]] bool keeps_aside() const noexcept {
        return std::any_of(cones_.begin(), cones_.end(),
                           [](const auto& c) { return c.way != approach::across && c.side != 0; });
    }

    // Where the line through place_ meets the plane of a cone, up to a positive factor.
    [[nodiscard]] direction crossing(const cone<N, X>& c, const direction& u) const {
        return magnitude(graze::dot(u, c.normal)) * place_ + magnitude(graze::dot(place_, c.normal)) * u;
    }
    // In 2D a cone has only two directions; the edge's number is the shortest for them.
    [[nodiscard]] static direction along(const cone<N, X>& c, direction y) {
        if constexpr (N == 2) {
            const direction edge = perpendicular(c.normal);
            const int sense = graze::sign(graze::dot(edge, y));
            return sense == 0 ? y : sense < 0 ? -edge : edge;
        } else {
            return y;
        }
    }

    cone_list cones_;
    direction place_; // of the point, up to a positive factor
    standing_image left_;
    standing_image next_;
};

} // namespace graze::inline v0_1::detail
