// The certain signs of a ball and a plane or a wall, with their inputs checked.
#pragma once

#include <graze/pair/certain_signs.hpp>
#include <graze/pair/input_check.hpp>
#include <graze/pair/plane_signs.hpp>
#include <graze/pair/rounded_motion.hpp>

namespace graze::inline v0_1::detail {

template <int N, class X, class U, class E, class S, class NN, class M>
[[nodiscard]] constexpr magnitudes magnitudes_of(const wall_motion<N, X, U, E, S, NN, M>& m) noexcept {
    double length = sum_of_magnitudes(m.w) + m.r;
    for (const auto& e : m.e) {
        length += sum_of_magnitudes(e);
    }
    return {length, sum_of_magnitudes(m.u), 1};
}

template <int N, class T>
struct pair_of_plane {
    using kind = ball_and_plane<N>;
    using bounds = plane_bounds<N, T>;
};
template <int N, class T>
struct pair_of_wall {
    using kind = ball_and_wall<N>;
    using bounds = wall_bounds<N, T>;
};
template <int N, class T>
[[nodiscard]] pair_of_plane<N, T> pair_of(const ball<N, T>&, const plane<N, T>&);
template <int N, class T>
[[nodiscard]] pair_of_wall<N, T> pair_of(const ball<N, T>&, const wall<N, T>&);

// f(signs) for a ball b and a plane or wall s. Usable magnitudes are finite and not zero, so that only what is out of
// their range, or has an odd radius, is looked at number by number.
template <int N, class T, class Shape, class Observer, class F>
[[nodiscard]] constexpr auto with_certain_signs(const ball<N, T>& b, const Shape& s, Observer&& observer, F f) {
    using pair = decltype(pair_of(b, s));
    if (std::is_constant_evaluated()) {
        check(b, "ball");
        check(s, name_of(s));
    }
    const auto row = packed<typename pair::kind>(b, s);
    const auto motion = [&] {
        if (std::is_constant_evaluated()) { // not asked for; of finite inputs it might still overflow
            return decltype(rounded_motion(b, s)){};
        }
        return rounded_motion(b, s);
    }();
    const magnitudes scales = magnitudes_of(motion);
    if (!std::is_constant_evaluated() && (!plain_radii(b.radius, b.radius) || !usable<T>(scales))) {
        check(b, "ball");
        check(s, name_of(s));
    }
    certain_signs<typename pair::kind, typename pair::bounds, std::remove_cvref_t<decltype(motion)>,
                  std::remove_cvref_t<decltype(row)>>
        signs(motion, scales, row);
    if (!std::is_constant_evaluated() && !(scales.velocity > 0) && is_zero(b.velocity)) {
        signs.rest();
    }
    if constexpr (requires { s.edge; }) {
        if (signs(wall_view{}, face_foot_d{}) == 0) {
            check(s, name_of(s));
            reject(name_of(s), "edges are parallel");
        }
    }
    const auto answer = f(signs);
    observer(signs.decided_by());
    return answer;
}

} // namespace graze::inline v0_1::detail
