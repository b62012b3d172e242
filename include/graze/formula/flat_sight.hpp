// A flat shape as a ball sees it: which feature is nearest to a line, and the numbers of a feature.
#pragma once

#include <graze/formula/encounter.hpp>
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

// judge(F{}, numbers) is the sign of F(numbers), or open_sign. If it has a scope(), the end of that gives back the
// memory of numbers made meanwhile. If it has_roots, judge.root(x, y) makes y the root of x > 0, if it can.
template <int N, class T, class Judge>
class flat_sight {
  public:
    constexpr flat_sight(const flat_motion<N, T>& m, const flat_way<N, T>& way, const Judge& judge)
        : m_(m), way_(way), judge_(judge) {}

    // The numbers of the edge or the corner that was found.
    [[nodiscard]] constexpr flat_edge<N, T> numbers_of(const flat_answer& found) const {
        return seen_from_feature({found.where, found.index});
    }

    // The answer with the closest feature now.
    [[nodiscard]] constexpr flat_answer with_closest(flat_answer found) const {
        const located now = nearest_now();
        return now.where == none ? found : flat_answer{found.certain, found.what, now.where, now.index};
    }

    // Whether the centre is nearer than r now; negative if it is, open_sign if that is not certain.
    [[nodiscard]] constexpr int clearance() const {
        const int of_plane = clearance_of_plane();
        return of_plane == 0 || of_plane == 1 ? of_plane : clearance_of(nearest_now());
    }

  protected:
    [[nodiscard, gnu::always_inline]] constexpr auto scope_of_judge() const {
        if constexpr (requires { judge_.scope(); }) {
            return judge_.scope();
        } else {
            return nullptr;
        }
    }

    // A judge that can do more with the motion is given it.
    [[nodiscard, gnu::always_inline]] constexpr int clearance_of_plane() const {
        if constexpr (requires { judge_(way_clearance{}, way_, m_); }) {
            return judge_(way_clearance{}, way_, m_);
        } else {
            return judge_(way_clearance{}, way_);
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
    [[nodiscard, gnu::always_inline]] constexpr int along_way(int k) const {
        return along<nearest_from_start, nearest_from_end>(k);
    }
    [[nodiscard]] constexpr located nearest_now() const {
        const auto place = place_of(m_, way_);
        return nearest([&](int k) { return inside(place, k, 1); },
                       [&](int k) { return along<foot_from_start, foot_from_end>(k); });
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
        vec<N, T> d = m_.e[0];
        if constexpr (N == 2) {
            d = k == 0 ? d : -d;
        } else {
            d = ends_of_border(k, m_.is_triangle).start == corner ? direction_of_border(m_, k)
                                                                  : -direction_of_border(m_, k);
        }
        return corner_along(corner, d);
    }
    [[nodiscard, gnu::always_inline]] constexpr flat_edge<N, T> seen_from_feature(located f) const {
        if constexpr (N == 3) {
            if (f.where == feature::edge) {
                return seen_from_border(f.index);
            }
        }
        return corner_along(f.index, m_.e[0]);
    }
    template <class Border, class Corner>
    [[nodiscard, gnu::always_inline]] constexpr int of_feature(located f, const flat_edge<N, T>& x) const {
        if constexpr (N == 3) {
            if (f.where == feature::edge) {
                return judge_(Border{}, x);
            }
        }
        return judge_(Corner{}, x);
    }
    [[nodiscard, gnu::always_inline]] constexpr int approach(located f, const flat_edge<N, T>& x) const {
        return of_feature<border_h, corner_h>(f, x);
    }
    [[nodiscard, gnu::always_inline]] constexpr int discriminant(located f, const flat_edge<N, T>& x) const {
        return of_feature<border_discriminant, corner_discriminant>(f, x);
    }
    [[nodiscard]] constexpr int clearance_of(located f) const {
        [[maybe_unused]] const auto scope = scope_of_judge();
        if (f.where == none) {
            return open_sign;
        }
        if (f.where == feature::face) {
            return clearance_of_plane();
        }
        return of_feature<border_c, corner_c>(f, seen_from_feature(f));
    }

    const flat_motion<N, T>& m_;
    const flat_way<N, T>& way_;
    const Judge& judge_;

  private:
    [[nodiscard]] constexpr flat_edge<N, T> corner_along(int corner, const vec<N, T>& d) const {
        auto x = corner_of(centre_from(m_, corner), m_.u, d, m_.r, way_.speed);
        x.corner = corner;
        return x;
    }
};

} // namespace graze::inline v0_1
