// Planes, walls and triangles as a point sees them, in a space with periods or without.
#pragma once

#include <graze/point/standing_shapes.hpp>
#include <graze/scene/body.hpp>
#include <graze/scene/box_walk.hpp>
#include <graze/scene/images.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>

namespace graze::inline v0_1::detail {

// All images of all shapes, from where one point is. The shapes must outlive this.
template <mechanics M>
class standing_images {
  public:
    static constexpr int dimension = M::dimension;
    using exact = typename M::exact;
    using state = typename M::state;
    using shapes = standing_shapes<M>;

    // gone: how many periods the point has gone back.
    standing_images(const shapes& all, const images<M>& space, image_index gone)
        : shapes_(all), space_(space), gone_(gone) {}

    [[nodiscard]] body begin() const noexcept { return shapes_.begin(); }
    [[nodiscard]] body end() const noexcept { return shapes_.end(); }
    // Whether b is one of several images.
    [[nodiscard]] bool has_images(body b) const noexcept { return space_.is_periodic() && !shapes_.is_plane(b); }
    // The image of b that is b itself, as the point flies.
    [[nodiscard]] standing_image itself(body b) const noexcept { return {b, has_images(b) ? gone_ : image_index{}}; }

    // Where something is, in doubles.
    struct box {
        vec<dimension, double> low, high;
    };
    // Where the point is at a time, and all that the roundings of that place may confuse with it.
    [[nodiscard]] box around(const M& m, const state& x, double when) const {
        const flight<dimension, double> f = m.about(x);
        box b;
        for (int i = 0; i < dimension; ++i) {
            const double u = f.state.velocity[i], at = f.state.position[i] + u * (when - f.since);
            const double off =
                0x1p-40 * (std::fabs(f.state.position[i]) + std::fabs(u) * (std::fabs(when) + std::fabs(f.since)));
            b.low.component[i] = at - off;
            b.high.component[i] = at + off;
        }
        return b;
    }
    [[nodiscard]] box around(const M& m, const state& x) const { return around(m, x, m.about(x).since); }
    [[nodiscard]] box around(const M& m, const standing_image& b) const {
        const auto extent = shapes_.extent(m, b.what);
        const auto period = shapes::in_doubles(m, space_.period());
        const whole_periods there = has_images(b.what) ? b.image - gone_ : image_index{};
        const auto shift = make_vec<dimension>([&](int i) { return there[static_cast<std::size_t>(i)] * period[i]; });
        return {extent.low + shift, extent.high + shift};
    }
    // f(b) for each image that may have a place in that box, in canonical order.
    template <class F>
    void for_each_near(const M& m, const box& near, F f) const {
        for (body b = begin(); b < end(); ++b) {
            if (!has_images(b)) {
                f(standing_image{b});
                continue;
            }
            const auto extent = shapes_.extent(m, b);
            const auto period = shapes::in_doubles(m, space_.period());
            whole_periods low{}, high{};
            for (int i = 0; i < dimension; ++i) {
                if (period[i] > 0) {
                    const auto axis = static_cast<std::size_t>(i);
                    const double off = 0x1p-40 * (period[i] + std::fabs(extent.low[i]) + std::fabs(extent.high[i]));
                    low[axis] = whole(std::ceil((near.low[i] - off - extent.high[i]) / period[i]));
                    high[axis] = whole(std::floor((near.high[i] + off - extent.low[i]) / period[i]));
                }
            }
            for_each_in_box(low, high, [&](const whole_periods& there) {
                f(standing_image{b, image_index(there) + gone_});
            });
        }
    }

    // Without rounding.
    [[nodiscard]] static vec<dimension, exact> exactly(const M& m, const vec<dimension, typename M::number>& x) {
        return shapes::exactly(m, x);
    }

    // A plane, wall or triangle without rounding: a place in it, its edges, if any, and its normal.
    struct exact_shape {
        vec<dimension, exact> point;
        std::array<vec<dimension, exact>, dimension - 1> edges{};
        vec<dimension, exact> normal;
        bool is_plane = false, is_triangle = false;
    };
    [[nodiscard, gnu::noinline]] exact_shape exactly(const M& m, const standing_image& b) const {
        return with(b, [&](const auto& s) -> exact_shape {
            if constexpr (requires { s.edge; }) {
                const auto edges = shapes::edges_of(m, s);
                return {exactly(m, s.corner), edges, face_normal(edges), false,
                        detail::is_triangle<std::remove_cvref_t<decltype(s)>>};
            } else {
                return {exactly(m, s.point), {}, exactly(m, s.normal), true, false};
            }
        });
    }

    // What the mechanics answers about a point and b; each is compiled once for all shapes.
    [[nodiscard, gnu::noinline]] std::optional<typename M::time> meet(const M& m, const standing_image& b,
                                                                      const state& x) const {
        return with(b, [&](const auto& s) { return m.meet(x, s); });
    }
    [[nodiscard, gnu::noinline]] int side(const M& m, const standing_image& b, const state& x) const {
        return with(b, [&](const auto& s) { return m.side(x, s); });
    }
    [[nodiscard, gnu::noinline]] int heading(const M& m, const standing_image& b, const state& x) const {
        return with(b, [&](const auto& s) { return m.heading(x, s); });
    }
    [[nodiscard, gnu::noinline]] typename M::time reach(const M& m, const standing_image& b, const state& x) const {
        return with(b, [&](const auto& s) { return m.reach(x, s); });
    }
    [[gnu::noinline]] void turn_back(const M& m, const standing_image& b, state& x) const {
        with(b, [&](const auto& s) { m.turn_back(x, s); });
    }
    [[gnu::noinline]] void bounce(const M& m, const standing_image& b, state& x, const typename M::time& when) const {
        with(b, [&](const auto& s) { m.bounce(x, s, when); });
    }

  private:
    // f(s) for that image s of a plane, wall or triangle.
    template <class F>
    auto with(const standing_image& b, F f) const {
        return shapes_.with(b.what, [&](const auto& s) { return space_.with_image(s, b.image - gone_, f); });
    }
    [[nodiscard]] static std::int32_t whole(double x) noexcept {
        return static_cast<std::int32_t>(std::clamp(x, -0x1p30, 0x1p30));
    }

    const shapes& shapes_;
    const images<M>& space_;
    image_index gone_;
};

} // namespace graze::inline v0_1::detail
