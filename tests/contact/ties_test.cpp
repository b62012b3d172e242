// Components exactly in the middle between two numbers, each constructed in a different way, in doubles and floats. The
// oracle confirms that they are ties, and to which side they round.
#include "answers.hpp"
#include "judge.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <string>
#include <vector>

namespace contact_ties_test {

namespace {

template <class T>
constexpr T infinity = std::numeric_limits<T>::infinity();

// Half of the last place of x > 0. x plus it is a tie.
template <class T>
T half(T x) {
    return (std::nextafter(x, infinity<T>) - x) / 2;
}
template <class T>
T last(T x) {
    return 2 * half(x);
}

template <class T>
struct fixture {
    using v2 = graze::vec<2, T>;
    using ball2 = graze::ball<2, T>;
    using ball3 = graze::ball<3, T>;
    using plane2 = graze::plane<2, T>;
    using wall2 = graze::wall<2, T>;
    using wall3 = graze::wall<3, T>;

    static constexpr T least = std::numeric_limits<T>::denorm_min();
    static constexpr T most = std::numeric_limits<T>::max();
    T u = last(T(1)), h = half(T(1));

    std::string name;
    int ways = 0;

    // x is y correctly rounded, and y is a tie.
    template <class X, class Y>
    void tie(const X& x, const Y& y) {
        const auto found = answers::of(x, y);
        const judge::verdict v = judge::of(x, y, found.contact, found.time);
        ++ways;
        CAPTURE(name);
        CAPTURE(ways);
        CHECK(v.wrong == "");
        CHECK(v.tied.find(name) != std::string::npos);
    }
};

template <class T>
void times() {
    fixture<T> f;
    f.name = "time";
    using F = fixture<T>;
    using ball2 = typename F::ball2;
    using ball3 = typename F::ball3;
    const T u = f.u, h = f.h, least = F::least;
    const ball2 origin{{0, 0}, {0, 0}, 0};
    f.tie(ball2{{1 + u, 0}, {-1, 0}, h}, origin);                          // 1 + h
    f.tie(ball2{{1 + 2 * u, 0}, {-1, 0}, h}, origin);                      // 1 + 3h, which rounds to the other side
    f.tie(ball2{{1 + u, 0}, {0, 0}, h / 2}, ball2{{0, 0}, {1, 0}, h / 2}); // radii on both balls; b moves
    f.tie(ball2{{3 + 2 * u, 0}, {-3, 0}, h}, origin);                      // divided by 3
    f.tie(ball2{{3 + 6 * u, 4 + 8 * u}, {-3, -4}, 5 * h}, origin);         // along (3, 4)
    f.tie(ball2{{5, 3}, {-1, 0}, 5}, ball2{{-h, 0}, {0, 0}, 0});           // beside the line of centres
    f.tie(ball3{{2 + 8 * u, 3 + 12 * u, 6 + 24 * u}, {-2, -3, -6}, 7 * h}, ball3{{0, 0, 0}, {0, 0, 0}, 0});
    f.tie(ball2{{1, 2}, {-1, 0}, 2}, ball2{{-h, 0}, {0, 0}, 0});                                            // a graze
    f.tie(ball2{{1 + u, 7}, {-1, 0}, h}, typename F::plane2{{0, 0}, {3, 0}});                               // a plane
    f.tie(ball2{{5, 0}, {-1, 0}, 5}, typename F::wall2{{-h, -3}, {{{{0, -9}}}}});                           // a corner
    f.tie(ball3{{5, 0, 1}, {-1, 0, 0}, 5}, typename F::wall3{{-h, -3, 0}, {{{{0, -9, 0}}, {{0, 0, 9}}}}});  // an edge
    f.tie(ball3{{1 + u, 1, 1}, {-1, 0, 0}, h}, typename F::wall3{{0, 0, 0}, {{{{0, 3, 0}}, {{0, 1, 3}}}}}); // a face
    f.tie(ball2{{4 * least, 0}, {-2, 0}, least}, origin); // 3/2 of the smallest number
    f.tie(ball2{{std::ldexp(T(1), 100), 0},
                {-std::ldexp(T(1), 100 - std::numeric_limits<T>::max_exponent), 0},
                std::ldexp(h, 99)},
          origin); // the middle beyond the largest number
    CHECK(f.ways >= 10);
}

template <class T>
void positions() {
    fixture<T> f;
    f.name = "position_a";
    using F = fixture<T>;
    using ball2 = typename F::ball2;
    using ball3 = typename F::ball3;
    const T u = f.u, h = f.h, least = F::least;
    // Along x the balls meet at t = distance - 2. Along y both fly alike.
    const auto meet = [&](T distance, T y, T speed) {
        f.tie(ball2{{distance, y}, {-1, speed}, 1}, ball2{{0, y}, {0, speed}, 1});
    };
    meet(3, 1, h);
    meet(3, 1 + u, h);
    meet(3, 1, -h / 2);
    meet(5, 1, h);
    meet(T(2.5), 1, u);
    meet(T(2.5), 0, least);
    meet(T(2.5), 0, -3 * least);
    meet(3, F::most, (F::most - std::nextafter(F::most, T(0))) / 2);    // the middle beyond the largest number
    f.tie(ball2{{3, 2}, {-1, u}, 1}, ball2{{0, 0}, {0, u}, 1});         // a graze, at 2 + 3u
    f.tie(ball2{{2 + u, 0}, {-1, 0}, 1 + u}, ball2{{0, 0}, {1, 0}, 0}); // from their own approach: 3/2 + u
    f.tie(ball3{{3, 0, 1}, {-1, 0, h}, 1}, ball3{{0, 0, 1}, {0, 0, h}, 1});
    f.name = "position";
    f.tie(ball2{{3, 1}, {-1, h}, 2}, typename F::plane2{{0, 0}, {5, 0}});
    f.tie(ball2{{5, 0}, {-1, 0}, 5}, typename F::wall2{{-u, -3}, {{{{0, -9}}}}});
    f.tie(ball3{{3, 1, 1}, {-1, 0, h}, 2}, typename F::wall3{{0, 0, 0}, {{{{0, 3, 0}}, {{0, 1, 3}}}}});
    f.tie(ball3{{5, 0, 1}, {-1, 0, h}, 5}, typename F::wall3{{0, -3, 0}, {{{{0, -9, 0}}, {{0, 0, 9}}}}});
    f.name = "point"; // the touched point on a face and on an edge
    f.tie(ball3{{3, 1, 1}, {-1, 0, h}, 2}, typename F::wall3{{0, 0, 0}, {{{{0, 3, 0}}, {{0, 1, 3}}}}});
    f.tie(ball3{{5, 0, 1}, {-1, 0, h}, 5}, typename F::wall3{{0, -3, 0}, {{{{0, -9, 0}}, {{0, 0, 9}}}}});
    CHECK(f.ways >= 10);
}

// A normal's component across the direction of flight is a quotient of lengths; the others are irrational.
template <class T>
void normals() {
    fixture<T> f;
    f.name = "normal";
    using F = fixture<T>;
    using ball2 = typename F::ball2;
    using ball3 = typename F::ball3;
    const T least = F::least, q = half(T(0.5));
    // Across x, the centres are y and y + below apart.
    const auto pass = [&](T y, T below, T radius, T other = 0) {
        f.tie(ball2{{9, y}, {-1, 0}, radius}, ball2{{0, -below}, {0, 0}, other});
    };
    pass(T(0.5), q, 1);
    pass(T(0.5) + 2 * q, q, 1);
    pass(T(1.5), 3 * q, 3);
    pass(T(2.5), 5 * q, 4, 1);
    pass(T(3.5), 7 * q, T(6.5), T(0.5));
    pass(-T(0.5), -q, 1);
    pass(T(0x1p-10), half(T(0x1p-10)), 1);
    pass(3 * least, 0, 2);
    f.tie(ball2{{T(0.5), 9}, {0, -2}, 1}, ball2{{-q, 0}, {0, 1}, 0});
    f.tie(ball3{{9, 9, T(0.5)}, {-1, -1, 0}, 1}, ball3{{0, 0, -q}, {0, 0, 0}, 0});
    f.tie(ball2{{9, T(0.5)}, {-1, 0}, 1}, typename F::wall2{{0, -q}, {{{{0, -9}}}}});
    f.tie(ball3{{9, T(0.5), 0}, {-1, 0, T(0.25)}, 1}, typename F::wall3{{0, -q, -9}, {{{{0, -9, 0}}, {{0, 0, 99}}}}});
    f.tie(ball3{{9, T(0.5), T(0.25)}, {-1, 0, 0}, 1}, typename F::wall3{{0, -q, 0}, {{{{0, -9, 0}}, {{0, 0, -9}}}}});
    CHECK(f.ways >= 10);
}

template <class T>
void velocities() {
    fixture<T> f;
    f.name = "velocity_b";
    using F = fixture<T>;
    using ball2 = typename F::ball2;
    using ball3 = typename F::ball3;
    const T u = f.u, h = f.h, least = F::least;
    // Head-on: b leaves with v + 2 m_a (w - v)/(m_a + m_b).
    const auto head_on = [&](T w, T v, T mass_a, T mass_b) {
        f.tie(ball2{{0, 0}, {w, 0}, 1, mass_a}, ball2{{9, 0}, {v, 0}, 1, mass_b});
    };
    head_on(1 + u, 1, 1, 3);
    head_on(1 + 2 * u, 1 + u, 1, 3);
    head_on(1 + 2 * u, 1, 1, 7);
    head_on(T(1.5), 1, 1, 2 / u - 1);
    head_on(least, 0, 1, 3);
    head_on(3 * least, 0, 1, 3);
    f.tie(ball3{{0, 0, 9}, {5, 7, -1 - u}, 1, 3}, ball3{{0, 0, 0}, {5, 7, -1}, 1, 9}); // along z
    f.name = "velocity_a";
    f.tie(ball2{{0, 0}, {1, 0}, 1, 1}, ball2{{9, 0}, {-h / 2, 0}, 1, infinity<T>}); // off a ball of infinite mass
    // With the normal (3, 4)/5: in flight, overlapping, touching.
    const T y = half(T(12));
    f.tie(ball2{{10, 4}, {-25, y}, 5}, ball2{{0, 0}, {0, y}, 0});
    f.tie(ball2{{3, 4}, {-25, y}, 10}, ball2{{0, 0}, {0, y}, 0});
    f.tie(ball2{{3, 4}, {-25, y}, 5}, ball2{{0, 0}, {0, y}, 0});
    f.name = "velocity";
    const T slow = -5 * half(T(4));
    f.tie(ball2{{-9, 0}, {5, slow}, 1}, typename F::plane2{{0, 0}, {1, 3}});
    f.tie(ball3{{-9, 0, 1}, {5, slow, 0}, 1}, typename F::wall3{{30, -10, -9}, {{{{-60, 20, 0}}, {{0, 0, 90}}}}});
    const T slower = -25 * half(T(24));
    f.tie(ball2{{3, 4}, {-25, slower}, 5}, typename F::wall2{{0, 0}, {{{{-9, 0}}}}});
    f.tie(ball3{{3, 4, 0}, {-25, slower, 0}, 5}, typename F::wall3{{0, 0, -9}, {{{{-9, 0, 0}}, {{0, 0, 99}}}}});
    CHECK(f.ways >= 10);
}

} // namespace

TEST_CASE_TEMPLATE("ties go to the even number", T, double, float) {
    SUBCASE("times") { times<T>(); }
    SUBCASE("positions") { positions<T>(); }
    SUBCASE("normals") { normals<T>(); }
    SUBCASE("velocities") { velocities<T>(); }
}

} // namespace contact_ties_test
