// A flat shape as a ball sees it: the numbers of its plane, its borders and its corners, and their signs.
#pragma once

#include <graze/formula/flat_edge.hpp>
#include <graze/formula/flat_way.hpp>
#include <graze/formula/wall_encounter.hpp>

namespace graze::inline v0_1 {

// A sign that a number type leaves open.
inline constexpr int open_sign = 2;

// wall_encounter, if it is certain. The feature is set for overlap (the closest now), hit and graze.
struct flat_answer {
    bool certain = false;
    encounter what = encounter::recede;
    feature where = feature::face;
    int index = 0;
};

namespace detail {

// The sign of x √p - y √q, p, q >= 0, by those of x, y and x² p - y² q. A call would cost an aimed ball's time 2%.
[[nodiscard, gnu::always_inline]] constexpr inline int root_difference(int x, int y, int norm) noexcept {
    if (x != open_sign && y != open_sign && x * y <= 0) {
        return x != 0 ? x : -y;
    }
    return norm == open_sign ? open_sign
           : norm == 0       ? (x == open_sign || y == open_sign ? open_sign : 0)
           : norm > 0        ? x
           : y == open_sign  ? open_sign
                             : -y;
}

} // namespace detail

// judge(F{}, numbers) is the sign of F(numbers), or open_sign. If it has a scope(), the end of that gives back the
// memory of numbers made meanwhile. If it has_roots, judge.root(x, y) makes y the root of x > 0, if it can. A judge
// that sees_no_zero never says 0.
template <int N, class T, class Judge>
class flat_view {
  public:
    constexpr flat_view(const flat_motion<N, T>& m, const flat_way<N, T>& way, const Judge& judge)
        : m_(m), way_(way), judge_(judge) {}

    static constexpr bool sees_zero = !requires { Judge::sees_no_zero; };

    [[nodiscard]] constexpr bool is_triangle() const { return m_.is_triangle; }
    [[nodiscard, gnu::always_inline]] constexpr auto scope() const {
        if constexpr (requires { judge_.scope(); }) {
            return judge_.scope();
        } else {
            return nullptr;
        }
    }

    template <class F>
    [[nodiscard, gnu::always_inline]] constexpr int of_way(F f) const {
        return judge_(f, way_);
    }
    // A judge that can do more with the motion is given it.
    [[nodiscard, gnu::always_inline]] constexpr int clearance_of_plane() const {
        if constexpr (requires { judge_(way_clearance{}, way_, m_); }) {
            return judge_(way_clearance{}, way_, m_);
        } else {
            return judge_(way_clearance{}, way_);
        }
    }

    [[nodiscard, gnu::always_inline]] constexpr flat_place<N, T> place() const { return place_of(m_, way_); }
    [[nodiscard, gnu::always_inline]] constexpr int inside_of(const flat_place<N, T>& x, int k) const {
        return judge_(inside_border{k, m_.is_triangle}, x);
    }

    // The numbers of the touch of the face, for a ball that moves to the side `sense` of it.
    struct touch_numbers {
        flat_touch<N, T> numbers;
        bool good;
    };
    [[nodiscard, gnu::always_inline]] constexpr auto touch(int sense) const {
        if constexpr (Judge::has_roots) {
            const T sign(sense < 0 ? T(-1) : T(1));
            touch_numbers x{{T(0), way_.facing * sign, m_.r, way_.at, way_.pull}, false};
            x.good = judge_.root(way_.nn, x.numbers.length);
            for (auto& at : x.numbers.at) {
                at = at * sign;
            }
            return x;
        } else {
            return sense;
        }
    }
    template <class Touch>
    [[nodiscard, gnu::always_inline]] static constexpr bool is_known(const Touch& x) {
        if constexpr (Judge::has_roots) {
            return x.good;
        } else {
            return true;
        }
    }
    // Whether the ball then is inside of border k, for numbers that are known.
    template <class Touch>
    [[nodiscard, gnu::always_inline]] constexpr int inside_at_touch(int k, const Touch& x) const {
        if constexpr (Judge::has_roots) {
            return judge_(touch_inside{k, m_.is_triangle}, x.numbers);
        } else {
            const int inside = judge_(inside_border{k, m_.is_triangle}, way_);
            const int inward = graze::sign(m_.r) == 0 ? 0 : judge_(inward_speed{k, m_.is_triangle}, way_);
            return detail::root_difference(inside == open_sign ? inside : inside * x, inward,
                                           judge_(touch_inside_norm{k, m_.is_triangle}, way_));
        }
    }

    template <class F>
    [[nodiscard, gnu::always_inline]] constexpr int of_feature(F f, const flat_edge<N, T>& x) const {
        return judge_(f, x);
    }
    [[nodiscard]] constexpr flat_edge<N, T> seen_from_border(int k) const {
        if constexpr (N == 2) {
            return seen_from_corner(k, k);
        } else {
            auto x = edge_of(centre_from(m_, ends_of_border(k, m_.is_triangle).start), m_.u, direction_of_border(m_, k),
                             m_.r, inside_border{k, m_.is_triangle}(way_), inward_speed{k, m_.is_triangle}(way_),
                             way_.speed);
            x.border = k;
            return x;
        }
    }
    // Of a corner, with the direction inwards along border k.
    [[nodiscard]] constexpr flat_edge<N, T> seen_from_corner(int corner, int k) const {
        return corner_along(corner, direction_from(m_, corner, k));
    }
    // Of a corner, where no direction matters.
    [[nodiscard, gnu::always_inline]] constexpr flat_edge<N, T> seen_from_corner(int corner) const {
        return corner_along(corner, m_.e[0]);
    }

  private:
    [[nodiscard]] constexpr flat_edge<N, T> corner_along(int corner, const vec<N, T>& d) const {
        auto x = corner_of(centre_from(m_, corner), m_.u, d, m_.r, way_.speed);
        x.corner = corner;
        return x;
    }

    const flat_motion<N, T>& m_;
    const flat_way<N, T>& way_;
    const Judge& judge_;
};

} // namespace graze::inline v0_1
