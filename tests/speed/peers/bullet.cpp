// Bullet's continuous convex collision.
#include "contestant.hpp"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <LinearMath/btTransform.h>

#include <cmath>

namespace peers {

namespace {

// Bullet gets lengths multiplied by a power of two.
class bullet_contestant final : public contestant {
  public:
    bullet_contestant(const trial& t, double unit) {
        for (const question& q : t.questions) {
            motion m;
            m.horizon = q.horizon;
            const auto vector = [&](const question::vector& x, double factor) {
                return btVector3(x[0] * factor, x[1] * factor, x[2] * factor);
            };
            m.from.setIdentity();
            m.stands.setIdentity();
            m.from.setOrigin(vector(q.from, unit));
            m.to = m.from;
            m.to.setOrigin(m.from.getOrigin() + vector(q.velocity, q.horizon * unit));
            double radius = q.radius * unit;
            switch (q.what) {
            case thing::ball:
                m.target = std::make_unique<btSphereShape>(q.other * unit);
                break;
            case thing::box: { // in the plane: so thick that only its sides are met
                const double thickness = q.half[2] == 0 ? 4 * q.radius : q.half[2];
                m.target = std::make_unique<btBoxShape>(vector({q.half[0], q.half[1], thickness}, unit));
                m.target->setMargin(0);
                break;
            }
            case thing::edge: { // as a capsule, which gets half of the radius, exactly
                radius /= 2;
                const btVector3 half = vector(q.half, unit);
                m.target = std::make_unique<btCapsuleShapeX>(radius, 2 * half.length());
                m.stands.setRotation(shortestArcQuat(btVector3(1, 0, 0), half.normalized()));
                break;
            }
            }
            m.ball = std::make_unique<btSphereShape>(radius);
            motions_.push_back(std::move(m));
        }
    }

    [[nodiscard]] std::optional<double> answer(std::size_t i) const override {
        const motion& m = motions_[i];
        btVoronoiSimplexSolver simplex;
        btGjkEpaPenetrationDepthSolver depth;
        btContinuousConvexCollision cast(m.ball.get(), m.target.get(), &simplex, &depth);
        btConvexCast::CastResult result;
        if (!cast.calcTimeOfImpact(m.from, m.to, m.stands, m.stands, result)) {
            return std::nullopt;
        }
        return result.m_fraction * m.horizon;
    }

  private:
    struct motion {
        std::unique_ptr<btConvexShape> ball, target;
        btTransform from, to, stands;
        double horizon = 1;
    };
    std::vector<motion> motions_;
};

std::string version() {
    return "Bullet " + std::to_string(btGetVersion() / 100) + "." + std::to_string(btGetVersion() % 100);
}

constexpr const char* settings = "btContinuousConvexCollision in double, GJK with a Voronoi simplex and EPA, 64 "
                                 "iterations, margin 0 for boxes; edges as capsules; ";
constexpr const char* promise = "a time of impact for games: shapes are advanced by their distance until it is below "
                                "0.001 units of length";

template <int Exponent>
std::unique_ptr<contestant> prepare(const trial& t) {
    return std::make_unique<bullet_contestant>(t, std::ldexp(1.0, Exponent));
}

} // namespace

std::vector<entry> bullet_entries() {
    std::vector<entry> all;
    all.push_back({"Bullet", version(), std::string(settings) + "lengths as they are (about a metre, as it recommends)",
                   promise, prepare<0>, 53, true, true});
    all.push_back({"Bullet, scaled", version(),
                   std::string(settings) + "lengths times 2^20, which makes its 0.001 small", promise, prepare<20>, 53,
                   true, true});
    return all;
}

} // namespace peers
