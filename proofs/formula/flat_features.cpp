// The numbers of a line of sight, compared with the definitions of wall_features.hpp: inner products and three
// determinants give the same feet, coefficients, discriminants and values at the root. The identities are tried at
// points with whole coordinates, whose values doubles hold exactly. Two different polynomials of degree up to 10 in 13
// letters would differ at some of them.
#include <graze/formula/discriminant.hpp>
#include <graze/formula/flat_edge.hpp>

namespace {

using namespace graze;

// Whole numbers from -3 to 3, in no order.
class numbers {
  public:
    constexpr explicit numbers(unsigned seed) : state_(seed * 2654435761U + 12345) {}
    constexpr double next() {
        state_ = state_ * 1664525U + 1013904223U;
        return static_cast<double>((state_ >> 24U) % 7) - 3;
    }
    template <int N>
    constexpr vec<N, double> vector() {
        vec<N, double> x{};
        for (int i = 0; i < N; ++i) {
            x[i] = next();
        }
        return x;
    }

  private:
    unsigned state_;
};

template <int N>
constexpr flat_motion<N, double> any_motion(unsigned seed, bool is_triangle) {
    numbers any(seed);
    flat_motion<N, double> m{any.vector<N>(), any.vector<N>(), {}, 0, is_triangle};
    for (auto& e : m.e) {
        e = any.vector<N>();
    }
    m.r = any.next();
    return m;
}

// λ_i n·n = x·side_i, with the sides in which only λ_i grows.
template <int N>
constexpr std::array<vec<N, double>, N - 1> sides_of(const std::array<vec<N, double>, N - 1>& e) {
    if constexpr (N == 2) {
        return {e[0]};
    } else {
        const auto n = face_normal(e);
        return {cross(e[1], n), cross(n, e[0])};
    }
}
template <int N>
constexpr bool crosses(const flat_motion<N, double>& f) {
    const auto m = face_of(wall_motion_of(f.w, f.u, f.e, f.r));
    const auto side = sides_of<N>(f.e);
    const auto way = way_of(f);
    const auto place = place_of(f, way);
    for (std::size_t i = 0; i + 1 < static_cast<std::size_t>(N); ++i) {
        const double p = dot(f.w, side[i]), q = dot(f.u, side[i]);
        if (place.at[i] != p || way.pull[i] != q || way.at[i] * way.nn != way.speed * p - way.height * q) {
            return false;
        }
    }
    return way.height == plane_height{}(m) && way.speed == plane_speed{}(m) && way.facing == way.speed &&
           way_clearance{}(way) == plane_clearance{}(m) && place.facing == way.nn && way.nn == squared_norm(m.n);
}

// A wall's own coordinates.
constexpr bool has_sides(const flat_motion<3, double>& f) {
    const auto side = sides_of<3>(f.e);
    const auto n = face_normal(f.e);
    return dot(n, f.e[0]) == 0 && dot(n, f.e[1]) == 0 && dot(side[0], n) == 0 && dot(side[1], n) == 0 &&
           dot(side[0], f.e[0]) == squared_norm(n) && dot(side[0], f.e[1]) == 0 && dot(side[1], f.e[0]) == 0 &&
           dot(side[1], f.e[1]) == squared_norm(n);
}

// The border's line compared with an edge of wall_features. A view may turn n, and with it the speed and `inside`. A
// value x + v t at the smaller root is (a x - h v - v√D)/a.
constexpr bool agrees(const flat_edge<3, double>& x, const auto& view) {
    const auto at = [&](double value, double speed) { return edge_a{}(view)*value - edge_h{}(view)*speed; };
    using at_start = value_at_root<edge_a, edge_h, edge_foot<0>, edge_foot_speed>;
    using at_end = value_at_root<edge_a, edge_h, edge_foot<1>, edge_foot_speed>;
    const auto side = sides_of<3>(view.e)[0];
    return border_a{}(x) == edge_a{}(view) && border_h{}(x) == edge_h{}(view) && border_c{}(x) == edge_c{}(view) &&
           border_discriminant{}(x) == edge_reduced_discriminant{}(view) &&
           border_whole_discriminant{}(x) == edge_discriminant{}(view) &&
           x.dd * nearest_from_start{}(x) == at_start{}(view) && x.dd * nearest_from_end{}(x) == at_end{}(view) &&
           x.dd * touch_outside{}(x) == at(dot(view.w, side), dot(view.u, side)) &&
           touch_inward{}(x) == dot(view.u, side) && foot_from_start{}(x) == edge_foot<0>{}(view) &&
           foot_from_end{}(x) == edge_foot<1>{}(view);
}
constexpr bool sees_edges(const flat_motion<3, double>& f) {
    const auto m = wall_motion_of(f.w, f.u, f.e, f.r);
    const auto way = way_of(f);
    for (int k = 0; k < 4; ++k) {
        const auto view = seen_from(m, edge_view(k));
        const auto start = seen_from(m, wall_view{ends_of_border(k, false).start, false});
        const auto& d = f.e[k < 2 ? 1 : 0];
        if (!agrees(edge_of(start.w, f.u, d, f.r, inside_border{k, false}(way), inward_speed{k, false}(way), way.speed),
                    view)) {
            return false;
        }
    }
    return true;
}
// A triangle's third border as the edge λ_0 = 0 of the wall drawn from its end, whose edges lead to the corner and to
// the border's other end. Its first side is then e₀, and the ball's way is seen from there.
constexpr bool sees_third_border(const flat_motion<3, double>& f) {
    const auto way = way_of(f);
    const vec<3, double> d = f.e[1] - f.e[0];
    const auto other = wall_motion_of(f.w - f.e[0], f.u, std::array<vec<3, double>, 2>{-f.e[0], d}, f.r);
    const auto view = seen_from(wall_motion_of(f.w, f.u, f.e, f.r), edge_view(edge_number(1, true)));
    return view.w == other.w && view.u == other.u && view.e == other.e && view.r == other.r &&
           agrees(
               edge_of(f.w - f.e[0], f.u, d, f.r, inside_border{1, true}(way), inward_speed{1, true}(way), way.speed),
               other);
}

template <int N>
constexpr bool sees_corner(const flat_motion<N, double>& f) {
    const auto m = corner_motion(wall_motion_of(f.w, f.u, f.e, f.r));
    const double a = coefficient_a{}(m), h = coefficient_h{}(m);
    const auto x = corner_of(f.w, f.u, f.e[0], f.r, 0.0);
    return corner_h{}(x) == h && corner_c{}(x) == coefficient_c{}(m) &&
           corner_discriminant{}(x) == h * h - a * coefficient_c{}(m) &&
           nearest_from_start{}(x) == a * dot(f.w, f.e[0]) - h * dot(f.u, f.e[0]) &&
           direction_speed{}(x) == dot(f.u, f.e[0]);
}

// The norms belong to their two terms.
constexpr bool has_norms(const flat_motion<3, double>& f) {
    const auto way = way_of(f);
    const auto x = edge_of(f.w, f.u, f.e[0], f.r, inside_border{2, false}(way), inward_speed{2, false}(way), way.speed);
    const auto square = [](double y) { return y * y; };
    const double d = border_discriminant{}(x);
    return touch_along_norm<nearest_from_start>{}(x) == square(nearest_from_start{}(x)) * x.dd - square(x.ud) * d &&
           touch_along_norm<nearest_from_end>{}(x) == square(nearest_from_end{}(x)) * x.dd - square(x.ud) * d &&
           touch_outside_norm{}(x) == square(touch_outside{}(x)) * x.dd - square(x.inward) * d &&
           touch_behind_norm{}(x) == square(nearest_from_start{}(x)) - square(x.ud) * corner_discriminant{}(x) &&
           touch_inside_norm{2, false}(way) == square(x.inside) * way.nn - square(f.r * x.inward);
}

// (2r + d)² <= 20 r² + 5/4 d²: the difference is (4r - d/2)² over 1, exactly.
constexpr bool holds_beside(double r, double d) {
    return 4 * (20 * r * r) + 5 * d * d - 4 * (2 * r + d) * (2 * r + d) == (8 * r - d) * (8 * r - d);
}
static_assert(holds_beside(1, 0) && holds_beside(0, 1) && holds_beside(1, 1) && holds_beside(2, 3) &&
              holds_beside(3, 1));

constexpr bool all_points() {
    for (unsigned seed = 1; seed <= 60; ++seed) {
        const auto wall = any_motion<3>(seed, false);
        if (!crosses(any_motion<2>(seed, false)) || !crosses(wall) || !sees_edges(wall) || !sees_corner(wall) ||
            !has_sides(wall) || !sees_corner(any_motion<2>(seed, false)) ||
            !sees_third_border(any_motion<3>(seed, true)) || !has_norms(wall)) {
            return false;
        }
    }
    return true;
}
static_assert(all_points());

} // namespace
