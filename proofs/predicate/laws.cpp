// The laws of the decisions on hard cases: exact tangents, one unit in the last place away from them, borders of walls.
// tests/predicate/laws.hpp has the same numbers and tries the laws on random pairs of every hard family.
#include <graze/graze.hpp>

#include <utility>

namespace {

using namespace graze;

constexpr double ulp = 0x1p-52;

// Whether two pairs have the same answer: the encounter, whether they overlap at t = 0 and, for balls and planes, the
// exact time.
template <class A, class B>
constexpr bool same(const A& a, const B& b, const A& c, const B& d) {
    if (classify(a, b) != classify(c, d) || overlaps(a, b) != overlaps(c, d)) {
        return false;
    }
    if constexpr (requires { b.edge; }) {
        return true;
    } else {
        const auto x = time_of_impact(a, b);
        const auto y = time_of_impact(c, d);
        return x.has_value() == y.has_value() && (!x || *x == *y);
    }
}

// The hard cases: a ball that flies along (5, -12)/13 at a distance of 13, also with a radius one unit in the last
// place more or less; a wall's rim, touched by (3, 4, 5), and one unit away from that; an oblique plane. A law is a
// function that says whether it holds for a pair. Each case is a constant expression of its own, since compilers limit
// the steps of one.
constexpr ball<2> still{{0, 0}, {0, 0}, 6};
constexpr ball<2> passing(double radius) { return {{2, 29}, {5, -12}, radius}; }
static_assert(classify(passing(7), still) == encounter::graze);
static_assert(classify(passing(7 + 4 * ulp), still) == encounter::hit);
static_assert(classify(passing(7 - 4 * ulp), still) == encounter::miss);

constexpr wall<2> segment{{5, -3}, {{{{0, 6}}}}};
constexpr ball<2> thrown(double y) { return {{0, y}, {1, 0}, 4}; }
static_assert(classify(thrown(7), segment) == encounter::graze);
static_assert(classify(thrown(7 - 4 * ulp), segment) == encounter::hit);
static_assert(classify(thrown(7 + 4 * ulp), segment) == encounter::miss);

constexpr plane<3> askew{{5, 0, 0}, {-3, 1, 2}};
constexpr ball<3> at_plane{{0, 1, 2}, {1, 0.5, 0}, 2};
static_assert(classify(at_plane, askew) == encounter::hit);

template <class Law>
constexpr bool of_tangent = Law{}(passing(7), still);
template <class Law>
constexpr bool of_hit = Law{}(passing(7 + 4 * ulp), still);
template <class Law>
constexpr bool of_miss = Law{}(passing(7 - 4 * ulp), still);
template <class Law>
constexpr bool of_border = Law{}(thrown(7), segment);
template <class Law>
constexpr bool of_face = Law{}(thrown(1), segment);
template <class Law>
constexpr bool of_plane = Law{}(at_plane, askew);
template <class Law>
constexpr bool of_all = of_tangent<Law>&& of_hit<Law>&& of_miss<Law>&& of_border<Law>&& of_face<Law>&& of_plane<Law>;

template <int N>
constexpr vec<N, double> turned(const vec<N, double>& x) {
    return make_vec<N>([&](int i) { return x[(i + 1) % N]; });
}
template <int N>
constexpr vec<N, double> mirrored(vec<N, double> x) {
    x[0] = -x[0];
    return x;
}
// f of every vector.
template <int N, class F>
constexpr ball<N> each(const ball<N>& b, F f) {
    return {f(b.position), f(b.velocity), b.radius};
}
template <int N, class F>
constexpr plane<N> each(const plane<N>& p, F f) {
    return {f(p.point), f(p.normal)};
}
template <int N, class F>
constexpr wall<N> each(wall<N> w, F f) {
    w.corner = f(w.corner);
    for (auto& e : w.edge) {
        e = f(e);
    }
    return w;
}

// 1. The axes may be permuted and mirrored.
struct axes {
    template <class A, class B>
    constexpr bool operator()(const A& a, const B& b) const {
        const auto turn = [](const auto& x) { return turned(x); };
        const auto mirror = [](const auto& x) { return mirrored(x); };
        return same(a, b, each(a, turn), each(b, turn)) && same(a, b, each(a, mirror), each(b, mirror));
    }
};
static_assert(of_all<axes>);

// 2. The same things may be written differently: balls exchanged, a plane's normal reversed, a wall's edges exchanged
// or drawn from the other end.
struct presentation {
    constexpr bool operator()(const ball<2>& a, const ball<2>& b) const { return same(a, b, b, a); }
    constexpr bool operator()(const ball<3>& b, plane<3> p) const {
        const plane<3> given = p;
        p.normal = -p.normal;
        return same(b, given, b, p);
    }
    constexpr bool operator()(const ball<2>& b, wall<2> w) const {
        const wall<2> given = w;
        w.corner = w.corner + w.edge[0];
        w.edge[0] = -w.edge[0];
        return same(b, given, b, w);
    }
};
static_assert(of_all<presentation>);

// 3. Lengths, velocities and normals may be scaled by a power of two each: the encounter stays and times scale.
struct scaling {
    template <int N>
    static constexpr ball<N> longer(const ball<N>& b) {
        return {8.0 * b.position, 4.0 * b.velocity, 8.0 * b.radius};
    }
    static constexpr plane<3> longer(const plane<3>& p) { return {8.0 * p.point, 0.25 * p.normal}; }
    static constexpr wall<2> longer(const wall<2>& w) {
        return each(w, [](const auto& x) { return 8.0 * x; });
    }
    template <class A, class B>
    constexpr bool operator()(const A& a, const B& b) const {
        const auto x = time_of_impact(a, b);
        const auto y = time_of_impact(longer(a), longer(b));
        if (classify(a, b) != classify(longer(a), longer(b)) || x.has_value() != y.has_value()) {
            return false;
        }
        for (const double m : {2.0, 5.0}) {
            if (x && (*x <=> m) != (*y <=> 2 * m)) {
                return false;
            }
        }
        return true;
    }
};
static_assert(of_all<scaling>);

// 4. Both balls may fly faster by the same velocity, and everything may be elsewhere.
struct frame {
    template <class A, class B>
    constexpr bool operator()(const A& a, const B& b) const {
        auto c = a;
        auto d = b;
        c.position[1] = c.position[1] + 64;
        move(d, 64);
        if constexpr (std::is_same_v<A, B>) {
            c.velocity[0] = c.velocity[0] - 5;
            d.velocity[0] = d.velocity[0] - 5;
        }
        return same(a, b, c, d);
    }
    static constexpr void move(ball<2>& b, double by) { b.position[1] = b.position[1] + by; }
    static constexpr void move(plane<3>& p, double by) { p.point[1] = p.point[1] + by; }
    static constexpr void move(wall<2>& w, double by) { w.corner[1] = w.corner[1] + by; }
};
static_assert(of_all<frame>);

// 5. All times are in one order, for every kind of pair: exactly one of <, ==, > holds, exchanged operands exchange it,
// and < is transitive.
constexpr ball<2> runner{{0, 0}, {1, 0}, 1};
constexpr impact_time<2> three[] = {*time_of_impact(runner, ball<2>{{4, 0}, {0, 0}, 1 + ulp}),
                                    *time_of_impact(runner, plane<2>{{3, 0}, {1, 0}}),
                                    *time_of_impact(runner, ball<2>{{3.5, 1}, {0, 0}, 1})};
static_assert(*time_of_impact(runner, ball<2>{{4, 0}, {0, 0}, 1}) == three[1], "of a ball and of a plane");
static_assert(three[0] < three[1] && !(three[0] == three[1]) && !(three[0] > three[1]));
static_assert(three[1] > three[0] && !(three[1] < three[0]));
static_assert(three[2] < three[0] && three[2] < three[1], "transitive");
static_assert(three[2] == three[2] && !(three[2] < three[2]));
// Velocities do not matter: a ball that is eight times slower, at an eighth of the distance.
constexpr auto slow = *time_of_impact(ball<2>{{0, 0}, {0.125, 0}, 1}, ball<2>{{2.25, 0}, {0, 0}, 1});
constexpr auto fast = *time_of_impact(runner, ball<2>{{4, 0}, {0, 0}, 1});
static_assert(slow == fast && slow == three[1] && three[0] < slow && slow > three[2]);

// 6. Collisions have a time, other encounters have none. The time of an overlap is 0, that of a graze -h/a.
struct times_of_collisions {
    template <class A, class B>
    constexpr bool operator()(const A& a, const B& b) const {
        const encounter what = classify(a, b);
        const auto time = time_of_impact(a, b);
        return time.has_value() == is_collision(what) && (what != encounter::overlap || *time == 0.0);
    }
};
static_assert(of_all<times_of_collisions>);
static_assert(*time_of_impact(passing(7), still) == 2.0);

// 7. A plane is never missed and never grazed.
static_assert(classify(at_plane, askew) != encounter::miss && classify(at_plane, askew) != encounter::graze);
// A ball that moves parallel to the plane, and one unit in the last place to either side of that.
constexpr encounter along(double up) { return classify(ball<2>{{0, 3}, {1, up}, 1}, plane<2>{{0, 0}, {0, 1}}); }
static_assert(along(0) == encounter::recede && along(ulp) == encounter::recede && along(-ulp) == encounter::hit);
// A ball that cuts the plane and gets deeper overlaps it, from either side; a ball that only touches does not.
constexpr plane<2> ground{{0, 0}, {0, 1}};
constexpr ball<2> falling(double y, double u) { return {{0, y}, {1, u}, 1}; }
static_assert(classify(falling(1 - ulp, -1), ground) == encounter::overlap &&
              classify(falling(ulp - 1, 1), ground) == encounter::overlap);
static_assert(classify(falling(1, -1), ground) == encounter::hit && classify(falling(-1, 1), ground) == encounter::hit);
static_assert(classify(falling(0.5, 1), ground) == encounter::recede &&
              classify(falling(-0.5, -1), ground) == encounter::recede);
static_assert(times_of_collisions{}(falling(0.5, -1), ground) && times_of_collisions{}(falling(1, -1), ground));

// 8. A wall is met no earlier than its plane, where both are met: with its face at the same time, with its end later.
constexpr plane<2> of_segment{{5, -3}, {-6, 0}};
static_assert(*time_of_impact(thrown(3), segment) == *time_of_impact(thrown(3), of_segment));
static_assert(*time_of_impact(thrown(3 + 4 * ulp), segment) > *time_of_impact(thrown(3 + 4 * ulp), of_segment));
static_assert(*time_of_impact(thrown(7), segment) > *time_of_impact(thrown(7), of_segment));
static_assert(*time_of_impact(thrown(7), segment) == 5.0 && *time_of_impact(thrown(-7), segment) == 5.0, "either end");

// 9. A larger ball is met no later.
static_assert(*time_of_impact(passing(7 + 4 * ulp), still) < *time_of_impact(passing(7), still));
static_assert(*time_of_impact(passing(8), still) < *time_of_impact(passing(7 + 4 * ulp), still));
static_assert(*time_of_impact(passing(90), still) == 0.0, "inside: now");
static_assert(*time_of_impact(passing(90), still) == *time_of_impact(passing(80), still), "and no earlier");
constexpr auto touching = *time_of_impact(ball<2>{{13, 0}, {-1, 0}, 7}, still);
static_assert(*time_of_impact(passing(90), still) == touching && touching == *time_of_impact(passing(90), still));

// 10. classify says overlap if and only if the pair overlaps and does not recede.
struct overlap_now {
    template <class A, class B>
    constexpr bool operator()(const A& a, const B& b) const {
        const encounter what = classify(a, b);
        return (what == encounter::overlap) == (overlaps(a, b) && what != encounter::recede);
    }
};
static_assert(of_all<overlap_now>);
static_assert(overlap_now{}(passing(90), still) && overlaps(passing(90), still));
static_assert(overlap_now{}(still, passing(7)) && overlap_now{}(ball<2>{{1, 0}, {1, 0}, 1}, still), "parting inside");
static_assert(classify(still, passing(100)) == encounter::overlap &&
              classify(ball<2>{{1, 0}, {1, 0}, 1}, still) == encounter::recede);
static_assert(!overlaps(ball<2>{{13, 0}, {-1, 0}, 7}, still), "touching is not overlapping");
constexpr ball<2> vast{{0, 0}, {0x1p-300, 0}, 0x1p300}; // exponents far apart
static_assert(overlap_now{}(vast, ball<2>{{1, 0}, {0, 0}, 0x1p-300}) &&
              classify(vast, ball<2>{{1, 0}, {0, 0}, 0x1p-300}) == encounter::overlap);
static_assert(classify(vast, ball<2>{{-1, 0}, {0, 0}, 0x1p-300}) == encounter::recede &&
              classify(vast, ball<2>{{0x1p300, 0}, {0, 0}, 0x1p-300}) == encounter::overlap &&
              classify(vast, ball<2>{{0x1p300, 0}, {0, 0}, 0}) == encounter::hit);
static_assert(overlaps(ball<2>{{13, 0}, {-1, 0}, 7 + 4 * ulp}, still));
static_assert(overlap_now{}(falling(1 - ulp, -1), ground) && overlaps(falling(1 - ulp, -1), ground));
static_assert(overlap_now{}(falling(0.5, 1), ground) && overlaps(falling(0.5, 1), ground), "parting inside");
static_assert(overlap_now{}(falling(1, -1), ground) && !overlaps(falling(1, -1), ground));
constexpr ball<2> at_end(double y, double u) { return {{5, y}, {0, u}, 4}; }
static_assert(overlap_now{}(at_end(6.5, -1), segment) && overlaps(at_end(6.5, -1), segment));
static_assert(overlap_now{}(at_end(6.5, 1), segment) && overlaps(at_end(6.5, 1), segment), "parting inside");
static_assert(overlap_now{}(at_end(7, -1), segment) && !overlaps(at_end(7, -1), segment));

// 11. Numbers stand in the same order as times.
constexpr bool among_numbers(const impact_time<2>& t) {
    return t.lower() <= t && t <= t.upper() && (t == t.lower()) == (t.lower() == t.upper());
}
static_assert(among_numbers(three[0]) && among_numbers(three[1]) && among_numbers(three[2]));
constexpr auto irrational = *time_of_impact(passing(8), still);
static_assert(among_numbers(irrational) && irrational.lower() < irrational.upper() && irrational != irrational.lower());
static_assert(irrational < 2.0 && three[1] == 2.0 && irrational < three[1], "through a number");
static_assert(irrational > 0.0 && irrational > -1.0 && irrational < 4.0 && irrational < 0x1p40, "beyond both roots");
// The nearest number is lower() or upper(): one case for each.
constexpr auto other = *time_of_impact(passing(9), still);
static_assert(static_cast<double>(irrational) == irrational.upper() && static_cast<double>(other) == other.lower());
static_assert(among_numbers(other) && other.lower() < other.upper());
// For an overlap all three are 0.
constexpr auto at_once = *time_of_impact(passing(90), still);
static_assert(among_numbers(at_once) && at_once.upper() == 0 && static_cast<double>(at_once) == 0);

} // namespace
