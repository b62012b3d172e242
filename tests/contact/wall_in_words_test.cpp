// The fast path of contacts with planes and walls, compared with the integers: where it is certain, the bits are the
// same, and it is certain of nearly everything that is not degenerate.
#include "../soak/soak.hpp"

#include <graze/collide.hpp>

#include <doctest/doctest.h>

#include <vector>

namespace {

using graze::detail::component_set;

struct seen {
    int contacts = 0, certain = 0, wrong = 0; // certain: of all components
};

template <int N, class T>
std::vector<T> listed(const graze::wall_contact<N, T>& c) {
    std::vector<T> list{c.time};
    for (const auto* v : {&c.position, &c.point, &c.normal, &c.velocity}) {
        for (int i = 0; i < 3; ++i) {
            list.push_back(i < N ? (*v)[i] : T(0));
        }
    }
    return list;
}

template <class P, int N, class T, class Shape>
void look(P pair, seen& s, const graze::wall_encounter& found, const graze::ball<N, T>& b, const Shape& shape,
          double near) { // near: the time in doubles; 0 if unknown
    if (!graze::is_collision(found.what)) {
        return;
    }
    graze::wall_contact<N, T> fast;
    fast.feature = found.where;
    fast.velocity = b.velocity;
    if (found.what == graze::encounter::overlap) {
        fast.position = graze::detail::with_plain_zeros(b.position);
    }
    graze::wall_contact<N, T> exact = fast;
    const component_set open_components = graze::detail::contact_by_words(pair, fast, found.what, found.index, b, shape,
                                                                          near, graze::detail::own_clock{});
    graze::detail::complete(pair, exact, graze::detail::all_components, found.what, found.index, b, shape);
    const auto x = listed(fast), y = listed(exact);
    for (std::size_t i = 0; i < x.size(); ++i) {
        const bool is_open = (open_components >> i & 1U) != 0;
        s.wrong += is_open || graze::detail::bits_of(x[i]) == graze::detail::bits_of(y[i]) ? 0 : 1;
    }
    ++s.contacts;
    s.certain += open_components == 0 ? 1 : 0;
}

// With a first step from the time in doubles, if that is known, and without.
template <class P, int N, class T, class Shape>
void look(P pair, seen& s, const Shape& shape, const graze::ball<N, T>& b) {
    graze::stage by{};
    const auto met = graze::detail::meet_flat(b, shape, by);
    const graze::wall_encounter found{met.found.what, met.found.where, met.found.index};
    look(pair, s, found, b, shape, met.bounds.near);
    if (met.bounds.is_known()) {
        look(pair, s, found, b, shape, 0);
    }
}

template <int N, class T>
graze::vec<N, T> to(const graze::vec<N, double>& x) {
    return graze::make_vec<N>([&](int i) { return static_cast<T>(x[i]); });
}

template <int N, class T>
seen look_at(const families::family& family, std::uint64_t count) {
    seen s;
    for (std::uint64_t i = 0; i < count; ++i) {
        const auto pair = family.draw<N>(13, i);
        const graze::ball<N, T> b{to<N, T>(pair.a.position), to<N, T>(pair.a.velocity), static_cast<T>(pair.a.radius)};
        if (pair.kind == families::pair_kind::ball_plane) {
            const graze::plane<N, T> p{to<N, T>(pair.plane.point), to<N, T>(pair.plane.normal)};
            look(graze::detail::ball_and_plane<N>{}, s, p, b);
        } else if (pair.kind == families::pair_kind::ball_wall) {
            graze::wall<N, T> w{to<N, T>(pair.wall.corner), {}};
            for (std::size_t k = 0; k < w.edge.size(); ++k) {
                w.edge[k] = to<N, T>(pair.wall.edge[k]);
            }
            look(graze::detail::ball_and_wall<N>{}, s, w, b);
        }
    }
    return s;
}

// Whether integers are hardly ever needed for this family.
bool is_plain(const families::family& family) {
    return family.name == "edges_and_corners" || family.name == "borders" || family.name == "two_walls" ||
           family.name == "generic_wall";
}

void check(const families::family& family, const seen& s) {
    CHECK(s.wrong == 0);
    if (is_plain(family)) {
        CHECK(s.contacts > 50);
        CHECK(10 * s.certain > 9 * s.contacts);
    }
}

} // namespace

TEST_CASE("what is certain without integers is what integers say") {
    for (const families::family& family : soak::families_drawn) {
        CAPTURE(family.name);
        check(family, look_at<3, double>(family, 300));
        if (is_plain(family)) {
            check(family, look_at<2, float>(family, 300));
        }
    }
}

TEST_CASE("edges that are all but along an axis, met far from their ends") {
    using ball = graze::ball<3>;
    using wall = graze::wall<3>;
    seen s;
    // Each has a component of the velocity that is within 2^-66 of the middle between two doubles.
    const auto look_at_edge = [&s](const ball& b, const wall& w) { look(graze::detail::ball_and_wall<3>{}, s, w, b); };
    look_at_edge({{0x1.1b5727373fff2p+18, -0x1.c5e7fabaa2b08p+1, -0x1.37a09a34c4a64p+1},
                  {0x1.7be533d9f3826p-1, 0x1.0e387450ce513p-1, 0x1.c413ad5ab9dd8p-2},
                  0x1.0ad12045ee01ep+0},
                 {{0x1.c7cd9f1e279p-6, -0x1.179feaea8ac22p-1, -0x1.bd04d1a625324p-2},
                  {{{0, 0, 1}, {0x1.6900d9830912p+18, -0x1.8025e5e26a6e6p-1, 0x1.3d9fc568f5c92p-1}}}});
    for (const double radius : {0x1.f2afe8a33a518p-1, 0x1.f2afdfd9f8509p-1}) {
        look_at_edge({{0x1.7274e7def6e12p+17, -0x1.5c9332a451af8p+1, -0x1.71b6c434cd57fp+1},
                      {radius < 0x1.f2afe4p-1 ? 0x1.e8c95d19111a9p-1 : 0x1.e8c95d19111afp-1, 0x1.07a1a76173769p-1,
                       0x1.c3e0e4535a9ep-2},
                      radius},
                     {{0x1.5194eb10a1442p-1, 0x1.1b666add7284p-2, -0x1.c6db10d3355fcp-1},
                      {{{0, 0, 1}, {0x1.09f863681530ep+19, -0x1.0a406d610156cp-1, -0x1.d1ec00f9b0ef4p-2}}}});
    }
    CHECK(s.contacts >= 3);
    CHECK(s.wrong == 0);
}

TEST_CASE("constant expressions give the same bits, by integers alone") {
    static constexpr graze::wall<3> w{{5, -3, -3}, {{{{0, 6, 0}}, {{0, 0, 6}}}}};
    static constexpr graze::ball<3> balls[] = {{{0, 0.3, 0.7}, {1, 0.1, -0.2}, 0.9},  // the face
                                               {{0, 3.4, 0.7}, {1, 0.01, -0.2}, 0.9}, // an edge
                                               {{0, 3.4, 3.3}, {1, 0, 0}, 0.9},       // a corner
                                               {{4.5, 3.2, 0.1}, {1, 0.3, 0}, 0.9}};  // inside an edge
    static constexpr graze::wall_contact<3> constant[] = {*graze::collide(balls[0], w), *graze::collide(balls[1], w),
                                                          *graze::collide(balls[2], w), *graze::collide(balls[3], w)};
    int by_doubles = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        CAPTURE(k);
        const auto found =
            graze::collide(balls[k], w, [&](graze::stage s) { by_doubles += s != graze::stage::exact ? 1 : 0; });
        REQUIRE(found.has_value());
        CHECK(found->feature == constant[k].feature);
        const auto x = listed(*found), y = listed(constant[k]);
        for (std::size_t i = 0; i < x.size(); ++i) {
            CHECK(graze::detail::bits_of(x[i]) == graze::detail::bits_of(y[i]));
        }
    }
    CHECK((by_doubles >= 1 || !graze::detail::has_error_free_doubles));
}
