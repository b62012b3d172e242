// An interval type needs no other bound: its result contains the exact value, or it says that it does not know.
#include "inexact.hpp"

#include <graze/number/adapter/cgal.hpp>

using interval = CGAL::Interval_nt<>;

namespace {

struct interval_counts {
    long pairs = 0, open = 0, wrong = 0, values = 0, outside = 0;

    void compare(const interval& x, const oracle::surd& truth) {
        ++values;
        outside += oracle::compare(truth, mpq_class(x.inf())) < 0 || oracle::compare(truth, mpq_class(x.sup())) > 0;
    }
    template <int N>
    void compare(const graze::vec<N, interval>& x, const oracle::surd_vector<N>& truth) {
        for (int i = 0; i < N; ++i) {
            compare(x[i], truth[i]);
        }
    }
};

template <int N, graze::variant V, graze::root_form F>
void try_balls(const inexact::ball_pair<N>& p, interval_counts& count) {
    const oracle::answer met = oracle::meet(p.a, p.b);
    ++count.pairs;
    try {
        const auto s = graze::solve<V, F>(inexact::in<interval>(p.a), inexact::in<interval>(p.b));
        if (static_cast<int>(s.what) != static_cast<int>(met.what)) {
            ++count.wrong;
        } else if (graze::is_collision(s.what)) {
            const auto c = oracle::contact(p.a, p.b, 1 / mpq_class(p.a.mass), 1 / mpq_class(p.b.mass), met);
            count.compare(s.time, c.time);
            count.compare(s.position_a, c.position_a);
            count.compare(s.normal, c.normal);
            count.compare(s.velocity_a, c.velocity_a);
            count.compare(s.velocity_b, c.velocity_b);
        }
    } catch (const CGAL::Uncertain_conversion_exception&) {
        ++count.open;
    }
}

template <int N>
void try_wall(const graze::ball<N, double>& ball, const graze::wall<N, double>& wall, interval_counts& count) {
    const oracle::answer met = oracle::meet(ball, wall);
    ++count.pairs;
    try {
        const auto s = graze::solve(inexact::in<interval>(ball), inexact::in<interval>(wall));
        const auto where = static_cast<oracle::feature>(s.where);
        if (static_cast<int>(s.what) != static_cast<int>(met.what) ||
            (s.what != graze::encounter::miss && !met.has(where, s.index))) {
            ++count.wrong;
        } else if (graze::is_collision(s.what)) {
            const auto c = oracle::contact(ball, wall, met, where, s.index);
            count.compare(s.time, c.time);
            count.compare(s.point, c.point);
            count.compare(s.normal, c.normal);
            count.compare(s.velocity, c.velocity);
        }
    } catch (const CGAL::Uncertain_conversion_exception&) {
        ++count.open;
    }
}

template <int N>
void check_dimension() {
    using enum graze::variant;
    using graze::root_form;
    interval_counts count;
    inexact::draws d(20230607);
    for (int i = 0; i < 500; ++i) {
        const auto p = inexact::draw_balls<N>(d);
        try_balls<N, lagrange, root_form::stable>(p, count);
        try_balls<N, textbook, root_form::printed>(p, count);
        const graze::ball<N, double> ball{d.point<N>(4), d.point<N>(2), d.radius(), d.mass()};
        graze::wall<N, double> wall{d.point<N>(2), {}};
        for (auto& e : wall.edge) {
            e = d.point<N>(3);
        }
        try_wall<N>(ball, wall, count);
    }
    CHECK(count.wrong == 0);
    CHECK(count.outside == 0);
    CHECK(count.values > 1000);
    CHECK(count.open > 0); // exact grazes
    CHECK(count.open * 3 <= count.pairs);
}

} // namespace

TEST_CASE("graze::solve in CGAL::Interval_nt encloses the exact values") {
    check_dimension<2>();
    check_dimension<3>();
}
