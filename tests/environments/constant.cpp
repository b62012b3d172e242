// Decisions in constant expressions. They must compile under every flag; there is nothing to run.
#include <graze/predicate/overlaps_of_shapes.hpp>
#include <graze/time/time_of_shapes.hpp>
#include <graze/time/time_of_walls.hpp>

#include <limits>

namespace {

using graze::ball;
using graze::classify;
using graze::encounter;
using graze::plane;
using graze::time_of_impact;
using graze::wall;

// The same small scenes in every type, with whole numbers.
template <class T>
constexpr ball<2, T> still{{0, 0}, {0, 0}, 1};
#ifndef REJECTED // how it is used

template <class T>
constexpr ball<2, T> past{{-4, 2}, {1, 0}, 1};
template <class T>
constexpr ball<3, T> falling{{1, 1, 5}, {0, 0, -2}, 1};
template <class T>
constexpr wall<3, T> square{{0, 0, 0}, {{{2, 0, 0}, {0, 2, 0}}}};
template <class T>
constexpr wall<3, T> edge_on{{2, 0, 0}, {{{2, 0, 0}, {0, 2, 0}}}};

template <class T>
constexpr bool decides() {
    static_assert(classify(past<T>, still<T>) == encounter::graze);
    static_assert(classify(ball<2, T>{{-4, 1}, {1, 0}, 1}, still<T>) == encounter::hit);
    static_assert(classify(ball<2, T>{{-4, 3}, {1, 0}, 1}, still<T>) == encounter::miss);
    static_assert(classify(ball<2, T>{{-1, 0}, {1, 0}, 1}, still<T>) == encounter::overlap);
    static_assert(classify(ball<2, T>{{-1, 0}, {-1, 0}, 1}, still<T>) == encounter::recede);
    static_assert(graze::overlaps(ball<2, T>{{-1, 0}, {-1, 0}, 1}, still<T>) && !graze::overlaps(past<T>, still<T>));
    static_assert(classify(falling<T>, plane<3, T>{{0, 0, 0}, {0, 0, 3}}) == encounter::hit);
    static_assert(classify(falling<T>, square<T>) == encounter::hit);
    static_assert(classify(falling<T>, edge_on<T>) == encounter::graze);
    static_assert(!graze::overlaps(falling<T>, square<T>));

    static_assert(*time_of_impact(past<T>, still<T>) == T(4));
    static_assert(*time_of_impact(past<T>, still<T>) > T(3) && *time_of_impact(past<T>, still<T>) < T(5));
    static_assert(*time_of_impact(falling<T>, square<T>) == T(2));
    static_assert(*time_of_impact(falling<T>, square<T>) ==
                  *time_of_impact(falling<T>, plane<3, T>{{0, 0, 0}, {0, 0, 3}}));
    static_assert(!time_of_impact(ball<2, T>{{-4, 3}, {1, 0}, 1}, still<T>));
    // √2, and √8/2 as computed in another way.
    static_assert(*time_of_impact(ball<2, T>{{-4, 1}, {1, 0}, 2}, still<T>) ==
                  *time_of_impact(ball<2, T>{{-8, 2}, {2, 0}, 4}, ball<2, T>{{0, 0}, {0, 0}, 2}));
    return true;
}
static_assert(decides<double>());
#if GRAZE_ENVIRONMENT_LEVEL > 0
static_assert(decides<float>() && decides<std::int32_t>() && decides<std::int64_t>());
#endif

// One unit in the last place apart, and rounded differences.
static_assert(classify(ball<2>{{-4, 0x1.0000000000001p1}, {1, 0}, 1}, still<double>) == encounter::miss);
static_assert(classify(ball<2>{{-4, 0x1.fffffffffffffp0}, {1, 0}, 1}, still<double>) == encounter::hit);
static_assert(*time_of_impact(ball<2>{{-4, 0}, {1, 0}, 1}, still<double>) <
              *time_of_impact(ball<2>{{-0x1.0000000000001p2, 0}, {1, 0}, 1}, still<double>));
// Subnormals and large numbers.
static_assert(classify(ball<2>{{-0x4p-1074, 0x2p-1074}, {0x1p-1074, 0}, 0x1p-1074},
                       ball<2>{{0, 0}, {0, 0}, 0x1p-1074}) == encounter::graze);
static_assert(classify(ball<2>{{-0x4p1000, 0x2p1000}, {0x1p1000, 0}, 0x1p1000}, ball<2>{{0, 0}, {0, 0}, 0x1p1000}) ==
              encounter::graze);

#else // what must not compile, and does where REPAIRED

#ifdef REPAIRED
constexpr bool bad = false;
#else
constexpr bool bad = true;
#endif
constexpr ball<2> a{{-4, 0}, {1, 0}, 1};
constexpr double nan = bad ? std::numeric_limits<double>::quiet_NaN() : 0.0;
constexpr double infinity = bad ? std::numeric_limits<double>::infinity() : 0.0;

constexpr encounter of_nan = classify(ball<2>{{-4, 0}, {1, nan}, 1}, still<double>);
constexpr encounter of_infinity = classify(ball<2>{{-4, 0}, {1, infinity}, 1}, still<double>);
constexpr encounter of_a_radius = classify(a, ball<2>{{0, 0}, {0, 0}, bad ? -1.0 : 1.0});
constexpr encounter of_a_normal = classify(a, plane<2>{{0, 0}, {0, bad ? 0.0 : 1.0}});
constexpr encounter of_an_edge = classify(a, wall<2>{{0, 0}, {{{0, bad ? 0.0 : 1.0}}}});
constexpr encounter of_edges =
    classify(ball<3>{{0, 0, 4}, {0, 0, -1}, 1}, wall<3>{{0, 0, 0}, {{{1, 2, 3}, {2, 4, bad ? 6.0 : 7.0}}}});

#endif

} // namespace
