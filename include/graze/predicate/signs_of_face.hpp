// On which side of a plane, or of the plane of a wall's or triangle's face, a ball's centre is, and which way it heads.
#pragma once

#include <graze/pair/plane_signs.hpp>
#include <graze/predicate/decide_flat.hpp>

namespace graze::inline v0_1::detail {

enum class face_number { height, speed };

// The sign of plane_height or of plane_speed, exactly.
template <class P, class Row>
[[nodiscard, gnu::noinline]] constexpr int exact_sign_in_row(const Row& row, face_number which) {
    exact_workspace room;
    auto in = lift_row<P>(row);
    in.use(room);
    const auto m = P::template motion<big_integer>(in);
    const auto sign_of = [which](const auto& face) {
        return which == face_number::speed ? graze::sign(plane_speed{}(face)) : graze::sign(plane_height{}(face));
    };
    if constexpr (requires { face_of(m); }) {
        return sign_of(face_of(m));
    } else {
        return sign_of(m);
    }
}
template <int N, class T, class Shape>
[[nodiscard, gnu::noinline]] constexpr int exact_sign_of_face(const ball<N, T>& b, const Shape& s, face_number which) {
    check(b, "ball");
    check(s, name_of(s));
    return exact_sign_in_row<pair_with<Shape>>(packed<pair_with<Shape>>(b, s), which);
}

// With n the plane's normal or, in space, e₀ × e₁, in the plane e₀ turned to the left: the sign of w·n.
template <int N, class T>
[[nodiscard]] constexpr int side_of(const ball<N, T>& b, const plane<N, T>& p) {
    if (!std::is_constant_evaluated()) {
        const filtered_plane<N, T> f(b, p);
        if (const int s = certain_sign(f.height, f.height_error * f.size); f.in_range != 0 && s != open) {
            return s;
        }
    }
    return exact_sign_of_face(b, p, face_number::height);
}
template <int N, class T, class Shape>
[[nodiscard]] constexpr int side_of(const ball<N, T>& b, const Shape& shape) {
    if (!std::is_constant_evaluated()) {
        const filtered_flat<N, T> f(b, shape);
        if (const int s = f.judge(way_height{}, way_of(f.motion)); f.in_range && s != open_sign) {
            return s;
        }
    }
    return exact_sign_of_face(b, shape, face_number::height);
}

// The sign of u·n.
template <int N, class T>
[[nodiscard]] constexpr int heading_of(const ball<N, T>& b, const plane<N, T>& p) {
    if (!std::is_constant_evaluated()) {
        const filtered_plane<N, T> f(b, p);
        const double size = f.scales.velocity * f.scales.normal;
        if (const int s = certain_sign(f.speed, f.speed_error * size); f.in_range != 0 && s != open) {
            return s;
        }
    }
    return exact_sign_of_face(b, p, face_number::speed);
}
template <int N, class T, class Shape>
[[nodiscard]] constexpr int heading_of(const ball<N, T>& b, const Shape& shape) {
    if (!std::is_constant_evaluated()) {
        const filtered_flat<N, T> f(b, shape);
        if (const int s = f.judge(way_speed{}, way_of(f.motion)); f.in_range && s != open_sign) {
            return s;
        }
    }
    return exact_sign_of_face(b, shape, face_number::speed);
}

} // namespace graze::inline v0_1::detail
