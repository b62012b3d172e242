// A flat shape as a ball sees it: which feature is nearest to a line.
#pragma once

#include <graze/formula/encounter.hpp>
#include <graze/formula/flat_view.hpp>

namespace graze::inline v0_1 {

template <int N, class T, class Judge>
class flat_sight : public flat_view<N, T, Judge> {
  public:
    using view = flat_view<N, T, Judge>;
    using view::view;

    // The numbers of the edge or the corner that was found.
    [[nodiscard]] constexpr auto numbers_of(const flat_answer& found) const {
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
    using view::clearance_of_plane;
    using view::is_triangle;
    using view::of_feature;
    using view::of_way;
    using view::scope;
    using view::seen_from_border;
    using view::seen_from_corner;

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
                    const auto ends = ends_of_border(k, is_triangle());
                    const int corner = where < 0 ? ends.start : ends.end;
                    const int other = other_border(corner, k, is_triangle());
                    if (along(other) == (ends_of_border(other, is_triangle()).start == corner ? -1 : 1)) {
                        return {feature::corner, corner};
                    }
                }
            }
        }
        return {all ? feature::face : none, 0};
    }
    [[nodiscard]] constexpr int borders() const { return borders_of(N, is_triangle()); }

    [[nodiscard, gnu::always_inline]] constexpr int inside(int k, int facing) const {
        const int side = of_way(inside_border{k, is_triangle()});
        return side == open_sign ? side : side * facing;
    }
    template <class Start, class End>
    [[nodiscard, gnu::always_inline]] constexpr int along(int k) const {
        [[maybe_unused]] const auto here = scope();
        const auto x = seen_from_border(k);
        const int start = of_feature(Start{}, x);
        const int end = of_feature(End{}, x);
        return start == -1 ? -1 : end == 1 ? 1 : start == open_sign || end == open_sign ? open_sign : 0;
    }
    [[nodiscard, gnu::always_inline]] constexpr int along_way(int k) const {
        return along<nearest_from_start, nearest_from_end>(k);
    }
    [[nodiscard]] constexpr located nearest_now() const {
        const auto place = view::place();
        return nearest([&](int k) { return view::inside_of(place, k); },
                       [&](int k) { return along<foot_from_start, foot_from_end>(k); });
    }

    [[nodiscard, gnu::always_inline]] constexpr auto seen_from_feature(located f) const {
        if constexpr (N == 3) {
            if (f.where == feature::edge) {
                return seen_from_border(f.index);
            }
        }
        return seen_from_corner(f.index);
    }
    template <class Border, class Corner, class X>
    [[nodiscard, gnu::always_inline]] constexpr int of_either(located f, const X& x) const {
        if constexpr (N == 3) {
            if (f.where == feature::edge) {
                return of_feature(Border{}, x);
            }
        }
        return of_feature(Corner{}, x);
    }
    template <class X>
    [[nodiscard, gnu::always_inline]] constexpr int approach(located f, const X& x) const {
        return of_either<border_h, corner_h>(f, x);
    }
    template <class X>
    [[nodiscard, gnu::always_inline]] constexpr int discriminant(located f, const X& x) const {
        return of_either<border_discriminant, corner_discriminant>(f, x);
    }
    [[nodiscard]] constexpr int clearance_of(located f) const {
        [[maybe_unused]] const auto here = scope();
        if (f.where == none) {
            return open_sign;
        }
        if (f.where == feature::face) {
            return clearance_of_plane();
        }
        return of_either<border_c, corner_c>(f, seen_from_feature(f));
    }
};

} // namespace graze::inline v0_1
