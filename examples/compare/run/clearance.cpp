#include "clearance.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace compare::run {

namespace {

certified within_0_and_1(const certified& x) { return -larger(-larger(x, 0), -1); }

template <int N>
vector_of<N> either(const vector_of<N>& x, const vector_of<N>& y) {
    return graze::make_vec<N>([&](int i) { return run::either(x[i], y[i]); });
}

// The nearest of the points. If that is open, an enclosure of all that may be nearest.
template <int N, std::size_t K>
vector_of<N> nearest_among(const std::array<vector_of<N>, K>& points, const vector_of<N>& to) {
    std::array<certified, K> distances;
    std::transform(points.begin(), points.end(), distances.begin(),
                   [&](const vector_of<N>& x) { return graze::squared_norm(x - to); });
    std::optional<vector_of<N>> found;
    for (std::size_t i = 0; i < K; ++i) {
        const bool is_farther = std::any_of(distances.begin(), distances.end(),
                                            [&](const certified& d) { return (distances[i] - d).certain_sign() == 1; });
        if (!is_farther) {
            found = found ? either<N>(*found, points[i]) : points[i];
        }
    }
    return *found;
}

} // namespace

template <int N>
vector_of<N> nearest_on_segment(const vector_of<N>& corner, const vector_of<N>& edge, const vector_of<N>& x) {
    return corner + within_0_and_1(graze::dot(x - corner, edge) / graze::squared_norm(edge)) * edge;
}
template vector_of<2> nearest_on_segment(const vector_of<2>&, const vector_of<2>&, const vector_of<2>&);
template vector_of<3> nearest_on_segment(const vector_of<3>&, const vector_of<3>&, const vector_of<3>&);

template <>
vector_of<2> nearest_point<2>(const graze::wall<2, certified>& w, const vector_of<2>& x) {
    return nearest_on_segment<2>(w.corner, w.edge[0], x);
}

namespace {

// The foot of the perpendicular if it lies inside, else the nearest point of the border. The foot is inside if none of
// the numbers that `within` computes from its coordinates along the edges is negative.
template <class Within, class Border>
vector_of<3> nearest_of(const vector_of<3>& corner, const std::array<vector_of<3>, 2>& edge, const vector_of<3>& x,
                        Within within, Border border) {
    const vector_of<3>&e = edge[0], &f = edge[1];
    const vector_of<3> from = x - corner;
    const certified ee = graze::squared_norm(e), ef = graze::dot(e, f), ff = graze::squared_norm(f);
    const certified along_e = graze::dot(from, e), along_f = graze::dot(from, f), area = ee * ff - ef * ef;
    const certified s = (ff * along_e - ef * along_f) / area, t = (ee * along_f - ef * along_e) / area;
    bool inside = true, outside = false;
    for (const certified& part : within(s, t)) {
        const std::optional<int> sign = part.certain_sign();
        inside = inside && sign && *sign >= 0;
        outside = outside || sign == -1;
    }
    const vector_of<3> foot = corner + s * e + t * f;
    if (inside) {
        return foot;
    }
    return outside ? border() : either<3>(foot, border());
}

} // namespace

template <>
vector_of<3> nearest_point<3>(const graze::wall<3, certified>& w, const vector_of<3>& x) {
    const vector_of<3>&e = w.edge[0], &f = w.edge[1];
    return nearest_of(
        w.corner, w.edge, x,
        [](const certified& s, const certified& t) {
            return std::array<certified, 4>{s, certified(1) - s, t, certified(1) - t};
        },
        [&] {
            return nearest_among<3, 4>(
                {nearest_on_segment<3>(w.corner, e, x), nearest_on_segment<3>(w.corner + f, e, x),
                 nearest_on_segment<3>(w.corner, f, x), nearest_on_segment<3>(w.corner + e, f, x)},
                x);
        });
}

template <>
vector_of<3> nearest_point<3>(const graze::triangle<certified>& w, const vector_of<3>& x) {
    const vector_of<3>&e = w.edge[0], &f = w.edge[1];
    return nearest_of(
        w.corner, w.edge, x,
        [](const certified& s, const certified& t) {
            return std::array<certified, 3>{s, t, certified(1) - s - t};
        },
        [&] {
            return nearest_among<3, 3>({nearest_on_segment<3>(w.corner, e, x), nearest_on_segment<3>(w.corner, f, x),
                                        nearest_on_segment<3>(w.corner + e, f - e, x)},
                                       x);
        });
}

} // namespace compare::run
