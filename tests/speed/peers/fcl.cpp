// FCL's continuous collision.
#include "contestant.hpp"

#include <fcl/config.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/continuous_collision.h>

namespace peers {

namespace {

using geometry = std::shared_ptr<fcl::CollisionGeometryd>;

// The rotation that turns the z axis into the direction of x, which is in the plane.
fcl::Transform3d along(const question::vector& x) {
    fcl::Transform3d turn = fcl::Transform3d::Identity();
    turn.linear() =
        Eigen::Quaterniond::FromTwoVectors(fcl::Vector3d::UnitZ(), fcl::Vector3d(x[0], x[1], x[2])).toRotationMatrix();
    return turn;
}

class fcl_contestant final : public contestant {
  public:
    explicit fcl_contestant(const trial& t)
        : request_(1000, 1e-12, fcl::CCDM_TRANS, fcl::GST_LIBCCD, fcl::CCDC_CONSERVATIVE_ADVANCEMENT) {
        for (const question& q : t.questions) {
            motion m;
            m.horizon = q.horizon;
            m.from.translation() = fcl::Vector3d(q.from[0], q.from[1], q.from[2]);
            m.to = m.from;
            m.to.translation() += fcl::Vector3d(q.velocity[0], q.velocity[1], q.velocity[2]) * q.horizon;
            double radius = q.radius;
            switch (q.what) {
            case thing::ball:
                m.target = std::make_shared<fcl::Sphered>(q.other);
                break;
            case thing::box: // in the plane: so thick that only its sides are met
                m.target = std::make_shared<fcl::Boxd>(2 * q.half[0], 2 * q.half[1],
                                                       q.half[2] == 0 ? 8 * q.radius : 2 * q.half[2]);
                break;
            case thing::edge: { // as a capsule, which gets half of the radius, exactly
                const fcl::Vector3d half(q.half[0], q.half[1], q.half[2]);
                radius = q.radius / 2;
                m.target = std::make_shared<fcl::Capsuled>(radius, 2 * half.norm());
                m.stands = along(q.half);
                break;
            }
            }
            m.ball = std::make_shared<fcl::Sphered>(radius);
            m.ball->computeLocalAABB();
            m.target->computeLocalAABB();
            motions_.push_back(std::move(m));
        }
    }

    [[nodiscard]] std::optional<double> answer(std::size_t i) const override {
        const motion& m = motions_[i];
        fcl::ContinuousCollisionResultd result;
        fcl::continuousCollide(m.ball.get(), m.from, m.to, m.target.get(), m.stands, m.stands, request_, result);
        return result.is_collide ? std::optional(result.time_of_contact * m.horizon) : std::nullopt;
    }

  private:
    struct motion {
        geometry ball, target;
        fcl::Transform3d from = fcl::Transform3d::Identity(), to = from, stands = from;
        double horizon = 1;
    };
    fcl::ContinuousCollisionRequestd request_;
    std::vector<motion> motions_;
};

} // namespace

std::vector<entry> fcl_entries() {
    std::vector<entry> all;
    all.push_back(
        {"FCL", "FCL " FCL_VERSION,
         "continuousCollide in double: conservative advancement, translation, libccd's GJK, toc_err 1e-12, "
         "1000 iterations; edges as capsules",
         "an approximate time of contact: shapes are advanced by their distance until a step is below 1e-4 of "
         "the motion (toc_err is not read by this solver)",
         [](const trial& t) -> std::unique_ptr<contestant> { return std::make_unique<fcl_contestant>(t); }, 53, true,
         true});
    return all;
}

} // namespace peers
