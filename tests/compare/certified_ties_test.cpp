// Simultaneous events in certified runs, compared with a simulator in 120 digits, to which times are equal if 60 digits
// agree.
#include "run/certified_run.hpp"
#include "scene_reader.hpp"

#include <boost/multiprecision/mpfr.hpp>
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <string>
#include <variant>
#include <vector>

namespace certified_ties_test {

using namespace compare;
using namespace compare::run;

namespace {

using real =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<120>, boost::multiprecision::et_off>;
const real nothing("1e-60");

exact_scene<2> scene_of(const std::string& name) {
    return std::get<exact_scene<2>>(read_scene(GRAZE_TEST_SCENES "/" + name + ".json", number_input::exactly).scene);
}

struct happening {
    graze::scene_pair who;
    real time;
};

// Brute force: it looks at all pairs and advances from event to event. Planes are across an axis.
class simulator {
  public:
    explicit simulator(const exact_scene<2>& scene) : order_(scene.balls.size()), rank_(scene.balls.size()) {
        for (const auto& b : scene.balls) {
            balls_.push_back({in(b.shape.position), in(b.shape.velocity), real(b.shape.radius), real(b.shape.mass)});
        }
        for (const auto& p : scene.planes) {
            planes_.push_back({in(p.point), in(p.normal)});
        }
        std::iota(order_.begin(), order_.end(), 0);
        std::sort(order_.begin(), order_.end(),
                  [&](std::size_t i, std::size_t j) { return balls_[i].x < balls_[j].x; });
        for (std::size_t i = 0; i < order_.size(); ++i) {
            rank_[order_[i]] = i;
        }
    }
    std::vector<happening> run(std::size_t events) {
        std::vector<happening> all;
        while (all.size() < events) {
            real first = -1;
            std::pair<std::size_t, std::size_t> who;
            const auto offer = [&](const real& t, std::size_t a, std::size_t b) {
                if (t >= 0 && (first < 0 || t < first - nothing)) {
                    first = t;
                    who = {a, b};
                }
            };
            for (const std::size_t a : order_) { // of simultaneous events, the first in this order
                for (const std::size_t b : order_) {
                    if (rank_[a] < rank_[b]) {
                        offer(time(balls_[a], balls_[b]), a, b);
                    }
                }
                for (std::size_t p = 0; p < planes_.size(); ++p) {
                    offer(time(balls_[a], planes_[p]), a, balls_.size() + p);
                }
            }
            if (first < 0) {
                break;
            }
            now_ += first;
            for (ball& b : balls_) {
                b.x = {b.x[0] + first * b.u[0], b.x[1] + first * b.u[1]};
            }
            const bool two = who.second < balls_.size();
            two ? part(balls_[who.first], balls_[who.second])
                : part(balls_[who.first], planes_[who.second - balls_.size()]);
            all.push_back({{two ? graze::partner::ball : graze::partner::plane, static_cast<int>(who.first),
                            static_cast<int>(two ? who.second : who.second - balls_.size())},
                           now_});
        }
        return all;
    }

  private:
    using place = std::array<real, 2>;
    struct ball {
        place x, u;
        real r, m;
    };
    struct plane {
        place x, n;
    };
    std::vector<ball> balls_;
    std::vector<plane> planes_;
    std::vector<std::size_t> order_, rank_;
    real now_ = 0;

    static place in(const graze::vec<2, exact>& x) { return {real(x[0]), real(x[1])}; }
    static real dot(const place& x, const place& y) { return x[0] * y[0] + x[1] * y[1]; }
    static place minus(const place& x, const place& y) { return {x[0] - y[0], x[1] - y[1]}; }

    static real time(const ball& a, const ball& b) {
        const place d = minus(a.x, b.x), v = minus(a.u, b.u);
        const real h = dot(d, v), c = dot(d, d) - (a.r + b.r) * (a.r + b.r), root = h * h - dot(v, v) * c;
        return h > -nothing || root < 0 ? real(-1) : c < nothing ? real(0) : real(c / (sqrt(root) - h));
    }
    static real time(const ball& a, const plane& p) {
        const real length = sqrt(dot(p.n, p.n)), height = dot(minus(a.x, p.x), p.n) / length,
                   speed = dot(a.u, p.n) / length, gap = abs(height) - a.r;
        return height * speed > -nothing ? real(-1) : gap < nothing ? real(0) : real(gap / abs(speed));
    }
    static void part(ball& a, ball& b) {
        const place d = minus(a.x, b.x);
        const real j = 2 * a.m * b.m / (a.m + b.m) * dot(minus(a.u, b.u), d) / dot(d, d);
        a.u = {a.u[0] - j / a.m * d[0], a.u[1] - j / a.m * d[1]};
        b.u = {b.u[0] + j / b.m * d[0], b.u[1] + j / b.m * d[1]};
    }
    static void part(ball& a, const plane& p) {
        const real j = 2 * dot(a.u, p.n) / dot(p.n, p.n);
        a.u = {a.u[0] - j * p.n[0], a.u[1] - j * p.n[1]};
    }
};

certified_result<2> proved(const exact_scene<2>& scene, std::uint64_t events, long most_bits = 4096) {
    return certified_run<2>(scene, {{}, events}, {15, most_bits}, progress_line(false));
}

// The events are the simulator's; simultaneous ones may be in any order.
void check_sequence(const certified_result<2>& found, std::vector<happening> expected) {
    REQUIRE(found.events.size() == expected.size());
    for (std::size_t from = 0; from < expected.size();) {
        std::size_t to = from;
        std::vector<graze::scene_pair> has, due;
        for (; to < expected.size() && expected[to].time - expected[from].time < nothing; ++to) {
            has.push_back(found.events[to].who);
            due.push_back(expected[to].who);
            CHECK(decimal_text(found.events[to].time, 12) == decimal_text(found.events[from].time, 12));
            CHECK(abs(real(near_double(found.events[to].time)) - expected[to].time) < 1e-12 * (1 + expected[to].time));
            CHECK((found.events[to].tied || found.events[to].either_order) == (to > from));
        }
        const auto order = [](graze::scene_pair& m) {
            if (m.with == graze::partner::ball && m.b < m.a) {
                std::swap(m.a, m.b);
            }
        };
        std::for_each(has.begin(), has.end(), order);
        std::for_each(due.begin(), due.end(), order);
        std::sort(has.begin(), has.end());
        std::sort(due.begin(), due.end());
        CHECK(has == due);
        from = to;
    }
}

bool is(const certified& x, const exact& value) { return (x - certified(value, 64)).certain_sign() == 0; }

constexpr graze::partner ball = graze::partner::ball;

} // namespace

TEST_CASE("a ball that hits two at once") {
    const exact_scene<2> scene = scene_of("two_at_once");
    const certified_result<2> found = proved(scene, 10);
    CHECK(found.problem.empty());
    CHECK(found.why == graze::ending::exhausted);
    check_sequence(found, simulator(scene).run(10));
    REQUIRE(found.events.size() == 2);
    CHECK(found.events[0].chosen);
    CHECK(found.events[1].tied);
    // n = (-√0.51, ±0.7): (1, 0) less 0.51, and then less twice 0.49·0.51.
    CHECK(is(found.balls[0].velocity[0], exact(-98, 10000)));
    CHECK(is(found.balls[0].velocity[1] * found.balls[0].velocity[1],
             exact(51, 100) * exact(14, 1000) * exact(14, 1000)));
}

TEST_CASE("two copies of one experiment go on side by side") {
    const exact_scene<2> scene = scene_of("mirrored_copies");
    const certified_result<2> found = proved(scene, 24);
    CHECK(found.problem.empty());
    check_sequence(found, simulator(scene).run(24));
    CHECK(std::count_if(found.events.begin(), found.events.end(), [](const auto& e) { return e.either_order; }) > 3);
}

TEST_CASE("a cradle askew to the axes") {
    const exact_scene<2> scene = scene_of("diagonal_cradle");
    const certified_result<2> found = proved(scene, 30);
    CHECK(found.problem.empty());
    check_sequence(found, simulator(scene).run(30));
    CHECK(!found.events.back().time.is_rational());
    CHECK(found.events.back().time.is_exact());
}

TEST_CASE("symmetric breaks") {
    for (const std::string name : {"symmetric_break", "break_of_six"}) {
        INFO(name);
        const exact_scene<2> scene = scene_of(name);
        const certified_result<2> found = proved(scene, 40);
        CHECK(found.problem.empty());
        CHECK(found.why == graze::ending::exhausted);
        CHECK(found.events.size() >= 4);
        CHECK(std::any_of(found.events.begin(), found.events.end(), [](const auto& e) { return e.chosen; }));
        check_sequence(found, simulator(scene).run(40));
    }
}

TEST_CASE("where one ball meets two at once beyond a quadratic field, the run ends and names both events") {
    const certified_result<2> found = proved(scene_of("two_beyond"), 40, 512);
    REQUIRE(found.events.size() == 4);
    CHECK(found.events[3].tied); // roots over a quadratic field, which are compared by their quadratics
    CHECK(found.bits == 512);
    CHECK(found.problem.find("the order of two times is undecided") == 0);
    CHECK(found.problem.find("ball 2 and ball 6") != std::string::npos);
    CHECK(found.problem.find("ball 5 and ball 6") != std::string::npos);
    CHECK(found.problem.find("about t = ") != std::string::npos);
}

TEST_CASE("Galperin's billiard, a mass of a million") {
    const certified_result<2> found = proved(scene_of("galperin_1000000"), 10'000);
    CHECK(found.events.size() == 3141);
    CHECK(found.why == graze::ending::exhausted);
    CHECK(found.problem.empty());
    CHECK(found.attempts == 1); // if enclosures grew with every event, it would take more bits and more attempts
    for (std::size_t i = 0; i < found.events.size(); ++i) {
        CHECK(found.events[i].who.with == (i % 2 == 0 ? ball : graze::partner::plane));
    }
    // Velocities times the root of their mass are a point on a circle. Each pair of events turns it by 2 arctan 10^-3.
    const real angle = 3142 * atan(1 / real(1000));
    CHECK(near_double(found.balls[1].velocity[0]) == doctest::Approx(static_cast<double>(-cos(angle))).epsilon(1e-14));
    CHECK(near_double(found.balls[0].velocity[0]) ==
          doctest::Approx(static_cast<double>(-1000 * sin(angle))).epsilon(1e-14));
}

} // namespace certified_ties_test
