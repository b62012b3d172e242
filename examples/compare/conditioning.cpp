#include "conditioning.hpp"

#include "wide_vec.hpp"

#include <limits>

// F(τ, x) = 0 gives ∂τ/∂x = -(∂F/∂x)/(∂F/∂τ), so the condition number of τ is Σ |x ∂F/∂x| / |τ ∂F/∂τ|. An input that is
// the difference of two (a position from another) counts with the magnitudes of both.

namespace compare {

namespace {

template <int N>
wide_vec<N> magnitudes(const wide_vec<N>& x) {
    return graze::make_vec<N>([&](int i) { return wide(abs(x[i])); });
}

// Σ |x_i y_i|, where x is given by its magnitudes.
template <int N>
wide weight(const wide_vec<N>& x, const wide_vec<N>& y) {
    return graze::dot(x, magnitudes(y));
}

double ratio(const wide& sum, const wide& by) {
    return by == 0 ? std::numeric_limits<double>::infinity() : scaled(wide(sum / abs(by)), 0);
}

// Two balls, or a ball and a corner (u_b and R's second part are 0): |dx + du τ|² = R².
template <int N>
struct approach {
    wide_vec<N> dx, du, size_x, size_u; // size_x: |x_a| + |x_b|, by component
    wide R;
};

template <int N>
void set_conditions_of(truth& t, const approach<N>& p) {
    const wide a = graze::dot(p.du, p.du), h = graze::dot(p.dx, p.du), c = graze::dot(p.dx, p.dx) - p.R * p.R;
    const wide discriminant = h * h - a * c;
    if (t.discriminant && t.discriminant->value() != 0) {
        const wide two(2);
        const wide sum = weight(p.size_x, two * (h * p.du - a * p.dx)) + weight(p.size_u, two * (h * p.dx - c * p.du)) +
                         two * a * p.R * p.R;
        t.discriminant_condition = ratio(sum, discriminant);
    }
    if (!graze::is_collision(t.what) || t.time.value() == 0) {
        return;
    }
    const wide tau = t.time.value();
    const wide_vec<N> m = p.dx + tau * p.du;
    const wide sum = weight(p.size_x, m) + tau * weight(p.size_u, m) + p.R * p.R;
    t.time_condition = t.what == graze::encounter::graze ? std::numeric_limits<double>::infinity()
                                                         : ratio(sum, tau * graze::dot(m, p.du));
}

// A plane: (w + u τ)·n = ±r|n|.
template <int N>
void set_face_condition(truth& t, const graze::ball<N, exact>& ball, const graze::vec<N, exact>& point,
                        const wide_vec<N>& n) {
    const wide tau = t.time.value();
    const wide_vec<N> u = widened(ball.velocity), x = widened(ball.position), p = widened(point);
    const wide_vec<N> at_contact = x - p + tau * u;
    const wide r = to_wide(ball.radius), length = sqrt(graze::dot(n, n));
    const wide reach = graze::dot(at_contact, n) < 0 ? wide(-r) : r;
    const wide_vec<N> by_normal = at_contact - (reach / length) * n;
    const wide sum = weight(magnitudes(x) + magnitudes(p), n) + tau * weight(magnitudes(u), n) +
                     weight(magnitudes(n), by_normal) + r * length;
    t.time_condition = ratio(sum, tau * graze::dot(u, n));
}

// An edge: |(w + u τ) × e|² = r²|e|².
void set_edge_condition(truth& t, const graze::ball<3, exact>& ball, const graze::vec<3, exact>& from,
                        const graze::vec<3, exact>& along) {
    const wide tau = t.time.value(), two(2);
    const wide_vec<3> u = widened(ball.velocity), x = widened(ball.position), p = widened(from), e = widened(along);
    const wide r = to_wide(ball.radius);
    const wide_vec<3> w = x - p + tau * u;
    const wide_vec<3> g = cross(w, e);
    const wide_vec<3> by_position = two * cross(e, g), by_edge = two * (cross(g, w) - (r * r) * e);
    const wide sum = weight(magnitudes(x) + magnitudes(p), by_position) + tau * weight(magnitudes(u), by_position) +
                     weight(magnitudes(e), by_edge) + two * r * r * graze::dot(e, e);
    t.time_condition = t.what == graze::encounter::graze ? std::numeric_limits<double>::infinity()
                                                         : ratio(sum, tau * two * graze::dot(g, cross(u, e)));
}

// The corner of this index.
template <int N>
graze::vec<N, exact> corner_of(const graze::wall<N, exact>& wall, int index) {
    graze::vec<N, exact> result = wall.corner;
    for (std::size_t i = 0; i < wall.edge.size(); ++i) {
        if ((index >> i & 1) != 0) {
            result = result + wall.edge[i];
        }
    }
    return result;
}

template <int N>
wide_vec<N> normal_of(const graze::wall<N, exact>& wall) {
    if constexpr (N == 2) {
        return widened<2>({{exact(-wall.edge[0][1]), wall.edge[0][0]}});
    } else {
        return widened<3>(cross(wall.edge[0], wall.edge[1]));
    }
}

} // namespace

template <int N>
void set_conditions(truth& t, const problem<N>& pair) {
    const graze::ball<N, exact>& a = pair.a.shape;
    const bool has_time = graze::is_collision(t.what) && t.time.value() != 0;
    if (t.kind == pair_kind::ball_ball) {
        const graze::ball<N, exact>& b = pair.b.shape;
        const auto sizes = [](const graze::vec<N, exact>& x, const graze::vec<N, exact>& y) {
            return magnitudes(widened(x)) + magnitudes(widened(y));
        };
        set_conditions_of(t, approach<N>{widened<N>(a.position - b.position), widened<N>(a.velocity - b.velocity),
                                         sizes(a.position, b.position), sizes(a.velocity, b.velocity),
                                         to_wide(exact(a.radius + b.radius))});
    } else if (has_time && t.kind == pair_kind::ball_plane) {
        set_face_condition(t, a, pair.plane.point, widened(pair.plane.normal));
    } else if (has_time && t.where == graze::feature::face) {
        set_face_condition(t, a, pair.wall.corner, normal_of(pair.wall));
    } else if (has_time && t.where == graze::feature::corner) {
        const graze::vec<N, exact> corner = corner_of(pair.wall, t.index);
        set_conditions_of(t, approach<N>{widened<N>(a.position - corner), widened(a.velocity),
                                         magnitudes(widened(a.position)) + magnitudes(widened(corner)),
                                         magnitudes(widened(a.velocity)), to_wide(a.radius)});
    } else if constexpr (N == 3) {
        if (has_time) {
            const auto side = static_cast<std::size_t>(t.index / 2);
            const graze::vec<3, exact> from =
                t.index % 2 == 0 ? pair.wall.corner : pair.wall.corner + pair.wall.edge[side];
            const bool is_slanted = t.kind == pair_kind::ball_triangle && t.index == 1; // from corner 1 to corner 2
            set_edge_condition(t, a, from,
                               is_slanted ? pair.wall.edge[1] - pair.wall.edge[0] : pair.wall.edge[1 - side]);
        }
    }
}

template void set_conditions(truth&, const problem<2>&);
template void set_conditions(truth&, const problem<3>&);

} // namespace compare
