// Balls and a flat shape in lanes: the encounter as flat_decision has it, by the same signs.
#pragma once

#include <graze/formula/flat_encounter.hpp>
#include <graze/predicate/lane_judge.hpp>

#include <array>
#include <type_traits>
#include <utility>

namespace graze::inline v0_1::detail {

// f(k) for k = 0, ..., Count - 1, each a constant.
template <int Count, class F>
[[gnu::always_inline]] inline void each_constant(const F& f) {
    [&]<int... K>(std::integer_sequence<int, K...>) __attribute__((always_inline)) {
        (f(std::integral_constant<int, K>{}), ...);
    }
    (std::make_integer_sequence<int, Count>{});
}

// A ball in each lane, and one shape. Nothing branches: every feature is asked, and counts in the lanes in which it is
// certainly the nearest one.
template <int N, class T, class V, bool IsTriangle>
class lane_flat {
    using mask = typename V::mask;
    using sign = lane_sign<V>;
    static constexpr int borders = borders_of(N, IsTriangle);

    const flat_motion<N, V>& m_;
    const lane_judge<N, T, V>& judge_;
    const flat_way<N, V> way_;

  public:
    [[gnu::always_inline]] lane_flat(const flat_motion<N, V>& m, const lane_judge<N, T, V>& judge) noexcept
        : m_(m), judge_(judge), way_(way_of(m)) {}

    // The lanes in which the two certainly come no closer, miss each other, are inside each other and getting deeper,
    // and hit.
    struct encounters {
        mask parting, missing, inside, hitting;
    };
    [[nodiscard, gnu::always_inline]] encounters what() const noexcept {
        const sign speed = judge_(way_speed{}, way_);
        const sign receding = judge_(way_height{}, way_) * speed;
        mask parting{}, missing{}, meeting{};
        const auto count = [&](const mask& nearest, const sign& h, const sign& d) __attribute__((always_inline)) {
            parting = parting | (nearest & h.positive);
            missing = missing | (nearest & h.negative & d.negative);
            meeting = meeting | (nearest & h.negative & d.positive);
        };
        const mask face = each_nearest<nearest_from_start, nearest_from_end>(
            [&](int k) __attribute__((always_inline)) {
                return judge_(inside_border{k, IsTriangle}, way_) * speed;
            },
            [&](const mask& nearest, const auto& edge) __attribute__((always_inline)) {
                count(nearest, judge_(border_h{}, edge), judge_(border_discriminant{}, edge));
            },
            [&](const mask& nearest, const auto& corner) __attribute__((always_inline)) {
                count(nearest, judge_(corner_h{}, corner), judge_(corner_discriminant{}, corner));
            });
        parting = parting | (face & receding.positive);
        meeting = (meeting | (face & receding.negative)) & speed.certain();
        const sign now = clearance();
        return {parting & speed.certain(), missing & speed.certain(), meeting & now.negative, meeting & now.positive};
    }
    // The sign of the centre's distance now, less r.
    [[nodiscard, gnu::always_inline]] sign clearance() const noexcept {
        const sign of_plane = judge_(way_clearance{}, way_);
        const auto place = place_of(m_, way_);
        sign found{of_plane.positive, {}};
        const auto count = [&](const mask& nearest, const sign& c) __attribute__((always_inline)) {
            found.positive = found.positive | (nearest & c.positive);
            found.negative = found.negative | (nearest & c.negative);
        };
        const mask face = each_nearest<foot_from_start, foot_from_end>(
            [&](int k) __attribute__((always_inline)) {
                return judge_(inside_border{k, IsTriangle}, place);
            },
            [&](const mask& nearest, const auto& edge)
                __attribute__((always_inline)) { count(nearest, judge_(border_c{}, edge)); },
            [&](const mask& nearest, const auto& corner)
                __attribute__((always_inline)) { count(nearest, judge_(corner_c{}, corner)); });
        count(face, of_plane);
        return found;
    }

  private:
    // As flat_sight::nearest: tells of_edge and of_corner the lanes in which each edge and each corner is nearest to a
    // line, and its numbers. Returns the lanes in which the face is.
    template <class Start, class End, class Inside, class OfEdge, class OfCorner>
    [[nodiscard, gnu::always_inline]] mask each_nearest(const Inside& inside, const OfEdge& of_edge,
                                                        const OfCorner& of_corner) const noexcept {
        mask face = ~mask{};
        std::array<mask, borders> outside{}, before_start{}, beyond_end{};
        each_constant<borders>([&](auto k) __attribute__((always_inline)) {
            const sign side = inside(k);
            face = face & side.positive;
            outside[k] = side.negative;
            if constexpr (N == 3) {
                const auto x = this->edge(k);
                const sign start = judge_(Start{}, x), end = judge_(End{}, x);
                before_start[k] = start.negative;
                beyond_end[k] = end.positive;
                of_edge(side.negative & start.positive & end.negative, x);
            }
        });
        each_constant<borders>([&](auto i) __attribute__((always_inline)) {
            if constexpr (N == 2) {
                of_corner(outside[i], this->corner(i));
            } else { // which lies beyond the ends of two edges
                constexpr int first = IsTriangle ? (i == 1 ? 1 : 0) : i % 2;
                constexpr int second = other_border(i, first, IsTriangle);
                const auto beyond = [&](auto k) __attribute__((always_inline)) {
                    return ends_of_border(k, IsTriangle).start == i ? before_start[k] : beyond_end[k];
                };
                of_corner(beyond(std::integral_constant<int, first>{}) & beyond(std::integral_constant<int, second>{}),
                          this->corner(i));
            }
        });
        return face;
    }
    [[nodiscard, gnu::always_inline]] flat_edge<N, V> edge(int k) const noexcept {
        return edge_of(centre_from(m_, ends_of_border(k, IsTriangle).start), m_.u, direction_of_border(m_, k), m_.r,
                       inside_border{k, IsTriangle}(way_), inward_speed{k, IsTriangle}(way_), way_.speed);
    }
    [[nodiscard, gnu::always_inline]] flat_edge<N, V> corner(int i) const noexcept {
        return corner_of(centre_from(m_, i), m_.u, m_.e[0], m_.r, way_.speed);
    }
};

} // namespace graze::inline v0_1::detail
