// Which feature of a wall a ball meets first, and the encounter: one procedure that asks for signs of wall_features.
//
// The wall is a convex set, so the centre's distance from it is a convex function of time. The wall's closest feature
// at t = 0 tells whether the ball recedes or overlaps. Otherwise, unless it misses, the centre enters the set of points
// at distance <= r exactly once: through the face's offset plane, an edge's cylinder or a corner's sphere. It enters
// through the feature whose touching point is the wall's closest point at that time. So no two times are compared.
#pragma once

#include <graze/formula/discriminant.hpp>
#include <graze/formula/encounter.hpp>
#include <graze/formula/wall_features.hpp>

namespace graze::inline v0_1 {

enum class feature { face, edge, corner };

[[nodiscard]] constexpr const char* to_string(feature f) noexcept {
    return f == feature::face ? "face" : f == feature::edge ? "edge" : "corner";
}

// index: for an edge at λ_i = far, 2i + far; for a corner, λ_0 + 2 λ_1. For recede and overlap the feature is the
// closest one at t = 0; for a miss it means nothing.
struct wall_encounter {
    encounter what;
    feature where;
    int index;
};

// The view in which edge `index` is the edge λ_0 = 0.
[[nodiscard]] constexpr wall_view edge_view(int index) noexcept {
    return index < 2 ? wall_view{index, false} : wall_view{(index - 2) << 1, true};
}

// The norm of p + q√d. Where p and q√d have opposite signs, the sign of the norm decides.
template <class P, class Q, class D>
struct root_norm {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        const auto p = P{}(m);
        const auto q = Q{}(m);
        return p * p - q * q * D{}(m);
    }
};

// The procedure. Signs answers its questions for a view of the wall: signs(view, F{}) is the sign of formula F;
// signs.root(view, P{}, Q{}, D{}, f) is that of P + f Q√D, with f = ±1; signs.edge_discriminant(view) and
// signs.corner_discriminant(view) are those of D.
template <int N, class Signs>
class wall_decision {
  public:
    constexpr explicit wall_decision(Signs& signs) : signs_(signs) {}

    [[nodiscard]] constexpr wall_encounter operator()() const {
        const located now = closest_feature();
        if (approach(now) >= 0) {
            return {encounter::recede, now.where, now.index};
        }
        if (clearance(now) < 0) {
            return {encounter::overlap, now.where, now.index};
        }
        if (enters_face()) {
            return {encounter::hit, feature::face, 0};
        }
        if constexpr (N == 3) {
            for (int i = 0; i < 4; ++i) {
                if (const encounter what = enters_edge(edge_view(i)); what != encounter::miss) {
                    return {what, feature::edge, i};
                }
            }
        }
        for (int i = 0; i < corners; ++i) {
            if (const encounter what = enters_corner({i, false}); what != encounter::miss) {
                return {what, feature::corner, i};
            }
        }
        return {encounter::miss, feature::face, 0};
    }

    // Whether the centre is nearer to the wall than r at t = 0.
    [[nodiscard]] constexpr bool overlaps() const { return clearance(closest_feature()) < 0; }

  private:
    static constexpr int corners = N == 2 ? 2 : 4;

    struct located {
        feature where;
        int index;
    };

    // The feature with the wall's closest point to the centre at t = 0.
    [[nodiscard]] constexpr located closest_feature() const {
        constexpr wall_view base{};
        const bool low0 = signs_(base, side_height<0, 0>{}) < 0;
        const bool high0 = signs_(base, side_height<0, 1>{}) > 0;
        if constexpr (N == 2) {
            return low0 || high0 ? located{feature::corner, low0 ? 0 : 1} : located{feature::face, 0};
        } else {
            const bool low1 = signs_(base, side_height<1, 0>{}) < 0;
            const bool high1 = signs_(base, side_height<1, 1>{}) > 0;
            const bool outside[4] = {low0, high0, low1, high1};
            for (int i = 0; i < 4; ++i) { // beyond which, and beside it
                const wall_view view = edge_view(i);
                if (outside[i] && signs_(view, edge_foot<0>{}) >= 0 && signs_(view, edge_foot<1>{}) <= 0) {
                    return {feature::edge, i};
                }
            }
            if (low0 || high0 || low1 || high1) {
                for (int i = 0; i < corners; ++i) { // in whose normal cone: behind it along both edges
                    if (signs_({i, false}, coordinate_along<0>{}) <= 0 &&
                        signs_({i, false}, coordinate_along<1>{}) <= 0) {
                        return {feature::corner, i};
                    }
                }
            }
            return {feature::face, 0};
        }
    }

    // The signs of h and c of the closest feature.
    [[nodiscard]] constexpr int approach(located f) const {
        if (f.where == feature::face) {
            return signs_(wall_view{}, plane_height{}) * signs_(wall_view{}, plane_speed{});
        }
        if constexpr (N == 3) {
            if (f.where == feature::edge) {
                return signs_(edge_view(f.index), edge_h{});
            }
        }
        return signs_({f.index, false}, corner_formula<coefficient_h>{});
    }
    [[nodiscard]] constexpr int clearance(located f) const {
        if (f.where == feature::face) {
            return signs_(wall_view{}, plane_clearance{});
        }
        if constexpr (N == 3) {
            if (f.where == feature::edge) {
                return signs_(edge_view(f.index), edge_c{});
            }
        }
        return signs_({f.index, false}, corner_formula<coefficient_c>{});
    }

    [[nodiscard]] constexpr bool enters_face() const {
        constexpr wall_view base{};
        const int speed = signs_(base, plane_speed{});
        if (signs_(base, plane_height{}) * speed >= 0 || signs_(base, plane_clearance{}) < 0 ||
            !face_foot_within<0>(speed)) {
            return false;
        }
        if constexpr (N == 3) {
            return face_foot_within<1>(speed);
        } else {
            return true;
        }
    }

    template <int I>
    [[nodiscard]] constexpr bool face_foot_within(int speed) const {
        constexpr wall_view base{};
        return speed * signs_.root(base, face_foot_p<I, 0>{}, face_foot_q<I>{}, face_foot_d{}, -speed) >= 0 &&
               speed * signs_.root(base, face_foot_p<I, 1>{}, face_foot_q<I>{}, face_foot_d{}, -speed) <= 0;
    }

    // The sign of X + V t when the ball touches the edge's line, or the corner.
    template <class X, class V>
    [[nodiscard]] constexpr int at_edge(wall_view view) const {
        return signs_.root(view, value_at_root<edge_a, edge_h, X, V>{}, V{}, graze::edge_discriminant{}, -1);
    }
    template <class X, class V>
    [[nodiscard]] constexpr int at_corner(wall_view view) const {
        using a = corner_formula<coefficient_a>;
        using h = corner_formula<coefficient_h>;
        return signs_.root(view, value_at_root<a, h, X, V>{}, V{}, corner_formula<discriminant_lagrange>{}, -1);
    }

    // If D = 0 the ball may slide along the face, or along an edge, at exactly the distance r, and touch the wall from
    // one end to the other. The feature at the end where it leaves, moving outwards, is not the one that it meets
    // first.
    [[nodiscard]] constexpr encounter enters_edge(wall_view view) const {
        if (signs_(view, edge_h{}) >= 0 || signs_(view, edge_c{}) < 0) {
            return encounter::miss;
        }
        const int d = signs_.edge_discriminant(view);
        const bool touches = d >= 0 && at_edge<edge_foot<0>, edge_foot_speed>(view) >= 0 &&
                             at_edge<edge_foot<1>, edge_foot_speed>(view) <= 0 &&
                             at_edge<side_height<0, 0>, side_speed<0>>(view) <= 0 &&
                             !(d == 0 && signs_(view, plane_speed{}) == 0 && signs_(view, side_speed<0>{}) < 0);
        return !touches ? encounter::miss : d == 0 ? encounter::graze : encounter::hit;
    }

    [[nodiscard]] constexpr encounter enters_corner(wall_view view) const {
        if (signs_(view, corner_formula<coefficient_h>{}) >= 0 || signs_(view, corner_formula<coefficient_c>{}) < 0) {
            return encounter::miss;
        }
        const int d = signs_.corner_discriminant(view);
        if (d < 0 || at_corner<coordinate_along<0>, speed_along<0>>(view) > 0) {
            return encounter::miss;
        }
        if constexpr (N == 3) {
            if (at_corner<coordinate_along<1>, speed_along<1>>(view) > 0) {
                return encounter::miss;
            }
        }
        return d > 0 ? encounter::hit : slides_off(view) ? encounter::miss : encounter::graze;
    }
    [[nodiscard]] constexpr bool slides_off(wall_view view) const {
        if (signs_(view, plane_speed{}) != 0 || signs_(view, side_speed<0>{}) > 0) {
            return false;
        }
        if constexpr (N == 3) {
            return signs_(view, side_speed<1>{}) <= 0;
        } else {
            return true;
        }
    }

    Signs& signs_;
};

} // namespace graze::inline v0_1
