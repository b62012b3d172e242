#include "clearance.hpp"

namespace compare::run {

namespace {

certified within_0_and_1(const certified& x) { return -larger(-larger(x, 0), -1); }

template <int N>
vector_of<N> either(const vector_of<N>& x, const vector_of<N>& y) {
    return graze::make_vec<N>([&](int i) { return run::either(x[i], y[i]); });
}

template <int N>
vector_of<N> nearest_on_segment(const vector_of<N>& corner, const vector_of<N>& edge, const vector_of<N>& x) {
    return corner + within_0_and_1(graze::dot(x - corner, edge) / graze::squared_norm(edge)) * edge;
}

// Of the two points, the nearer one.
template <int N>
vector_of<N> nearer(const vector_of<N>& x, const vector_of<N>& y, const vector_of<N>& to) {
    const auto order = (graze::squared_norm(x - to) - graze::squared_norm(y - to)).certain_sign();
    return !order ? either<N>(x, y) : *order <= 0 ? x : y;
}

} // namespace

template <>
vector_of<2> nearest_point<2>(const graze::wall<2, certified>& w, const vector_of<2>& x) {
    return nearest_on_segment<2>(w.corner, w.edge[0], x);
}

// The foot of the perpendicular if it lies on the parallelogram, else the nearest point of its border.
template <>
vector_of<3> nearest_point<3>(const graze::wall<3, certified>& w, const vector_of<3>& x) {
    const vector_of<3>&e = w.edge[0], &f = w.edge[1];
    const vector_of<3> from = x - w.corner;
    const certified ee = graze::squared_norm(e), ef = graze::dot(e, f), ff = graze::squared_norm(f);
    const certified along_e = graze::dot(from, e), along_f = graze::dot(from, f), area = ee * ff - ef * ef;
    const certified s = (ff * along_e - ef * along_f) / area, t = (ee * along_f - ef * along_e) / area;
    bool inside = true, outside = false;
    for (const certified& part : {s, certified(1) - s, t, certified(1) - t}) {
        const std::optional<int> sign = part.certain_sign();
        inside = inside && sign && *sign >= 0;
        outside = outside || sign == -1;
    }
    const vector_of<3> foot = w.corner + s * e + t * f;
    if (inside) {
        return foot;
    }
    const vector_of<3> border =
        nearer<3>(nearer<3>(nearest_on_segment<3>(w.corner, e, x), nearest_on_segment<3>(w.corner + f, e, x), x),
                  nearer<3>(nearest_on_segment<3>(w.corner, f, x), nearest_on_segment<3>(w.corner + e, f, x), x), x);
    return outside ? border : either<3>(foot, border);
}

} // namespace compare::run
