// Recorded steps, run in big integers, have the signs that the formulas have in rational numbers.
#include <graze/number/adapter/gmp.hpp>
#include <graze/pair/flat_stages.hpp>

#include <doctest/doctest.h>

#include <random>

namespace {

using graze::detail::big_integer;
using graze::detail::flat_name;
using graze::detail::flat_place_name;
using rational = graze::gmp_rational;

struct rational_judge {
    static constexpr bool has_roots = false;

    template <class F, class X>
    int operator()(F f, const X& x) const {
        return sgn(rational(f(x)).value());
    }
};

using questions = graze::detail::recorded_questions<3, big_integer, graze::detail::exact_judge>;
using view = graze::flat_view<3, rational, rational_judge>;

template <class I, class Number>
graze::flat_motion<3, I> motion(std::mt19937 draw, bool is_triangle, Number number) {
    std::uniform_int_distribution<int> coordinate(-3, 3);
    const auto vector = [&] { return graze::make_vec<3>([&](int) { return number(coordinate(draw)); }); };
    graze::flat_motion<3, I> m{vector(), vector(), {}, {}, is_triangle};
    for (auto& e : m.e) {
        e = vector();
    }
    m.r = number(std::uniform_int_distribution<int>(0, 3)(draw));
    return m;
}

void check_pair(unsigned seed, bool is_triangle) {
    CAPTURE(seed);
    CAPTURE(is_triangle);
    const std::mt19937 draw(seed);
    const auto exact = motion<rational>(draw, is_triangle, [](int x) { return rational(x); });
    const auto way = graze::way_of(exact);
    const rational_judge judge;
    const view formulas(exact, way, judge);

    graze::detail::exact_workspace room;
    const auto shifted = [&](int x) { return big_integer::from_shifted(room, x, 0); };
    questions steps(motion<big_integer>(draw, is_triangle, shifted), graze::detail::exact_judge{&room});
    const auto same = [&](flat_name which, flat_place_name of, int sign) {
        CAPTURE(static_cast<int>(which));
        CAPTURE(of.border);
        CAPTURE(of.corner);
        CHECK(steps.sign(which, of) == sign);
    };

    same(flat_name::square, {}, formulas.of_way(graze::way_square{}));
    same(flat_name::speed, {}, formulas.of_way(graze::way_speed{}));
    same(flat_name::height, {}, formulas.of_way(graze::way_height{}));
    same(flat_name::clearance_of_plane, {}, formulas.clearance_of_plane());
    for (int k = 0; k < graze::borders_of(3, is_triangle); ++k) {
        const flat_place_name edge{k, -1};
        const auto x = formulas.seen_from_border(k);
        const auto of_edge = [&]<class F>(F f) {
            same(graze::detail::name_of_formula<F>, edge, formulas.of_feature(f, x));
        };
        of_edge(graze::border_h{});
        of_edge(graze::border_c{});
        of_edge(graze::border_discriminant{});
        same(flat_name::inside_now, {k}, formulas.inside_of(formulas.place(), k));
        of_edge(graze::nearest_from_start{});
        of_edge(graze::nearest_from_end{});
        of_edge(graze::foot_from_start{});
        of_edge(graze::foot_from_end{});
        of_edge(graze::direction_speed{});
        of_edge(graze::touch_along_norm<graze::nearest_from_start>{});
        of_edge(graze::touch_along_norm<graze::nearest_from_end>{});
        of_edge(graze::touch_outside{});
        of_edge(graze::touch_inward{});
        of_edge(graze::touch_outside_norm{});
        same(flat_name::inside, {k}, formulas.of_way(graze::inside_border{k, is_triangle}));
        same(flat_name::inward, {k}, formulas.of_way(graze::inward_speed{k, is_triangle}));
        if (const int speed = formulas.of_way(graze::way_speed{}); speed != 0) {
            same(flat_name::inside_at_touch, {k}, formulas.inside_at_touch(k, speed));
        }
    }
    for (int corner = 0; corner < graze::borders_of(3, is_triangle); ++corner) {
        const int first = is_triangle ? (corner == 1 ? 1 : 0) : corner % 2;
        for (const int k : {first, graze::other_border(corner, first, is_triangle)}) {
            const auto x = formulas.seen_from_corner(corner, k);
            const auto of_corner = [&]<class F>(F f) {
                same(graze::detail::name_of_formula<F>, {k, corner}, formulas.of_feature(f, x));
            };
            of_corner(graze::corner_h{});
            of_corner(graze::corner_c{});
            of_corner(graze::corner_discriminant{});
            of_corner(graze::nearest_from_start{});
            of_corner(graze::direction_speed{});
            of_corner(graze::touch_behind_norm{});
        }
        same(flat_name::corner_c, {-1, corner},
             formulas.of_feature(graze::corner_c{}, formulas.seen_from_corner(corner)));
    }
}

} // namespace

TEST_CASE("Recorded steps have the signs of the formulas") {
    for (unsigned seed = 0; seed < 400; ++seed) {
        check_pair(seed, false);
        check_pair(seed, true);
    }
}
