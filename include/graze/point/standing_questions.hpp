// What a point asks about the planes and walls of a run: compiled once for all mechanics that have these states.
#pragma once

#include <graze/formula/wall_features.hpp>
#include <graze/scene/body.hpp>
#include <graze/scene/box_walk.hpp>
#include <graze/scene/records.hpp>
#include <graze/scene/standing_extent.hpp>
#include <graze/shape/flight.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace graze::inline v0_1::detail {

// When a point meets something: not at all, at the instant in question, or at another one.
enum class meeting : std::uint8_t { never, then, elsewhen };

// A plane, wall or triangle: a place in it, its edges, if any, and its normal.
template <class Vector, std::size_t Edges>
struct shape_numbers {
    Vector point;
    std::array<Vector, Edges> edges{};
    Vector normal;
    bool is_plane = false, is_triangle = false;
};

// All images of all planes, walls and triangles, from where one point is, at one instant. State: a ball in flight. X:
// exact numbers. What a mechanics answers is asked of standing_images.
template <int N, class State, class X>
class standing_questions {
  public:
    static constexpr int dimension = N;
    using state = State;
    using exact = X;
    using vector = std::remove_cvref_t<decltype(std::declval<const State&>().state.velocity)>;
    using shape = shape_numbers<vec<N, X>, N - 1>;
    using numbers = shape_numbers<vector, N - 1>; // as given, and no normal of a wall

    [[nodiscard]] body begin() const noexcept { return first_; }
    [[nodiscard]] body end() const noexcept { return end_; }
    // Whether the mechanics rounds, which may carry a point elsewhere.
    [[nodiscard]] bool rounds() const noexcept { return rounds_; }
    // Whether b is one of several images.
    [[nodiscard]] bool has_images(body b) const noexcept { return is_periodic_ && b >= first_wall_; }
    // The image of b that is b itself, as the point flies.
    [[nodiscard]] standing_image itself(body b) const noexcept { return {b, has_images(b) ? gone_ : image_index{}}; }

    // Of the mechanics.
    [[nodiscard]] virtual int side(const standing_image& b, const State& x) const = 0;
    [[nodiscard]] virtual int heading(const standing_image& b, const State& x) const = 0;
    virtual void turn_back(const standing_image& b, State& x) const = 0;
    virtual void bounce(const standing_image& b, State& x) const = 0; // at that instant
    // Without rounding.
    [[nodiscard]] virtual vec<N, X> exactly(const vector& x) const = 0;
    [[nodiscard, gnu::noinline]] shape exactly(const standing_image& b) const {
        const numbers given = numbers_of(b);
        shape result{exactly(given.point), {}, {}, given.is_plane, given.is_triangle};
        if (given.is_plane) {
            result.normal = exactly(given.normal);
        } else {
            std::transform(given.edges.begin(), given.edges.end(), result.edges.begin(),
                           [&](const vector& e) { return exactly(e); });
            result.normal = face_normal(result.edges);
        }
        return result;
    }

    // When x meets b.
    [[nodiscard]] virtual meeting meets(const standing_image& b, const State& x) const = 0;
    // Whether that instant is the time since which x flies.
    [[nodiscard]] virtual bool is_since(const State& x) const = 0;
    // The sign of that instant minus the one at which x, which comes nearer, reaches the plane of b.
    [[nodiscard]] virtual int after_reaching(const standing_image& b, const State& x) const = 0;

    // Where something is, in doubles.
    struct box {
        vec<N, double> low, high;
    };
    // Where the point is at that instant, and all that the roundings of that place may confuse with it.
    [[nodiscard]] box around_then(const State& x) const { return around(about(x), latest()); }
    // The same at the time since which it flies.
    [[nodiscard]] box around(const State& x) const {
        const flight<N, double> f = about(x);
        return around(f, f.since);
    }
    [[nodiscard]] box around(const standing_image& b) const {
        const standing_extent<N> at = extent(b.what);
        const vec<N, double> lengths = period();
        const whole_periods there = has_images(b.what) ? b.image - gone_ : image_index{};
        const auto shift = make_vec<N>([&](int i) { return there[static_cast<std::size_t>(i)] * lengths[i]; });
        return {at.low + shift, at.high + shift};
    }
    // Each image that may have a place in that box, in canonical order.
    [[nodiscard]] records<standing_image> near(const box& where) const {
        records<standing_image> found;
        for (body b = begin(); b < end(); ++b) {
            if (!has_images(b)) {
                found.push_back({b});
                continue;
            }
            const standing_extent<N> at = extent(b);
            const vec<N, double> lengths = period();
            whole_periods low{}, high{};
            for (int i = 0; i < N; ++i) {
                if (lengths[i] > 0) {
                    const auto axis = static_cast<std::size_t>(i);
                    const double off = 0x1p-40 * (lengths[i] + std::fabs(at.low[i]) + std::fabs(at.high[i]));
                    low[axis] = whole(std::ceil((where.low[i] - off - at.high[i]) / lengths[i]));
                    high[axis] = whole(std::floor((where.high[i] + off - at.low[i]) / lengths[i]));
                }
            }
            for_each_in_box(low, high, [&](const whole_periods& there) {
                found.push_back({b, image_index(there) + gone_});
            });
        }
        return found;
    }

  protected:
    // Bodies from first to end, planes before walls.
    struct bodies {
        body first, first_wall, end;
    };
    // gone: how many periods the point has gone back.
    standing_questions(const bodies& all, bool is_periodic, image_index gone, bool rounds) noexcept
        : first_(all.first), first_wall_(all.first_wall), end_(all.end), is_periodic_(is_periodic), rounds_(rounds),
          gone_(gone) {}
    ~standing_questions() = default;

    [[nodiscard]] image_index gone() const noexcept { return gone_; }

  private:
    [[nodiscard]] virtual numbers numbers_of(const standing_image& b) const = 0;
    // In doubles.
    [[nodiscard]] virtual flight<N, double> about(const State& x) const = 0;
    [[nodiscard]] virtual standing_extent<N> extent(body b) const = 0;
    [[nodiscard]] virtual vec<N, double> period() const = 0;
    [[nodiscard]] virtual double latest() const = 0; // not before that instant

    [[nodiscard]] static box around(const flight<N, double>& f, double when) {
        box b;
        for (int i = 0; i < N; ++i) {
            const double u = f.state.velocity[i], at = f.state.position[i] + u * (when - f.since);
            const double off =
                0x1p-40 * (std::fabs(f.state.position[i]) + std::fabs(u) * (std::fabs(when) + std::fabs(f.since)));
            b.low.component[i] = at - off;
            b.high.component[i] = at + off;
        }
        return b;
    }
    [[nodiscard]] static std::int32_t whole(double x) noexcept {
        return static_cast<std::int32_t>(std::clamp(x, -0x1p30, 0x1p30));
    }

    body first_, first_wall_, end_;
    bool is_periodic_, rounds_;
    image_index gone_;
};

} // namespace graze::inline v0_1::detail
