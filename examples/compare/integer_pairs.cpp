#include "integer_pairs.hpp"

#include <graze/formula/discriminant.hpp>
#include <graze/formula/flat_encounter.hpp>
#include <graze/formula/plane_crossing.hpp>

namespace compare {

namespace {

using Z = exact_integer;

// The least common denominator of the numbers that were included.
class common_denominator {
  public:
    void include(const exact& x) { value_ = lcm(value_, Z(denominator(x))); }
    template <int N>
    void include(const graze::vec<N, exact>& x) {
        for (int i = 0; i < N; ++i) {
            include(x[i]);
        }
    }
    [[nodiscard]] Z times(const exact& x) const { return Z(numerator(x)) * (value_ / Z(denominator(x))); }
    template <int N>
    [[nodiscard]] graze::vec<N, Z> times(const graze::vec<N, exact>& x) const {
        return graze::make_vec<N>([&](int i) { return times(x[i]); });
    }

  private:
    Z value_ = 1;
};

// Answers the questions of graze::flat_decision by evaluating the formulas.
struct integer_judge {
    static constexpr bool has_roots = false;

    template <class F, class X>
    [[nodiscard]] int operator()(F f, const X& x) const {
        return graze::sign(Z(f(x)));
    }
};

template <int N>
graze::encounter encounter_with_flat(const graze::flat_motion<N, Z>& m) {
    const auto way = graze::way_of(m);
    return graze::flat_decision<N, Z, integer_judge>(m, way, integer_judge{})().what;
}

} // namespace

template <int N>
integer_scene<N> to_integers(const exact_scene<N>& scene) {
    common_denominator lengths, velocities;
    for (const exact_ball<N>& b : scene.balls) {
        lengths.include(b.shape.position);
        lengths.include(b.shape.radius);
        velocities.include(b.shape.velocity);
    }
    for (const graze::plane<N, exact>& p : scene.planes) {
        lengths.include(p.point);
    }
    for (const graze::wall<N, exact>& w : scene.walls) {
        lengths.include(w.corner);
        for (const auto& edge : w.edge) {
            lengths.include(edge);
        }
    }
    for (const graze::triangle<exact>& t : scene.triangles) {
        lengths.include(t.corner);
        lengths.include(t.edge[0]);
        lengths.include(t.edge[1]);
    }
    integer_scene<N> result;
    for (const exact_ball<N>& b : scene.balls) {
        result.balls.push_back(
            {lengths.times(b.shape.position), velocities.times(b.shape.velocity), lengths.times(b.shape.radius), Z(1)});
    }
    for (const graze::plane<N, exact>& p : scene.planes) {
        common_denominator normal;
        normal.include(p.normal);
        result.planes.push_back({lengths.times(p.point), normal.times(p.normal)});
    }
    for (const graze::wall<N, exact>& w : scene.walls) {
        graze::wall<N, Z> scaled{lengths.times(w.corner), {}};
        for (std::size_t i = 0; i < w.edge.size(); ++i) {
            scaled.edge[i] = lengths.times(w.edge[i]);
        }
        result.walls.push_back(scaled);
    }
    for (const graze::triangle<exact>& t : scene.triangles) {
        result.triangles.push_back({lengths.times(t.corner), {lengths.times(t.edge[0]), lengths.times(t.edge[1])}});
    }
    return result;
}

template <int N>
graze::encounter encounter_of_balls(const graze::ball<N, Z>& a, const graze::ball<N, Z>& b) {
    const auto m = graze::relative_motion_of(a, b);
    return graze::encounter_of([&] { return graze::sign(graze::coefficient_h{}(m)); },
                               [&] { return graze::sign(graze::coefficient_c{}(m)); },
                               [&] { return graze::sign(graze::discriminant_lagrange{}(m)); });
}

template <int N>
graze::encounter encounter_with_plane(const graze::ball<N, Z>& b, const graze::plane<N, Z>& p) {
    const auto m = graze::relative_motion_of(b, p);
    return graze::encounter_of(
        [&] { return graze::sign(graze::plane_height{}(m)) * graze::sign(graze::plane_speed{}(m)); },
        [&] { return graze::sign(graze::plane_clearance{}(m)); }, [] { return 1; });
}

template <int N>
graze::encounter encounter_with_wall(const graze::ball<N, Z>& b, const graze::wall<N, Z>& w) {
    return encounter_with_flat<N>({b.position - w.corner, b.velocity, w.edge, b.radius, false});
}

graze::encounter encounter_with_triangle(const graze::ball<3, Z>& b, const graze::triangle<Z>& t) {
    return encounter_with_flat<3>({b.position - t.corner, b.velocity, t.edge, b.radius, true});
}

template integer_scene<2> to_integers<2>(const exact_scene<2>&);
template integer_scene<3> to_integers<3>(const exact_scene<3>&);
template graze::encounter encounter_of_balls<2>(const graze::ball<2, Z>&, const graze::ball<2, Z>&);
template graze::encounter encounter_of_balls<3>(const graze::ball<3, Z>&, const graze::ball<3, Z>&);
template graze::encounter encounter_with_plane<2>(const graze::ball<2, Z>&, const graze::plane<2, Z>&);
template graze::encounter encounter_with_plane<3>(const graze::ball<3, Z>&, const graze::plane<3, Z>&);
template graze::encounter encounter_with_wall<2>(const graze::ball<2, Z>&, const graze::wall<2, Z>&);
template graze::encounter encounter_with_wall<3>(const graze::ball<3, Z>&, const graze::wall<3, Z>&);

} // namespace compare
