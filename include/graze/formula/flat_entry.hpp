// Which feature of a flat shape a ball touches first: the one that is the closest at the touch. So no two times are
// compared.
#pragma once

#include <graze/formula/flat_sight.hpp>

#include <algorithm>

namespace graze::inline v0_1 {

template <int N, class T, class Judge>
class flat_entry : public flat_sight<N, T, Judge> {
  public:
    using flat_sight<N, T, Judge>::flat_sight;

    // The feature that is touched first, in the order of ties; a miss if none is.
    [[nodiscard, gnu::noinline]] constexpr flat_answer entry() const {
        bool doubt = false;
        bool grazes = false;
        const auto met = [&](verdict v) {
            const bool first = v == alone || (v == shared && !doubt);
            doubt = doubt || v == perhaps || v == shared;
            return first;
        };
        if (met(enters_face())) {
            return {true, encounter::hit, feature::face, 0};
        }
        if constexpr (N == 3) {
            for (int k = 0; k < borders(); ++k) {
                if (met(enters_edge(k, grazes))) {
                    return {true, grazes ? encounter::graze : encounter::hit, feature::edge, k};
                }
            }
        }
        for (int i = 0; i < (N == 2 ? 2 : borders()); ++i) {
            if (met(enters_corner(i, grazes))) {
                return {true, grazes ? encounter::graze : encounter::hit, feature::corner, i};
            }
        }
        return {!doubt, encounter::miss};
    }

    // A hit or graze of this feature, if it certainly is touched and no other one is touched first. The ball then does
    // not overlap now, since the distance from a convex shape is convex in time.
    [[nodiscard]] constexpr flat_answer if_alone(const flat_answer& x) const {
        bool grazes = false;
        if (!is_collision(x.what) || x.what == encounter::overlap || enters(x, grazes) != alone) {
            return {};
        }
        return {true, grazes ? encounter::graze : encounter::hit, x.where, x.index};
    }

  protected:
    using sight = flat_sight<N, T, Judge>;
    using sight::borders;
    using sight::clearance_of_plane;
    using sight::inside;
    using sight::judge_;
    using sight::m_;
    using sight::scope_of_judge;
    using sight::seen_from_border;
    using sight::seen_from_corner;
    using sight::way_;

  private:
    // Whether a feature is touched first: no, perhaps, yes together with others, or yes alone.
    enum verdict { no, perhaps, shared, alone };

    // The sign of x √p - y √q, p, q >= 0, by those of x, y and x² p - y² q.
    [[nodiscard]] static constexpr int root_difference(int x, int y, int norm) {
        if (x != open_sign && y != open_sign && x * y <= 0) {
            return x != 0 ? x : -y;
        }
        return norm == open_sign ? open_sign
               : norm == 0       ? (x == open_sign || y == open_sign ? open_sign : 0)
               : norm > 0        ? x
               : y == open_sign  ? open_sign
                                 : -y;
    }
    // Several conditions, each a sign that must not be -1, taken together.
    template <class... Signs>
    [[nodiscard]] static constexpr verdict all_of(Signs... signs) {
        return ((signs == -1) || ...)          ? no
               : ((signs == open_sign) || ...) ? perhaps
               : ((signs == 0) || ...)         ? shared
                                               : alone;
    }
    [[nodiscard]] constexpr verdict enters(const flat_answer& x, bool& grazes) const {
        if constexpr (N == 3) {
            if (x.where == feature::edge) {
                return enters_edge(x.index, grazes);
            }
        }
        return x.where == feature::face ? enters_face() : enters_corner(x.index, grazes);
    }
    [[nodiscard]] static constexpr int minus(int sign) { return sign == open_sign ? sign : -sign; }

    [[nodiscard]] constexpr verdict enters_face() const {
        const int speed = judge_(way_speed{}, way_);
        const int height = judge_(way_height{}, way_);
        if (speed == open_sign || height == open_sign) {
            return perhaps;
        }
        if (speed * height != -1) {
            return no;
        }
        verdict v = all_of(clearance_of_plane());
        v = v == shared ? alone : v; // on the face now
        if constexpr (Judge::has_roots) {
            const T sense(speed < 0 ? T(-1) : T(1));
            flat_touch<N, T> touch{T(0), way_.facing * sense, m_.r, way_.at, way_.pull};
            if (!judge_.root(way_.nn, touch.length)) {
                return perhaps;
            }
            for (auto& at : touch.at) {
                at = at * sense;
            }
            for (int k = 0; k < borders() && v != no; ++k) {
                v = std::min(v, all_of(judge_(touch_inside{k, m_.is_triangle}, touch)));
            }
        } else {
            for (int k = 0; k < borders() && v != no; ++k) {
                const int inward = graze::sign(m_.r) == 0 ? 0 : judge_(inward_speed{k, m_.is_triangle}, way_);
                v = std::min(v, all_of(root_difference(inside(way_, k, speed), inward,
                                                       judge_(touch_inside_norm{k, m_.is_triangle}, way_))));
            }
        }
        return v;
    }
    [[nodiscard]] constexpr verdict enters_edge(int k, bool& grazes) const {
        [[maybe_unused]] const auto scope = scope_of_judge();
        const auto x = seen_from_border(k);
        const int d = judge_(border_discriminant{}, x);
        const verdict v = all_of(judge_above(minus(judge_(border_h{}, x))), above(judge_(border_c{}, x)), above(d));
        if (v == no || v == perhaps) {
            return v;
        }
        grazes = d == 0;
        const int u = d == 0 ? 0 : judge_(direction_speed{}, x);
        const int start =
            root_difference(judge_(nearest_from_start{}, x), u, judge_(touch_along_norm<nearest_from_start>{}, x));
        const int end =
            root_difference(judge_(nearest_from_end{}, x), u, judge_(touch_along_norm<nearest_from_end>{}, x));
        const int inward = judge_(touch_inward{}, x);
        const int outside =
            root_difference(judge_(touch_outside{}, x), d == 0 ? 0 : inward, judge_(touch_outside_norm{}, x));
        if (d == 0 && (inward == -1 || inward == open_sign)) { // does it slide along the face and leave it here?
            const int speed = judge_(way_speed{}, way_);
            if (speed == 0 && inward == -1) {
                return no;
            }
            if (speed == 0 || speed == open_sign) {
                return perhaps;
            }
        }
        return all_of(start, minus(end), minus(outside));
    }
    [[nodiscard]] constexpr verdict enters_corner(int corner, bool& grazes) const {
        int first = corner; // of the borders that meet here
        if constexpr (N == 3) {
            first = m_.is_triangle ? (corner == 1 ? 1 : 0) : corner % 2;
        }
        const int count = N == 2 ? 1 : 2;
        verdict v = alone;
        const int speed = judge_(way_speed{}, way_);
        bool slides_off = speed == 0; // along the face, over no border inwards
        bool stays_on = speed == 1 || speed == -1;
        for (int j = 0; j < count; ++j) {
            const int k = j == 0 ? first : other_border(corner, first, m_.is_triangle);
            [[maybe_unused]] const auto scope = scope_of_judge();
            const auto x = seen_from_corner(corner, k);
            const int d = judge_(corner_discriminant{}, x);
            grazes = d == 0;
            v = std::min(v, all_of(judge_above(minus(judge_(corner_h{}, x))), above(judge_(corner_c{}, x)), above(d)));
            if (v == no) {
                return no;
            }
            v = std::min(v, all_of(minus(root_difference(judge_(nearest_from_start{}, x),
                                                         d == 0 ? 0 : judge_(direction_speed{}, x),
                                                         judge_(touch_behind_norm{}, x)))));
            if (!stays_on) {
                const int inward = judge_(inward_speed{k, m_.is_triangle}, way_);
                slides_off = slides_off && inward < 1;
                stays_on = inward == 1;
            }
        }
        return !grazes || stays_on ? v : slides_off ? no : std::min(v, perhaps);
    }
    // A condition > 0, and one >= 0 whose 0 is shared with no other feature.
    [[nodiscard]] static constexpr int judge_above(int sign) { return sign == 0 ? -1 : sign; }
    [[nodiscard]] static constexpr int above(int sign) { return sign == 0 ? 1 : sign; }
};

} // namespace graze::inline v0_1
