// All balls and walls on a small grid, so that no degenerate case depends on chance.
#include "exact.hpp"

#include <graze/number/adapter/gmp.hpp>

#include <functional>
#include <map>

namespace graze {
static mpq_class rational_in(const gmp_rational& x) { return x.value(); }
} // namespace graze

using number = graze::gmp_rational;

namespace {

// f(x) for every vector whose components are -limit ... limit.
template <int N, class F>
void for_each_point(int limit, F f) {
    for (int x = -limit; x <= limit; ++x) {
        for (int y = -limit; y <= limit; ++y) {
            if constexpr (N == 2) {
                f(graze::vec<2, int>{{x, y}});
            } else {
                for (int z = -limit; z <= limit; ++z) {
                    f(graze::vec<3, int>{{x, y, z}});
                }
            }
        }
    }
}

struct tally {
    std::map<std::string, long> found;
    long wrong = 0;

    template <class S>
    void add(const S& s, const oracle::answer& met, const std::string& where = "") {
        ++found[graze::to_string(s.what) + where];
        bool right = s.what == exact::as_library(met.what);
        if (right && graze::is_collision(s.what)) {
            right = exact::equal(s.time, *met.time);
        }
        wrong += right ? 0 : 1;
    }
    void add_wall(const auto& s, const oracle::answer& met) {
        add(s, met, s.what == graze::encounter::miss ? "" : std::string(" ") + graze::to_string(s.where));
        if (s.what != graze::encounter::miss) {
            const bool right = s.where == static_cast<graze::feature>(met.where()) && met.has(met.where(), s.index);
            wrong += right ? 0 : 1;
        }
    }
    void expect_all(std::initializer_list<const char*> kinds) {
        CHECK(wrong == 0);
        for (const char* kind : kinds) {
            CAPTURE(kind);
            CHECK(found[kind] > 0);
        }
    }
};

template <int N>
void all_balls(int places, int speeds, int radii) {
    tally t;
    const graze::vec<N, int> zero{};
    for_each_point<N>(places, [&](const graze::vec<N, int>& x) {
        for_each_point<N>(speeds, [&](const graze::vec<N, int>& u) {
            for (int r = 0; r <= radii; ++r) {
                const graze::ball<N, int> a{x, u, r}, b{zero, zero, 0};
                t.add(graze::solve(exact::in<number>(a), exact::in<number>(b)), oracle::meet(a, b));
            }
        });
    });
    t.expect_all({"overlap", "recede", "miss", "graze", "hit"});
}

template <int N>
void all_walls(const graze::wall<N, int>& wall, int places, int radii, tally& t) {
    for_each_point<N>(places, [&](const graze::vec<N, int>& x) {
        for_each_point<N>(1, [&](const graze::vec<N, int>& u) {
            for (int r = 0; r <= radii; ++r) {
                const graze::ball<N, int> ball{x, u, r};
                t.add_wall(graze::solve(exact::in<number>(ball), exact::in<number>(wall)), oracle::meet(ball, wall));
            }
        });
    });
}

} // namespace

TEST_CASE("every two balls on a grid in the plane") { all_balls<2>(4, 2, 4); }
TEST_CASE("every two balls on a grid in space") { all_balls<3>(2, 1, 3); }

TEST_CASE("every ball and segment on a grid") {
    tally t;
    const graze::vec<2, int> zero{};
    for_each_point<2>(2, [&](const graze::vec<2, int>& e) {
        if (!(e == zero)) {
            all_walls<2>({zero, {e}}, 3, 2, t);
        }
    });
    t.expect_all({"overlap face", "overlap corner", "recede face", "recede corner", "miss", "graze corner", "hit face",
                  "hit corner"});
}

TEST_CASE("every ball on a grid and a square, an oblong parallelogram and a slanted one") {
    const graze::wall<3, int> walls[] = {{{{0, 0, 0}}, {{{{2, 0, 0}}, {{0, 2, 0}}}}},
                                         {{{0, 0, 0}}, {{{{1, 0, 0}}, {{2, 1, 0}}}}},
                                         {{{-1, 0, 0}}, {{{{2, 1, 0}}, {{1, -1, 2}}}}}};
    for (const auto& wall : walls) {
        tally t;
        all_walls<3>(wall, 2, 2, t);
        t.expect_all({"overlap face", "overlap edge", "overlap corner", "recede face", "recede edge", "recede corner",
                      "miss", "graze edge", "graze corner", "hit face", "hit edge", "hit corner"});
    }
}
