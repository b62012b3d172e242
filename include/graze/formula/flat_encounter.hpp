// What becomes of a ball and a flat, convex thing, and which feature it meets: one procedure for every number type,
// which asks first what settles most pairs.
//
// A ball that is not over the thing now meets it exactly if its centre's line passes it at less than r. Where the line
// crosses the plane leaves one feature that is nearest to it: the face, an edge or a corner. That feature's h tells
// whether the ball comes closer at all, and its D whether it meets the thing. The feature that is touched first is the
// one that is the closest when it is touched, so that no two times are compared.
#pragma once

#include <graze/formula/encounter.hpp>
#include <graze/formula/flat_features.hpp>
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

// What is seen from afar: recede or miss of most pairs that are apart. Not certain if the edges may be parallel.
template <int N, class T, class Judge>
[[nodiscard, gnu::always_inline]] constexpr inline flat_answer from_afar(const flat_motion<N, T>& m,
                                                                         const Judge& judge) {
    const auto extent = extent_of(m);
    const auto edges = edges_of(m);
    if (judge(recedes_from_all{}, extent) == 1) {
        return {judge(edges_span{}, edges) == 1, encounter::recede};
    }
    if (judge(passes_beside{}, hull_of(m, edges)) == 1 && judge(recedes_from_any{}, extent) == -1) {
        return {judge(edges_span{}, edges) == 1, encounter::miss};
    }
    return {};
}

// judge(F{}, numbers) is the sign of F(numbers), or open_sign. Where it has a scope(), what numbers take while that
// lives is given back. Where it has_roots, judge.root(x, y) makes y
// that of x > 0, if it can.
template <int N, class T, class Judge>
class flat_decision {
  public:
    constexpr flat_decision(const flat_motion<N, T>& m, const flat_way<N, T>& way, const Judge& judge)
        : m_(m), way_(way), judge_(judge) {}

    // what alone; the feature is set by chance.
    [[nodiscard, gnu::always_inline]] constexpr flat_answer what() const {
        const int speed = judge_(way_speed{}, way_);
        if (speed == open_sign) {
            return {};
        }
        if (speed == 0) {
            return from_place();
        }
        const located near = nearest([&](int k) { return inside(way_, k, speed); },
                                     [&](int k) { return along<nearest_from_start, nearest_from_end>(k); });
        if (near.where == none) {
            return {};
        }
        int d = 1;
        if (near.where == feature::face) {
            const int height = judge_(way_height{}, way_);
            if (height == open_sign) {
                return {};
            }
            if (height != -speed) {
                return {true, encounter::recede};
            }
        } else {
            const auto x = seen_from_feature(near);
            const int h = approach(near, x);
            d = of_feature<border_discriminant, corner_discriminant>(near, x);
            if (h == open_sign) {
                return {};
            }
            if (h >= 0) {
                return {true, encounter::recede};
            }
            if (d == open_sign) {
                return {};
            }
            if (d < 0) {
                return {true, encounter::miss};
            }
            if (d == 0) {
                return {true, encounter::graze, near.where, near.index};
            }
        }
        const int inside = judge_(way_clearance{}, way_);
        if (inside == 0 || inside == 1) {
            return {true, encounter::hit, none};
        }
        return from_clearance();
    }

    // The feature of a hit.
    [[nodiscard]] constexpr flat_answer with_feature(flat_answer found) const {
        return found.certain && found.what == encounter::hit && found.where == none ? entry() : found;
    }
    [[nodiscard]] constexpr flat_answer operator()() const { return with_feature(what()); }

    // The numbers of the edge or the corner that was found.
    [[nodiscard]] constexpr flat_edge<T> numbers_of(const flat_answer& found) const {
        return seen_from_feature({found.where, found.index});
    }

    // Whether the centre is nearer than r now; negative if it is, open_sign if that is not certain.
    [[nodiscard]] constexpr int clearance() const {
        const int of_plane = judge_(way_clearance{}, way_);
        return of_plane == 0 || of_plane == 1 ? of_plane : clearance(nearest_now());
    }

  private:
    [[nodiscard, gnu::always_inline]] constexpr auto scope_of_judge() const {
        if constexpr (requires { judge_.scope(); }) {
            return judge_.scope();
        } else {
            return nullptr;
        }
    }

    static constexpr auto none = static_cast<feature>(3);
    struct located {
        feature where;
        int index;
    };

    // Which feature is nearest to a line that is not parallel to the plane. inside(k): the sign of inside_border;
    // along(k): -1 before the border's start, 0 on it, 1 beyond its end.
    template <class Inside, class Along>
    [[nodiscard, gnu::always_inline]] constexpr located nearest(Inside inside, Along along) const {
        bool all = true;
        for (int k = 0; k < borders(); ++k) {
            const int side = inside(k);
            all = all && (side == 0 || side == 1);
            if constexpr (N == 2) {
                if (side == -1) {
                    return {feature::corner, k};
                }
            } else if (side == -1) {
                const int where = along(k);
                if (where == 0) {
                    return {feature::edge, k};
                }
                if (where != open_sign) {
                    const auto ends = ends_of_border(k, m_.is_triangle);
                    const int corner = where < 0 ? ends.start : ends.end;
                    const int other = other_border(corner, k, m_.is_triangle);
                    if (along(other) == (ends_of_border(other, m_.is_triangle).start == corner ? -1 : 1)) {
                        return {feature::corner, corner};
                    }
                }
            }
        }
        return {all ? feature::face : none, 0};
    }
    [[nodiscard]] constexpr int borders() const { return borders_of(N, m_.is_triangle); }

    template <class W>
    [[nodiscard, gnu::always_inline]] constexpr int inside(const W& x, int k, int facing) const {
        const int side = judge_(inside_border{k, m_.is_triangle}, x);
        return side == open_sign ? side : side * facing;
    }
    template <class Start, class End>
    [[nodiscard, gnu::always_inline]] constexpr int along(int k) const {
        [[maybe_unused]] const auto scope = scope_of_judge();
        const auto x = seen_from_border(k);
        const int start = judge_(Start{}, x);
        const int end = judge_(End{}, x);
        return start == -1 ? -1 : end == 1 ? 1 : start == open_sign || end == open_sign ? open_sign : 0;
    }
    [[nodiscard]] constexpr located nearest_now() const {
        const auto place = place_of(m_, way_);
        return nearest([&](int k) { return inside(place, k, 1); },
                       [&](int k) { return along<foot_from_start, foot_from_end>(k); });
    }

    // The centre from corner i.
    [[nodiscard]] constexpr vec<N, T> centre_from(int corner) const {
        if constexpr (N == 2) {
            return corner == 0 ? m_.w : m_.w - m_.e[0];
        } else {
            return corner == 0   ? m_.w
                   : corner == 1 ? m_.w - m_.e[0]
                   : corner == 2 ? m_.w - m_.e[1]
                                 : m_.w - m_.e[0] - m_.e[1];
        }
    }
    // A border's direction from its start to its end.
    [[nodiscard]] constexpr vec<N, T> direction(int k) const {
        return k >= 2 ? m_.e[0] : k == 1 && m_.is_triangle ? m_.e[1] - m_.e[0] : m_.e[1];
    }
    [[nodiscard, gnu::always_inline]] constexpr flat_edge<T> seen_from_border(int k) const {
        if constexpr (N == 2) {
            return seen_from_corner(k, k);
        } else {
            return edge_of(centre_from(ends_of_border(k, m_.is_triangle).start), m_.u, direction(k), m_.r,
                           inside_border{k, m_.is_triangle}(way_), inward_speed{k, m_.is_triangle}(way_), way_.speed);
        }
    }
    // Of a corner, with the direction inwards along border k.
    [[nodiscard, gnu::always_inline]] constexpr flat_edge<T> seen_from_corner(int corner, int k) const {
        vec<N, T> d = m_.e[0];
        if constexpr (N == 2) {
            d = k == 0 ? d : -d;
        } else {
            d = ends_of_border(k, m_.is_triangle).start == corner ? direction(k) : -direction(k);
        }
        return edge_of(centre_from(corner), m_.u, d, m_.r, way_.speed, way_.speed, way_.speed);
    }
    [[nodiscard, gnu::always_inline]] constexpr flat_edge<T> seen_from_feature(located f) const {
        if constexpr (N == 3) {
            if (f.where == feature::edge) {
                return seen_from_border(f.index);
            }
        }
        return edge_of(centre_from(f.index), m_.u, m_.e[0], m_.r, way_.speed, way_.speed, way_.speed);
    }
    template <class Border, class Corner>
    [[nodiscard, gnu::always_inline]] constexpr int of_feature(located f, const flat_edge<T>& x) const {
        if constexpr (N == 3) {
            if (f.where == feature::edge) {
                return judge_(Border{}, x);
            }
        }
        return judge_(Corner{}, x);
    }
    [[nodiscard, gnu::always_inline]] constexpr int approach(located f, const flat_edge<T>& x) const {
        return of_feature<border_h, corner_h>(f, x);
    }
    [[nodiscard]] constexpr int clearance(located f) const {
        [[maybe_unused]] const auto scope = scope_of_judge();
        if (f.where == none) {
            return open_sign;
        }
        if (f.where == feature::face) {
            return judge_(way_clearance{}, way_);
        }
        return of_feature<border_c, corner_c>(f, seen_from_feature(f));
    }

    // Of a ball that comes closer than r and is in the slab, or may be.
    [[nodiscard, gnu::noinline]] constexpr flat_answer from_clearance() const {
        const located now = nearest_now();
        const int c = clearance(now);
        return c == open_sign ? flat_answer{}
               : c < 0        ? flat_answer{true, encounter::overlap, now.where, now.index}
                              : flat_answer{true, encounter::hit, none};
    }
    // Of a ball that moves parallel to the plane: its line has no one nearest feature.
    [[nodiscard, gnu::noinline]] constexpr flat_answer from_place() const {
        const located now = nearest_now();
        if (now.where == none) {
            return {};
        }
        if (now.where == feature::face) {
            return {true, encounter::recede};
        }
        const auto x = seen_from_feature(now);
        const int h = approach(now, x);
        if (h == open_sign) {
            return {};
        }
        if (h >= 0) {
            return {true, encounter::recede};
        }
        if (judge_(way_clearance{}, way_) == 1) {
            return {true, encounter::miss};
        }
        const int c = clearance(now);
        if (c == open_sign) {
            return {};
        }
        return c < 0 ? flat_answer{true, encounter::overlap, now.where, now.index} : entry();
    }

    // Whether a feature is the one that is touched first: no, perhaps, yes, or yes and no other one can be.
    enum verdict { no, perhaps, shared, alone };

    // The first of the features, in the order of ties, that is; a miss if none is.
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
    // Of conditions, each a sign that must not be -1: what they say together.
    template <class... Signs>
    [[nodiscard]] static constexpr verdict all_of(Signs... signs) {
        return ((signs == -1) || ...)          ? no
               : ((signs == open_sign) || ...) ? perhaps
               : ((signs == 0) || ...)         ? shared
                                               : alone;
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
        verdict v = all_of(judge_(way_clearance{}, way_));
        v = v == shared ? alone : v; // on the face now
        if constexpr (Judge::has_roots) {
            const T sense(speed);
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
        if (d == 0 && judge_(way_speed{}, way_) == 0 && inward == -1) {
            return no; // it slides along the face and leaves it here
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
        bool slides_off = judge_(way_speed{}, way_) == 0;
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
            slides_off = slides_off && judge_(inward_speed{k, m_.is_triangle}, way_) < 1;
        }
        return grazes && slides_off ? no : v;
    }
    // A condition > 0, and one >= 0, of which 0 shares nothing with another feature.
    [[nodiscard]] static constexpr int judge_above(int sign) { return sign == 0 ? -1 : sign; }
    [[nodiscard]] static constexpr int above(int sign) { return sign == 0 ? 1 : sign; }

    const flat_motion<N, T>& m_;
    const flat_way<N, T>& way_;
    const Judge& judge_;
};

} // namespace graze::inline v0_1
