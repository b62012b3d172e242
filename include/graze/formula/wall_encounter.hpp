// Which feature of a wall a ball meets first, and how: one procedure, whose questions are the signs of wall_features.
//
// The distance from the centre to the wall, a convex set, is a convex function of time. Its closest feature now tells
// whether the ball recedes or overlaps. Otherwise the ball enters the set of points at distance <= r exactly once,
// through the face's offset plane, an edge's cylinder or a corner's sphere; the entry is through that one whose
// touching point is the wall's closest point at that time, so that no two times are compared.
#pragma once

#include <graze/formula/discriminant.hpp>
#include <graze/formula/encounter.hpp>
#include <graze/formula/wall_features.hpp>

namespace graze {

enum class feature { face, edge, corner };

[[nodiscard]] constexpr const char* to_string(feature f) noexcept {
    return f == feature::face ? "face" : f == feature::edge ? "edge" : "corner";
}

// index of an edge: 2i + far for the one at λ_i = far; of a corner: λ_0 + 2 λ_1. For recede and overlap the feature is
// the closest one now; for a miss it means nothing.
struct wall_encounter {
    encounter what;
    feature where;
    int index;
};

// The norm of p + q√d, whose sign decides where p and q√d have opposite ones.
template <class P, class Q, class D>
struct root_norm {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        const auto p = P{}(m);
        const auto q = Q{}(m);
        return p * p - q * q * D{}(m);
    }
};

// Signs asks a formula for its sign: signs(F{}), and signs.root(P{}, Q{}, D{}, flip), that of p + flip q√d. edges and
// corners get their discriminants' signs from signs.edge_discriminant<I, Far>() and signs.corner_discriminant<K>().
template <int N, class Signs>
class wall_decision {
  public:
    constexpr explicit wall_decision(Signs& signs) : signs_(signs) {}

    [[nodiscard]] constexpr wall_encounter operator()() const {
        const wall_encounter now = closest_now();
        if (now.what != encounter::miss) {
            return now;
        }
        wall_encounter found{encounter::miss, feature::face, 0};
        if (enters_face(found)) {
            return found;
        }
        if constexpr (N == 3) {
            if (enters_edge<0, 0>(found) || enters_edge<0, 1>(found) || enters_edge<1, 0>(found) ||
                enters_edge<1, 1>(found)) {
                return found;
            }
            if (enters_corner<0>(found) || enters_corner<1>(found) || enters_corner<2>(found) ||
                enters_corner<3>(found)) {
                return found;
            }
        } else {
            if (enters_corner<0>(found) || enters_corner<1>(found)) {
                return found;
            }
        }
        return found;
    }

  private:
    // encounter::miss stands for "apart and approaching the closest feature".
    [[nodiscard]] constexpr encounter from(int sign_h, int sign_c) const {
        return sign_h >= 0 ? encounter::recede : sign_c < 0 ? encounter::overlap : encounter::miss;
    }

    [[nodiscard]] constexpr wall_encounter closest_now() const {
        wall_encounter found{encounter::recede, feature::face, 0};
        if constexpr (N == 2) {
            if (signs_(side_height<0, 0>{}) < 0) {
                corner_now<0>(found);
            } else if (signs_(side_height<0, 1>{}) > 0) {
                corner_now<1>(found);
            } else {
                face_now(found);
            }
        } else {
            const int low0 = signs_(side_height<0, 0>{});
            const int high0 = signs_(side_height<0, 1>{});
            const int low1 = signs_(side_height<1, 0>{});
            const int high1 = signs_(side_height<1, 1>{});
            if (low0 >= 0 && high0 <= 0 && low1 >= 0 && high1 <= 0) {
                face_now(found);
            } else {
                (low0 < 0 && edge_now<0, 0>(found)) || (high0 > 0 && edge_now<0, 1>(found)) ||
                    (low1 < 0 && edge_now<1, 0>(found)) || (high1 > 0 && edge_now<1, 1>(found)) ||
                    corner_if_closest<0>(found) || corner_if_closest<1>(found) || corner_if_closest<2>(found) ||
                    corner_if_closest<3>(found);
            }
        }
        return found;
    }

    constexpr void face_now(wall_encounter& found) const {
        found = {from(signs_(plane_height{}) * signs_(plane_speed{}), signs_(plane_clearance{})), feature::face, 0};
    }

    template <int I, int Far>
    constexpr bool edge_now(wall_encounter& found) const {
        if (signs_(edge_foot_now<I, Far, 0>{}) < 0 || signs_(edge_foot_now<I, Far, 1>{}) > 0) {
            return false;
        }
        found = {from(signs_(edge_h<I, Far>{}), signs_(edge_c<I, Far>{})), feature::edge, 2 * I + Far};
        return true;
    }

    template <int K>
    constexpr bool corner_now(wall_encounter& found) const {
        found = {from(signs_(corner_formula<K, coefficient_h>{}), signs_(corner_formula<K, coefficient_c>{})),
                 feature::corner, K};
        return true;
    }

    // In the corner's normal cone: on or behind it along both edges.
    template <int K>
    constexpr bool corner_if_closest(wall_encounter& found) const {
        if (inward<K, 0>(signs_(corner_along_now<K, 0>{})) > 0 || inward<K, 1>(signs_(corner_along_now<K, 1>{})) > 0) {
            return false;
        }
        return corner_now<K>(found);
    }

    // A sign along +e_i, seen from a corner at the far end of e_i.
    template <int K, int I>
    [[nodiscard]] static constexpr int inward(int sign_along) {
        return (K >> I & 1) != 0 ? -sign_along : sign_along;
    }

    constexpr bool enters_face(wall_encounter& found) const {
        const int speed = signs_(plane_speed{});
        if (signs_(plane_height{}) * speed >= 0 || signs_(plane_clearance{}) < 0) {
            return false;
        }
        if (!face_foot_within<0>(speed)) {
            return false;
        }
        if constexpr (N == 3) {
            if (!face_foot_within<1>(speed)) {
                return false;
            }
        }
        found = {encounter::hit, feature::face, 0};
        return true;
    }

    template <int I>
    [[nodiscard]] constexpr bool face_foot_within(int speed) const {
        return speed * signs_.root(face_foot_p<I, 0>{}, face_foot_q<I>{}, face_foot_d{}, -speed) >= 0 &&
               speed * signs_.root(face_foot_p<I, 1>{}, face_foot_q<I>{}, face_foot_d{}, -speed) <= 0;
    }

    template <int I, int Far>
    constexpr bool enters_edge(wall_encounter& found) const {
        if (signs_(edge_h<I, Far>{}) >= 0 || signs_(edge_c<I, Far>{}) < 0) {
            return false;
        }
        const int d = signs_.template edge_discriminant<I, Far>();
        if (d < 0) {
            return false;
        }
        using root = edge_discriminant<I, Far>;
        if (signs_.root(edge_foot_p<I, Far, 0>{}, edge_foot_q<I, Far>{}, root{}, -1) < 0 ||
            signs_.root(edge_foot_p<I, Far, 1>{}, edge_foot_q<I, Far>{}, root{}, -1) > 0) {
            return false;
        }
        const int side = signs_.root(edge_side_p<I, Far>{}, edge_side_q<I, Far>{}, root{}, -1);
        if ((Far == 0 ? side : -side) > 0 || (d == 0 && slides_off_edge<I, Far>())) {
            return false;
        }
        found = {d == 0 ? encounter::graze : encounter::hit, feature::edge, 2 * I + Far};
        return true;
    }

    template <int K>
    constexpr bool enters_corner(wall_encounter& found) const {
        if (signs_(corner_formula<K, coefficient_h>{}) >= 0 || signs_(corner_formula<K, coefficient_c>{}) < 0) {
            return false;
        }
        const int d = signs_.template corner_discriminant<K>();
        if (d < 0 || !corner_behind<K, 0>()) {
            return false;
        }
        if constexpr (N == 3) {
            if (!corner_behind<K, 1>()) {
                return false;
            }
        }
        if (d == 0 && slides_off_corner<K>()) {
            return false;
        }
        found = {d == 0 ? encounter::graze : encounter::hit, feature::corner, K};
        return true;
    }

    // A ball that slides along the face at distance r touches the wall from one border to the other. Whether it leaves
    // the wall at this edge or corner, at which D = 0: whether the touching point was on the wall just before.
    template <int I, int Far>
    [[nodiscard]] constexpr bool slides_off_edge() const {
        if (signs_(plane_speed{}) != 0) {
            return false;
        }
        const int outward = signs_(side_speed<I>{});
        const int along = signs_(side_speed<1 - I>{});
        using root = edge_discriminant<I, Far>;
        const bool from_start =
            along > 0 && signs_.root(edge_foot_p<I, Far, 0>{}, edge_foot_q<I, Far>{}, root{}, -1) == 0;
        const bool from_end =
            along < 0 && signs_.root(edge_foot_p<I, Far, 1>{}, edge_foot_q<I, Far>{}, root{}, -1) == 0;
        return (Far == 0 ? outward : -outward) < 0 && !from_start && !from_end;
    }
    template <int K>
    [[nodiscard]] constexpr bool slides_off_corner() const {
        if (signs_(plane_speed{}) != 0 || inward<K, 0>(signs_(side_speed<0>{})) > 0) {
            return false;
        }
        if constexpr (N == 3) {
            return inward<K, 1>(signs_(side_speed<1>{})) <= 0;
        } else {
            return true;
        }
    }

    template <int K, int I>
    [[nodiscard]] constexpr bool corner_behind() const {
        using root = corner_formula<K, discriminant_lagrange>;
        return inward<K, I>(signs_.root(corner_along_p<K, I>{}, corner_along_q<I>{}, root{}, -1)) <= 0;
    }

    Signs& signs_;
};

} // namespace graze
