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
    using sight::is_triangle;
    using sight::of_feature;
    using sight::of_way;
    using sight::scope;
    using sight::seen_from_border;
    using sight::seen_from_corner;

  private:
    // Whether a feature is touched first: no, perhaps, yes together with others, or yes alone. The least of several
    // conditions is that of all.
    enum verdict { no, perhaps, shared, alone };

    // A condition by a sign that must not be -1.
    [[nodiscard]] static constexpr verdict verdict_of(int sign) {
        return sign == -1 ? no : sign == 0 ? shared : sign == 1 ? alone : perhaps;
    }
    [[nodiscard]] static constexpr verdict all_of(int x, int y, int z) {
        return std::min(std::min(verdict_of(x), verdict_of(y)), verdict_of(z));
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
        const int speed = of_way(way_speed{});
        const int height = of_way(way_height{});
        if (speed == open_sign || height == open_sign) {
            return perhaps;
        }
        if (speed * height != -1) {
            return no;
        }
        verdict v = verdict_of(clearance_of_plane());
        v = v == shared ? alone : v; // on the face now
        const auto touch = sight::touch(speed);
        if (!sight::is_known(touch)) {
            return perhaps;
        }
        for (int k = 0; k < borders() && v != no; ++k) {
            v = std::min(v, verdict_of(sight::inside_at_touch(k, touch)));
        }
        return v;
    }
    [[nodiscard]] constexpr verdict enters_edge(int k, bool& grazes) const {
        [[maybe_unused]] const auto here = scope();
        const auto x = seen_from_border(k);
        const int d = of_feature(border_discriminant{}, x);
        const verdict v =
            all_of(judge_above(minus(of_feature(border_h{}, x))), above(of_feature(border_c{}, x)), above(d));
        if (v == no || v == perhaps) {
            return v;
        }
        grazes = d == 0;
        const int u = d == 0 ? 0 : of_feature(direction_speed{}, x);
        const int start = detail::root_difference(of_feature(nearest_from_start{}, x), u,
                                                  of_feature(touch_along_norm<nearest_from_start>{}, x));
        const int end = detail::root_difference(of_feature(nearest_from_end{}, x), u,
                                                of_feature(touch_along_norm<nearest_from_end>{}, x));
        const int inward = of_feature(touch_inward{}, x);
        const int outside = detail::root_difference(of_feature(touch_outside{}, x), d == 0 ? 0 : inward,
                                                    of_feature(touch_outside_norm{}, x));
        if (d == 0 && (inward == -1 || inward == open_sign)) { // does it slide along the face and leave it here?
            const int speed = of_way(way_speed{});
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
            first = is_triangle() ? (corner == 1 ? 1 : 0) : corner % 2;
        }
        const int count = N == 2 ? 1 : 2;
        verdict v = alone;
        const int speed = of_way(way_speed{});
        bool slides_off = speed == 0; // along the face, over no border inwards
        bool stays_on = speed == 1 || speed == -1;
        for (int j = 0; j < count; ++j) {
            const int k = j == 0 ? first : other_border(corner, first, is_triangle());
            [[maybe_unused]] const auto here = scope();
            const auto x = seen_from_corner(corner, k);
            const int d = of_feature(corner_discriminant{}, x);
            grazes = d == 0;
            v = std::min(
                v, all_of(judge_above(minus(of_feature(corner_h{}, x))), above(of_feature(corner_c{}, x)), above(d)));
            if (v == no) {
                return no;
            }
            v = std::min(v, verdict_of(minus(detail::root_difference(of_feature(nearest_from_start{}, x),
                                                                     d == 0 ? 0 : of_feature(direction_speed{}, x),
                                                                     of_feature(touch_behind_norm{}, x)))));
            if (!stays_on) {
                const int inward = of_way(inward_speed{k, is_triangle()});
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
