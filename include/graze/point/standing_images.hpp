// What a mechanics answers a point about planes, walls and triangles, in a space with periods or without.
#pragma once

#include <graze/point/standing.hpp>
#include <graze/point/standing_shapes.hpp>
#include <graze/scene/images.hpp>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <type_traits>

namespace graze::inline v0_1::detail {

// The questions of points as those that one mechanics answers ask them.
template <mechanics M>
using standing_parts_of = standing_parts<M::dimension, typename M::state, typename M::exact>;

// The shapes, the space and the instant must outlive this.
template <mechanics M>
class standing_images final : public standing_parts_of<M> {
  public:
    static constexpr int dimension = M::dimension;
    using exact = typename M::exact;
    using state = typename M::state;
    using time = typename M::time;
    using shapes = standing_shapes<M>;
    using base = standing_parts_of<M>;
    using typename base::numbers;
    using typename base::vector;

    // gone: how many periods the point has gone back. when: the instant, if one is asked about.
    standing_images(const shapes& all, const images<M>& space, image_index gone, const time* when = nullptr)
        : base({all.begin(), all.first_wall(), all.end()}, space.is_periodic(), gone, M::rounds), shapes_(all),
          space_(space), when_(when) {}

    // When x meets b.
    [[nodiscard]] std::optional<time> time_of(const standing_image& b, const state& x) const {
        return ask(question::meet, b, x).when;
    }
    [[nodiscard]] int side(const standing_image& b, const state& x) const override {
        return ask(question::side, b, x).sign;
    }
    [[nodiscard]] int heading(const standing_image& b, const state& x) const override {
        return ask(question::heading, b, x).sign;
    }
    void turn_back(const standing_image& b, state& x) const override { ask(question::turn_back, b, x, &x); }
    void bounce(const standing_image& b, state& x) const override { ask(question::bounce, b, x, &x); }
    [[nodiscard]] vec<dimension, exact> exactly(const vector& x) const override {
        return make_vec<dimension>([&](int i) { return rules().as_exact(x[i]); });
    }
    [[nodiscard]] meeting meets(const standing_image& b, const state& x) const override {
        const std::optional<time> t = time_of(b, x);
        return !t ? meeting::never : is_then(*t) ? meeting::then : meeting::elsewhen;
    }
    [[nodiscard]] bool is_since(const state& x) const override { return is_then(rules().now(x)); }
    [[nodiscard]] int after_reaching(const standing_image& b, const state& x) const override {
        return rules().order(*when_, *ask(question::reach, b, x).when);
    }

  private:
    enum class question : std::uint8_t { meet, reach, side, heading, turn_back, bounce };
    struct answer {
        int sign = 0;
        std::optional<time> when;
    };

    [[nodiscard]] const M& rules() const noexcept { return space_.rules(); }
    [[nodiscard]] bool is_then(const time& t) const {
        return rules().bounds(t).lower <= latest() && rules().order(t, *when_) == 0;
    }
    // All in one function: each question is compiled once for a kind of shape.
    [[gnu::noinline]] answer ask(question what, const standing_image& b, const state& x,
                                 state* changing = nullptr) const {
        return with(b, [&](const auto& s) -> answer {
            switch (what) {
            case question::meet:
                return {0, rules().meet(x, s)};
            case question::reach:
                return {0, rules().reach(x, s)};
            case question::side:
                return {rules().side(x, s), {}};
            case question::heading:
                return {rules().heading(x, s), {}};
            case question::turn_back:
                rules().turn_back(*changing, s);
                return {};
            case question::bounce:
                rules().bounce(*changing, s, *when_);
                return {};
            }
            return {};
        });
    }
    [[nodiscard]] numbers numbers_of(const standing_image& b) const override {
        return with(b, [&](const auto& s) -> numbers {
            if constexpr (requires { s.edge; }) {
                numbers result{s.corner, {}, {}, false, is_triangle<std::remove_cvref_t<decltype(s)>>};
                std::copy(s.edge.begin(), s.edge.end(), result.edges.begin());
                return result;
            } else {
                return {s.point, {}, s.normal, true, false};
            }
        });
    }
    [[nodiscard]] flight<dimension, double> about(const state& x) const override { return rules().about(x); }
    [[nodiscard]] standing_extent<dimension> extent(body b) const override { return shapes_.extent(rules(), b); }
    [[nodiscard]] vec<dimension, double> period() const override {
        return shapes::in_doubles(rules(), space_.period());
    }
    [[nodiscard]] double latest() const override { return rules().bounds(*when_).upper; }

    // f(s) for that image s of a plane, wall or triangle.
    template <class F>
    auto with(const standing_image& b, F f) const {
        return shapes_.with(b.what, [&](const auto& s) { return space_.with_image(s, b.image - this->gone(), f); });
    }

    const shapes& shapes_;
    const images<M>& space_;
    const time* when_;
};

} // namespace graze::inline v0_1::detail
