// What is asked by name of a ball and a flat shape in space, answered in a number type that is quick.
#pragma once

#include <graze/pair/flat_questions.hpp>

namespace graze::inline v0_1::detail {

// Answers in a T that is quick, with formulas that are compiled for it. The numbers of the feature that was asked for
// last are kept.
template <int N, class T, class Judge>
class compiled_questions final : public flat_questions<N> {
    static_assert(!Judge::has_roots);

  public:
    constexpr compiled_questions(const flat_motion<N, T>& m, const Judge& judge)
        : flat_questions<N>(m.is_triangle), m_(m), way_(way_of(m)), judge_(judge) {}

    [[nodiscard]] constexpr int sign(flat_name which, flat_place_name of) override {
        const flat_view<N, T, Judge> view(m_, way_, judge_);
        switch (which) {
        case flat_name::square:
            return judge_(way_square{}, way_);
        case flat_name::speed:
            return judge_(way_speed{}, way_);
        case flat_name::height:
            return judge_(way_height{}, way_);
        case flat_name::clearance_of_plane:
            return judge_(way_clearance{}, way_);
        case flat_name::inside:
            return judge_(inside_border{of.border, m_.is_triangle}, way_);
        case flat_name::inward:
            return judge_(inward_speed{of.border, m_.is_triangle}, way_);
        case flat_name::inside_now:
            return view.inside_of(place(view), of.border);
        case flat_name::inside_at_touch:
            return view.inside_at_touch(of.border, sign(flat_name::speed, of));
        default:
            return of_feature(which, feature(of));
        }
    }

  private:
    [[nodiscard]] constexpr int of_feature(flat_name which, const flat_edge<N, T>& x) const {
        switch (which) {
        case flat_name::start:
            return judge_(nearest_from_start{}, x);
        case flat_name::end:
            return judge_(nearest_from_end{}, x);
        case flat_name::foot_from_start:
            return judge_(graze::foot_from_start{}, x);
        case flat_name::foot_from_end:
            return judge_(graze::foot_from_end{}, x);
        case flat_name::border_h:
            return judge_(graze::border_h{}, x);
        case flat_name::border_c:
            return judge_(graze::border_c{}, x);
        case flat_name::border_discriminant:
            return judge_(graze::border_discriminant{}, x);
        case flat_name::corner_h:
            return judge_(graze::corner_h{}, x);
        case flat_name::corner_c:
            return judge_(graze::corner_c{}, x);
        case flat_name::corner_discriminant:
            return judge_(graze::corner_discriminant{}, x);
        case flat_name::direction_speed:
            return judge_(graze::direction_speed{}, x);
        case flat_name::along_from_start:
            return judge_(touch_along_norm<nearest_from_start>{}, x);
        case flat_name::along_from_end:
            return judge_(touch_along_norm<nearest_from_end>{}, x);
        case flat_name::outside:
            return judge_(touch_outside{}, x);
        case flat_name::touch_inward:
            return judge_(graze::touch_inward{}, x);
        case flat_name::outside_norm:
            return judge_(touch_outside_norm{}, x);
        default:
            return judge_(touch_behind_norm{}, x);
        }
    }
    [[nodiscard]] constexpr const flat_edge<N, T>& feature(flat_place_name of) {
        if (!(of == known_)) {
            known_ = of;
            const int k = of.border < 0 ? 0 : of.border; // where no direction matters
            const int corner = of.corner < 0 ? ends_of_border(k, m_.is_triangle).start : of.corner;
            const vec<N, T> w = centre_from(m_, corner);
            feature_ = edge_of(w, m_.u, direction_from(m_, corner, k), m_.r, inside_border{k, m_.is_triangle}(way_),
                               inward_speed{k, m_.is_triangle}(way_), way_.speed);
            if (of.corner >= 0) {
                feature_.moment = moment_of(w, m_.u);
            }
        }
        return feature_;
    }
    [[nodiscard]] constexpr const flat_place<N, T>& place(const flat_view<N, T, Judge>& view) {
        if (!has_place_) {
            place_ = view.place();
            has_place_ = true;
        }
        return place_;
    }

    const flat_motion<N, T>& m_;
    flat_way<N, T> way_;
    Judge judge_;
    flat_edge<N, T> feature_{};
    flat_place<N, T> place_{};
    flat_place_name known_;
    bool has_place_ = false;
};

} // namespace graze::inline v0_1::detail
