// What is asked by name of a ball and a flat shape in space, answered in a number type that is slow.
#pragma once

#include <graze/pair/flat_programs.hpp>

#include <cstddef>
#include <cstdint>

namespace graze::inline v0_1::detail {

// Answers in a T that is slow, by running the recorded steps. The numbers of the feature that was asked for last are
// kept. A judge of numbers in a workspace can rewind() it to a mark().
template <int N, class T, class Judge>
class recorded_questions final : public flat_questions<N> {
    static constexpr const flat_programs<N>& all = flat_program<N>;
    using program = typename flat_programs<N>::program;

  public:
    constexpr recorded_questions(const flat_motion<N, T>& m, const Judge& judge)
        : flat_questions<N>(m.is_triangle), judge_(judge) {
        T* to = row_;
        const auto put = [&](const vec<N, T>& x) {
            for (int i = 0; i < N; ++i) {
                *to++ = x[i];
            }
        };
        put(m.w);
        put(m.u);
        for (const auto& e : m.e) {
            put(e);
        }
        *to = m.r;
        run(all.way, static_cast<int>(flat_programs<N>::motion_size));
        keep();
    }

    [[nodiscard]] constexpr int sign(flat_name which, flat_place_name of) override {
        const auto k = static_cast<std::size_t>(of.border + (this->is_triangle ? 4 : 0));
        switch (which) {
        case flat_name::speed:
            if constexpr (requires { judge_.moves_along; }) {
                if (judge_.moves_along) {
                    return 0;
                }
            }
            break;
        case flat_name::inside:
            return sign_of(all.inside[k]);
        case flat_name::inward:
            return sign_of(all.inward[k]);
        case flat_name::inside_now:
            find_place();
            return sign_of(all.inside_now[k]);
        case flat_name::inside_at_touch:
            return inside_at_touch(of, k);
        default:
            if (which > flat_name::inside_at_touch) {
                find_feature(of);
            }
        }
        return sign_of(all.named[static_cast<std::size_t>(which)]);
    }

  private:
    constexpr void run(const program& p, int inputs) { run_steps(row_, all.step.data() + p.first, inputs, p.count); }
    [[nodiscard]] constexpr int sign_of(const program& p) {
        if constexpr (requires { judge_.scope(); }) {
            const auto own = judge_.scope();
            run(p, all.formula);
            return judge_.sign_of(row_[p.result]);
        } else {
            run(p, all.formula);
            return judge_.sign_of(row_[p.result]);
        }
    }
    [[nodiscard]] constexpr int inside_at_touch(flat_place_name of, std::size_t k) {
        const int speed = sign(flat_name::speed, of);
        if constexpr (Judge::has_roots) {
            T* to = row_ + all.touch;
            if (!judge_.root(row_[all.square], *to)) {
                return open_sign;
            }
            const auto turned = [&](const T& x) { return speed < 0 ? -x : x; };
            *++to = turned(row_[all.speed]);
            for (const std::uint8_t at : all.at) {
                *++to = turned(row_[at]);
            }
            return sign_of(all.touch_inside[k]);
        } else {
            const int inside = sign(flat_name::inside, of);
            const bool is_point = graze::sign(row_[flat_programs<N>::motion_size - 1]) == 0;
            return root_difference(inside == open_sign ? inside : inside * speed,
                                   is_point ? 0 : sign(flat_name::inward, of), sign_of(all.touch_norm[k]));
        }
    }
    constexpr void find_feature(flat_place_name of) {
        if (of == known_) {
            return;
        }
        forget();
        known_ = of;
        const auto corner = static_cast<std::size_t>(of.corner < 0 ? 4 : of.corner);
        const auto k = static_cast<std::size_t>((of.border < 0 ? 0 : of.border) + (this->is_triangle ? 4 : 0));
        const auto& choice = all.choose[corner][k];
        run(choice.steps, all.formula);
        T* to = row_ + all.chosen;
        for (const std::uint8_t from : choice.from) {
            *to++ = row_[from];
        }
        run(all.feature, all.chosen + 2 * N + 2);
        if (of.corner >= 0) {
            run(all.moment, all.chosen + 2 * N + 2 + all.feature.count);
        }
    }
    constexpr void find_place() {
        if (!has_place_) {
            forget();
            run(all.place, static_cast<int>(flat_programs<N>::motion_size) + all.way.count);
            has_place_ = true;
            keep();
        }
    }
    constexpr void keep() {
        if constexpr (requires { judge_.mark(); }) {
            mark_ = judge_.mark();
        }
    }
    constexpr void forget() {
        known_ = {};
        if constexpr (requires { judge_.mark(); }) {
            judge_.rewind(mark_);
        }
    }

    Judge judge_;
    flat_place_name known_;
    bool has_place_ = false;
    std::int64_t* mark_ = nullptr;
    T row_[static_cast<std::size_t>(all.size)];
};

} // namespace graze::inline v0_1::detail
