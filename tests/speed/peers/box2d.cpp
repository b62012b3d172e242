// Box2D's time of impact.
#include "contestant.hpp"

#include <box2d/b2_circle_shape.h>
#include <box2d/b2_common.h>
#include <box2d/b2_edge_shape.h>
#include <box2d/b2_polygon_shape.h>
#include <box2d/b2_time_of_impact.h>

#include <cmath>

namespace peers {

namespace {

// Lengths are multiplied by a power of two and rounded to float, since Box2D computes in float.
class box2d_contestant final : public contestant {
  public:
    box2d_contestant(const trial& t, double unit) {
        for (const question& q : t.questions) {
            motion m;
            m.horizon = q.horizon;
            const auto number = [&](double x) { return static_cast<float>(x * unit); };
            const auto vector = [&](const question::vector& x) { return b2Vec2(number(x[0]), number(x[1])); };
            b2CircleShape ball;
            ball.m_radius = number(q.radius);
            m.ball = ball;
            switch (q.what) {
            case thing::ball:
                m.other.m_radius = number(q.other);
                break;
            case thing::box:
                m.box.SetAsBox(number(q.half[0]), number(q.half[1]));
                break;
            case thing::edge:
                m.edge.SetTwoSided(-vector(q.half), vector(q.half));
                break;
            }
            m.what = q.what;
            m.sweep.localCenter.SetZero();
            m.sweep.c0 = vector(q.from);
            m.sweep.c = vector({q.from[0] + q.velocity[0] * q.horizon, q.from[1] + q.velocity[1] * q.horizon, 0});
            m.sweep.a0 = m.sweep.a = m.sweep.alpha0 = 0;
            motions_.push_back(m);
        }
    }

    [[nodiscard]] std::optional<double> answer(std::size_t i) const override {
        const motion& m = motions_[i];
        b2TOIInput input;
        input.proxyA.Set(m.target(), 0);
        input.proxyB.Set(&m.ball, 0);
        input.sweepA.localCenter.SetZero();
        input.sweepA.c0.SetZero();
        input.sweepA.c.SetZero();
        input.sweepA.a0 = input.sweepA.a = input.sweepA.alpha0 = 0;
        input.sweepB = m.sweep;
        input.tMax = 1;
        b2TOIOutput output;
        b2TimeOfImpact(&output, &input);
        if (output.state != b2TOIOutput::e_touching) { // b2World interprets it in the same way
            return std::nullopt;
        }
        return static_cast<double>(output.t) * m.horizon;
    }

  private:
    struct motion {
        thing what = thing::ball;
        b2CircleShape ball, other;
        b2PolygonShape box;
        b2EdgeShape edge;
        b2Sweep sweep;
        double horizon = 1;

        [[nodiscard]] const b2Shape* target() const {
            return what == thing::ball  ? static_cast<const b2Shape*>(&other)
                   : what == thing::box ? static_cast<const b2Shape*>(&box)
                                        : static_cast<const b2Shape*>(&edge);
        }
    };
    std::vector<motion> motions_;
};

std::string version() {
    return "Box2D " + std::to_string(b2_version.major) + "." + std::to_string(b2_version.minor) + "." +
           std::to_string(b2_version.revision);
}

constexpr const char* settings = "b2TimeOfImpact, in float, whose tolerances are fixed (linear slop 0.005 m); a hit is "
                                 "e_touching, as in b2World; ";
constexpr const char* promise =
    "an upper bound on the time before two shapes penetrate by more than its slop of 0.015 m; "
    "it may miss some intermediate, non-tunnelling collisions";

template <int Exponent>
std::unique_ptr<contestant> prepare(const trial& t) {
    return std::make_unique<box2d_contestant>(t, std::ldexp(1.0, Exponent));
}

} // namespace

std::vector<entry> box2d_entries() {
    std::vector<entry> all;
    all.push_back({"Box2D", version(), std::string(settings) + "lengths as they are, 0.1 to 10 m, as it recommends",
                   promise, prepare<0>, 24, false, true});
    all.push_back({"Box2D, scaled", version(), std::string(settings) + "lengths times 2^10, which makes its slop small",
                   promise, prepare<10>, 24, false, true});
    return all;
}

} // namespace peers
