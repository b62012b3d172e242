// What is wrong or missing in the source, line by line: each printed form is refuted by an example, for which the
// corrected form holds. The neighbouring files prove that the corrected forms always hold: discriminant.cpp, roots.cpp,
// contact.cpp, impulse.cpp, plane_crossing.cpp, wall_features.cpp.
#include <graze/exact/integer.hpp>
#include <graze/number/floating.hpp>
#include <graze/solve.hpp>
#include <graze/time/time_of_shapes.hpp>

#include "../variables.hpp"

namespace {

using namespace graze;
using number = integer<40>;

// Two balls on a line.
constexpr ball<2> a{{0, 0}, {1, 0}, 1, 1};
constexpr ball<2> b{{10, 0}, {-1, 0}, 1, 1};
constexpr auto s = solve(a, b);

// (2): Δx points from b to a, not from a to b, and so does the normal.
static_assert(relative_motion_of(a, b).dx[0] == -10 && s.normal[0] == -1);

// (3), (20): |Δx|² = R² and X̂ = x/(r_a + r_b) at contact, not before.
constexpr auto m = relative_motion_of(a, b);
constexpr auto at_contact = position_at(m.dx, m.du, s.time);
static_assert(squared_norm(m.dx) != m.R * m.R && squared_norm(contact_normal(m.dx, m.R)) != 1);
static_assert(squared_norm(at_contact) == m.R * m.R && squared_norm(contact_normal(at_contact, m.R)) == 1);

// (12) without its parentheses: Δx = (10, 2.2), Δu = (-2, 0), R = 3, lengths in tenths. The balls collide.
constexpr relative_motion<2, number, number, number> collide{{{100, 22}}, {{-20, 0}}, 30};
constexpr auto q = quadratic_of(collide);
constexpr auto printed = q.h * q.h - (q.a * squared_norm(collide.dx) - collide.R * collide.R);
static_assert(sign(printed) < 0, "the printed (12) says that they do not meet");
static_assert(sign(discriminant_halved{}(q)) > 0, "corrected, it says that they do");

// (12), "the first condition", is not enough. Parting balls have real roots, and so do balls inside each other, whose
// larger root is the time at which they would part again.
static_assert(solve(b, ball<2>{{9, 0}, {0, 0}, 1}).discriminant > 0 &&
              solve(b, ball<2>{{9, 0}, {0, 0}, 1}).what == encounter::overlap);
static_assert(solve(b, ball<2>{{7, 0}, {-2, 0}, 1}).discriminant > 0 &&
              solve(b, ball<2>{{7, 0}, {-2, 0}, 1}).what == encounter::recede);
constexpr double larger = (-quadratic_of(m).h + 4) / quadratic_of(m).a; // √D = 4
static_assert(discriminant_lagrange{}(m) == 16 && s.time == 4 && larger == 6);
static_assert(a.position[0] + larger * a.velocity[0] > b.position[0] + larger * b.velocity[0], "passed through");

// (11): b² - 4ac and (-b - √(b² - 4ac))/(2a) are right, but cancel. For a gap of 2^-20, c/(-h + √D) is within 2^-51 of
// the exact time, and the printed root is not within 2^-40. For balls 2^30 apart that miss each other by 2^-20,
// Lagrange's form says so, and h² - ac does not.
constexpr ball<2> still{{0, 0}, {0, 0}, 0.5};
constexpr ball<2> close{{1 + 0x1p-20, 0}, {-1, 0.1}, 0.5};
constexpr bool is_near(double time, double relative) {
    const auto exact = *time_of_impact(still, close);
    return exact > time * (1 - relative) && exact < time * (1 + relative);
}
static_assert(is_near(solve<variant::halved, root_form::stable>(still, close).time, 0x1p-51));
static_assert(!is_near(solve<variant::textbook, root_form::printed>(still, close).time, 0x1p-40));
constexpr ball<2> far{{0x1p30 + 1, 3}, {-1, 0}, 2.5};
static_assert(solve<variant::lagrange>(still, far).what == encounter::graze);
static_assert(solve<variant::lagrange>(still, ball<2>{{0x1p30 + 1, 3 + 0x1p-20}, {-1, 0}, 2.5}).what ==
              encounter::miss);
static_assert(solve<variant::halved>(still, ball<2>{{0x1p30 + 1, 3 + 0x1p-20}, {-1, 0}, 2.5}).what != encounter::miss);

// (18) holds if its right side has the sign that follows from (17); as printed it does not hold.
constexpr auto t = solve(ball<2>{{0, 0}, {2, 0}, 1, 1}, b);
constexpr double of_a = (2 - t.velocity_a[0]) * (2 + t.velocity_a[0]);
constexpr double of_b = (-1 - t.velocity_b[0]) * (-1 + t.velocity_b[0]);
static_assert(of_a == -of_b && of_a != of_b);

// (22) divides (18) by α. If α = 0 that is not allowed: unchanged velocities satisfy (18) and (21), but not (22), for a
// normal along which the balls approach.
constexpr vec<2, double> x_hat{{-1, 0}};
static_assert(dot(a.velocity - a.velocity, a.velocity + a.velocity) ==
              -dot(b.velocity - b.velocity, b.velocity + b.velocity));
static_assert(dot(x_hat, a.velocity + a.velocity) != dot(x_hat, b.velocity + b.velocity));
constexpr ball<2> passing{{10, 2}, {-1, 0}, 1, 1};
static_assert(solve(a, passing).what == encounter::graze && solve(a, passing).velocity_a == a.velocity &&
              solve(a, passing).velocity_b == passing.velocity);

// (21): α is not in (0, ∞): it is negative for balls that approach and zero for a graze. With its magnitude in (23) the
// balls would approach faster afterwards.
constexpr double alpha = impulse(reduced_mass(1.0, 1.0), s.normal, m.du);
static_assert(alpha == -2 && impulse(reduced_mass(1.0, 1.0), solve(a, passing).normal, m.du) == 0);
static_assert(s.velocity_a[0] == -1 && velocity_after(a.velocity, -alpha, 1.0, s.normal)[0] == 3);

// "Applying (23) to (18)": (24) results from (23) and (22). From (18) results α times (24), which says nothing if α =
// 0. As an identity in u_a, u_b, X̂, α and the inverse masses.
using function = rational_function<512>;
static_assert([] {
    const auto u_a = proof::vector<3, function>(0);
    const auto u_b = proof::vector<3, function>(3);
    const auto n = proof::vector<3, function>(6);
    const auto any_alpha = proof::letter<function>(9);
    const auto w_a = proof::letter<function>(10);
    const auto w_b = proof::letter<function>(11);
    const auto v_a = velocity_after(u_a, any_alpha, w_a, n);
    const auto v_b = velocity_after(u_b, -any_alpha, w_b, n);
    const function by_22 = dot(n, u_a + v_a) - dot(n, u_b + v_b);
    const function by_18 = dot(u_a - v_a, u_a + v_a) / w_a + dot(u_b - v_b, u_b + v_b) / w_b;
    return by_18 == any_alpha * by_22;
}());

// (24), (26), (29): X̂ beside a vector is an inner product, a number. Without a dot it is no product at all:
// negative/two_vectors_side_by_side.cpp.
static_assert(std::is_same_v<std::remove_const_t<decltype(alpha)>, double>);

// (29), completed by (23): v_a = u_a - 2 m_b/(m_a + m_b) ⟨Δu,X̂⟩ X̂; and ⟨Δu,X̂⟩ = -√D/R.
constexpr auto heavy = solve(ball<2>{{0, 0}, {1, 0}, 1, 2}, ball<2>{{10, 0}, {-1, 0}, 1, 6});
static_assert(heavy.velocity_a[0] == 1 - 2 * 6. / 8 * 2 && heavy.velocity_b[0] == -1 + 2 * 2. / 8 * 2);
static_assert(dot(m.du, s.normal) == -4. / 2);

// (33) as printed is the time at which the centre arrives. The ball touches earlier, on either side. Parallel motion
// has no such time, even inside the plane.
constexpr ball<2> towards{{0, 0}, {1, 0}, 1};
constexpr plane<2> far_plane{{7, 0}, {-2, 0}};
static_assert(solve(towards, far_plane).time == 6);
static_assert(centre_crossing_time{}(plane_height{}(relative_motion_of(towards, far_plane)),
                                     plane_speed{}(relative_motion_of(towards, far_plane))) == 7);
static_assert(solve(ball<2>{{14, 0}, {-1, 0}, 1}, far_plane).time == 6);
static_assert(solve(ball<2>{{6.5, 0}, {0, 1}, 1}, far_plane).what == encounter::recede);

// Section 2.2 after (33): whether the point is in the rectangle, which balls meet edges and corners, where, and with
// what velocity they leave. The plane is met in each case.
constexpr wall<3> square{{5, -3, -3}, {{{{0, 6, 0}}, {{0, 0, 6}}}}};
constexpr plane<3> its_plane{{5, -3, -3}, {1, 0, 0}};
constexpr auto met(double y, double z) { return solve(ball<3>{{0, y, z}, {1, 0, 0}, 2}, square); }
static_assert(met(1, 2).where == feature::face && met(1, 2).time == 3 && met(1, 2).point == vec<3, double>{{5, 1, 2}} &&
              met(1, 2).velocity == vec<3, double>{{-1, 0, 0}});
static_assert(met(4, 2).where == feature::edge && met(4, 2).time > 3 && met(4, 2).point == vec<3, double>{{5, 3, 2}});
static_assert(met(4, 4).where == feature::corner && met(4, 4).point == vec<3, double>{{5, 3, 3}});
static_assert(met(5.5, 0).what == encounter::miss);
static_assert(solve(ball<3>{{0, 5.5, 0}, {1, 0, 0}, 2}, its_plane).what == encounter::hit);

// Section 2.1: a normal does not say how a rectangle lies in its plane. These two have the same normal, a common corner
// and the same sides, but a point meets only one of them.
constexpr wall<3> upright{{5, 0, 0}, {{{{0, 5, 0}}, {{0, 0, 5}}}}};
constexpr wall<3> tilted{{5, 0, 0}, {{{{0, 3, 4}}, {{0, -4, 3}}}}};
constexpr ball<3> point{{0, 4.5, 0.5}, {1, 0, 0}, 0};
static_assert(face_normal(relative_motion_of(point, upright).e) == face_normal(relative_motion_of(point, tilted).e));
static_assert(solve(point, upright).what == encounter::hit && solve(point, tilted).what == encounter::miss);

// Edges in doubles are seldom at right angles: (2, 3, 6)/7 and (3, -6, 2)/7 are, but not when rounded. So a wall is a
// parallelogram. The first point misses it where a rectangle around it would be met; the second point meets it.
template <int N>
constexpr bool at_right_angles(const vec<N, double>& x, const vec<N, double>& y) { // of multiples of 2^-53 below 2^9
    const auto exact = [](const vec<N, double>& v) {
        return make_vec<N>(
            [&](int i) { return integer<63>::from_shifted(static_cast<std::int64_t>(v[i] * 0x1p53), 0); });
    };
    return sign(dot(exact(x), exact(y))) == 0;
}
static_assert(at_right_angles<3>({{0.25, 0.375, 0.75}}, {{0.375, -0.75, 0.25}}));
static_assert(!at_right_angles<3>({{2. / 7, 3. / 7, 6. / 7}}, {{3. / 7, -6. / 7, 2. / 7}}));
constexpr wall<3> slanted{{5, 0, 0}, {{{{0, 6, 0}}, {{0, 3, 6}}}}};
constexpr encounter at_slanted(double y, double z) { return solve(ball<3>{{0, y, z}, {1, 0, 0}, 0}, slanted).what; }
static_assert(at_slanted(1, 5) == encounter::miss && at_slanted(8, 5) == encounter::hit);

} // namespace
