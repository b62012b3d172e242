// A ball and the line of a flat shape's border, or its corner, in inner products.
//
// The way of the centre passes the line of an edge d at |d·(w × u)|/|d × u|, where d·(w × u) is a sum of numbers of
// flat_way.
#pragma once

#include <graze/formula/flat_way.hpp>

namespace graze::inline v0_1 {

// A ball and the line of a border, which has the direction d, seen from the border's start; for a corner d leads
// inwards along a border. inside: O, inward: I, speed: u·n.
template <int N, class T>
struct flat_edge {
    T ww, wd, wu, dd, ud, uu, r;
    T far_wd, far_wu; // seen from the end
    T inside, inward, speed;
    decltype(graze::cross(vec<N, T>{}, vec<N, T>{})) moment{}; // w × u, of a corner
    int border = -1, corner = -1;                              // which one it is
};
template <int N, class T>
[[nodiscard, gnu::always_inline]] constexpr inline flat_edge<N, T>
edge_of(const vec<N, T>& w, const vec<N, T>& u, const vec<N, T>& d, const T& r, const T& inside, const T& inward,
        const T& speed) {
    const T wd = graze::dot(w, d), wu = graze::dot(w, u), dd = graze::dot(d, d), ud = graze::dot(u, d);
    return {graze::dot(w, w), wd, wu, dd, ud, graze::dot(u, u), r, wd - dd, wu - ud, inside, inward, speed};
}
// w × u, which an edge does not need.
template <int N, class T>
[[nodiscard, gnu::always_inline]] constexpr inline auto moment_of(const vec<N, T>& w, const vec<N, T>& u) {
    return graze::cross(w, u);
}
template <int N, class T>
[[nodiscard, gnu::always_inline]] constexpr inline flat_edge<N, T>
corner_of(const vec<N, T>& w, const vec<N, T>& u, const vec<N, T>& d, const T& r, const T& speed) {
    auto x = edge_of(w, u, d, r, speed, speed, speed);
    x.moment = moment_of(w, u);
    return x;
}

// Where along the border it is nearest to the centre's line, times |u × d|²: from the start and from the end.
struct nearest_from_start {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        return x.wd * x.uu - x.ud * x.wu;
    }
};
struct nearest_from_end {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        return x.far_wd * x.uu - x.ud * x.far_wu;
    }
};
// Where along the border it is nearest to the centre now, times d·d.
struct foot_from_start {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        return x.wd;
    }
};
struct foot_from_end {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        return x.far_wd;
    }
};
// h and c of the border's line: ⟨w × d, u × d⟩ and |w × d|² - r² d·d.
struct border_h {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        return x.dd * x.wu - x.wd * x.ud;
    }
};
struct border_c {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        return x.dd * (x.ww - x.r * x.r) - x.wd * x.wd;
    }
};
// |u × d|², and D over d·d: r² |u × d|² - O².
struct border_a {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        return x.dd * x.uu - x.ud * x.ud;
    }
};
struct border_discriminant {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        return x.r * x.r * border_a{}(x)-x.inside * x.inside;
    }
};
// D itself.
struct border_whole_discriminant {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        return x.dd * border_discriminant{}(x);
    }
};
// h, c and D of the corner, by Lagrange's identity.
struct corner_h {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        return x.wu;
    }
};
struct corner_c {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        return x.ww - x.r * x.r;
    }
};
struct corner_discriminant {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        return x.r * x.r * x.uu - graze::squared_norm(x.moment);
    }
};

// When the ball touches the border's line, the foot is at (T √(d·d) - u·d √D)/(|u × d|² √(d·d)) for T =
// nearest_from_start, from the end likewise, and the ball outside of the border where (u·n) O √(d·d) - I √D <= 0. When
// it touches the corner, it is behind it along d where T - u·d √D <= 0. These are the numbers without roots and the
// norms.
template <class Nearest>
struct touch_along_norm {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        const auto t = Nearest{}(x);
        return t * t * x.dd - x.ud * x.ud * border_discriminant{}(x);
    }
};
struct direction_speed { // u·d
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        return x.ud;
    }
};
struct touch_outside {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        return x.speed * x.inside;
    }
};
struct touch_inward {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        return x.inward;
    }
};
struct touch_outside_norm {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        const auto t = x.speed * x.inside;
        return t * t * x.dd - x.inward * x.inward * border_discriminant{}(x);
    }
};
struct touch_behind_norm {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        const auto t = nearest_from_start{}(x);
        return t * t - x.ud * x.ud * corner_discriminant{}(x);
    }
};

} // namespace graze::inline v0_1
