// Pairs that outlines call apart do not meet: by the quadratic in rational numbers.
#include <graze/run/outlines.hpp>

#include <doctest/doctest.h>
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace {

using graze::flight;

// Whether the two are within the sum of their radii at some time from the later epoch to `until`. a flies `by` away
// from where its flight is.
template <int N>
bool is_met(const flight<N>& a, const std::array<mpq_class, 3>& by, const flight<N>& b, double until) {
    const mpq_class start = std::max(a.since, b.since), end(until);
    const mpq_class R = mpq_class(a.state.radius) + mpq_class(b.state.radius);
    if (end < start) {
        return false;
    }
    mpq_class uu = 0, xu = 0, xx = 0;
    for (int i = 0; i < N; ++i) {
        const mpq_class ua(a.state.velocity[i]), ub(b.state.velocity[i]);
        const mpq_class x = mpq_class(a.state.position[i]) + by[static_cast<std::size_t>(i)] + ua * (start - a.since) -
                            mpq_class(b.state.position[i]) - ub * (start - b.since);
        uu += (ua - ub) * (ua - ub);
        xu += x * (ua - ub);
        xx += x * x;
    }
    mpq_class nearest = uu > 0 ? mpq_class(-xu / uu) : mpq_class(0); // after the start
    nearest = std::min(std::max(nearest, mpq_class(0)), mpq_class(end - start));
    return (uu * nearest + 2 * xu) * nearest + xx <= R * R;
}

// Draws pairs, half of which touch or nearly graze, and times near those at which they do.
class pairs {
  public:
    explicit pairs(unsigned seed) : bits_(seed) {}
    double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(bits_); }
    int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(bits_); }

    template <int N>
    void draw(flight<N>& a, flight<N>& b, double& until) {
        const double length = std::ldexp(1, below(60) - 30), speed = std::ldexp(1, below(60) - 30);
        const double span = length / speed;
        for (flight<N>* f : {&a, &b}) {
            f->since = below(3) == 0 ? 0 : between(0, 4) * span;
            f->state.radius = between(0, 0.5) * length;
            const double slow = below(8) == 0 ? 0x1p-20 : 1;
            for (int i = 0; i < N; ++i) {
                f->state.position.component[i] = between(-2, 2) * length;
                f->state.velocity.component[i] = between(-1, 1) * speed * slow;
            }
        }
        until = between(-1, 8) * span;
        if (below(2) == 0) {
            return;
        }
        const double when = std::max(a.since, b.since) + between(0, 4) * span * std::ldexp(1, -below(56));
        std::array<double, 3> n{}, du{};
        double square = 0, along = 0;
        for (int i = 0; i < N; ++i) {
            const auto k = static_cast<std::size_t>(i);
            n[k] = between(-1, 1);
            du[k] = a.state.velocity[i] - b.state.velocity[i];
            square += du[k] * du[k];
            along += du[k] * n[k];
        }
        const double part = below(2) == 0 ? along / square : 0; // they graze
        double norm = 0;
        for (std::size_t k = 0; k < N; ++k) {
            n[k] -= part * du[k];
            norm += n[k] * n[k];
        }
        const double R = a.state.radius + b.state.radius;
        for (int i = 0; i < N; ++i) {
            b.state.position.component[i] = a.state.position[i] + a.state.velocity[i] * (when - a.since) -
                                            b.state.velocity[i] * (when - b.since) +
                                            n[static_cast<std::size_t>(i)] / std::sqrt(norm) * R;
        }
        until = when * (1 + std::ldexp(between(-1, 1), -below(54)));
    }

  private:
    std::mt19937_64 bits_;
};

struct tally {
    int apart = 0, met = 0;
};

// Some are seen by another image: `most` periods away, or fewer.
template <int N>
tally check(unsigned seed, int most) {
    pairs drawn(seed);
    tally sums;
    for (int i = 0; i < 20'000; ++i) {
        flight<N> a, b;
        double until = 0;
        drawn.draw(a, b, until);
        graze::vec<N, double> period{};
        graze::detail::whole_periods mine{}, others{}, between{};
        std::array<mpq_class, 3> by{};
        for (int k = 0; most > 0 && k < N; ++k) {
            const auto at = static_cast<std::size_t>(k);
            period.component[k] = drawn.between(0.5, 8) * (a.state.radius + b.state.radius);
            mine[at] = drawn.below(2 * most + 1) - most;
            between[at] = drawn.below(3) - 1;
            others[at] = mine[at] - between[at];
            if (drawn.below(4) == 0) {
                others[at] += drawn.below(3) - 1;
            }
            by[at] = mpq_class(mine[at] - between[at] - others[at]) * mpq_class(period[k]);
        }
        graze::detail::outlines<N> all(2, period);
        all.set(0, a, mine);
        all.set(1, b, others);
        auto look = all.from(all[0]);
        look.look_until(until);
        const bool apart = look.is_apart(all[1], most > 0 ? look.seen_from(all.length_of(graze::detail::coded(between)))
                                                          : look.here());
        const bool met = is_met(a, by, b, until);
        REQUIRE_FALSE((apart && met));
        sums.apart += apart ? 1 : 0;
        sums.met += met ? 1 : 0;
    }
    return sums;
}

} // namespace

TEST_CASE("balls that are called apart do not meet until then, and most that part are called apart") {
    for (const tally& t : {check<3>(61, 0), check<2>(62, 0)}) {
        CHECK(t.met > 3'000);
        CHECK(t.apart > 4'000);
    }
}

TEST_CASE("the same for images") {
    for (const tally& t : {check<3>(63, 3), check<2>(64, 300)}) {
        CHECK(t.met > 3'000);
        CHECK(t.apart > 3'000);
    }
}

TEST_CASE("a ball too far, too fast or too late for outlines is apart from none") {
    const double huge = std::numeric_limits<double>::max();
    const flight<2> one = {{{{0, 0}}, {{0, 0}}, 1, 1}, 0};
    for (const flight<2>& other :
         {flight<2>{{{{huge, 0}}, {{0, 0}}, 1, 1}, 0}, flight<2>{{{{9, 0}}, {{-huge, 0}}, 1, 1}, 0},
          flight<2>{{{{9, 0}}, {{0, 0}}, 1, 1}, huge}}) {
        graze::detail::outlines<2> all(2, {});
        all.set(0, one, {});
        all.set(1, other, {});
        auto look = all.from(all[0]);
        look.look_until(1);
        CHECK_FALSE(look.is_apart(all[1], look.here()));
        look = all.from(all[1]);
        look.look_until(1);
        CHECK_FALSE(look.is_apart(all[0], look.here()));
    }
}
