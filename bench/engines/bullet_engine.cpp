// Bullet: one box in a discrete dynamics world.
#include <btBulletDynamicsCommon.h>

#include "engines/engine.h"

namespace rotatebook::bench {
namespace {

btVector3 bulletVector(const Eigen::Vector3d& v) {
  return {btScalar(v.x()), btScalar(v.y()), btScalar(v.z())};
}

Eigen::Vector3d eigenVector(const btVector3& v) {
  return {double(v.x()), double(v.y()), double(v.z())};
}

class BulletEngine final : public Engine {
 public:
  /// `gyroscopicFlags` are those of btRigidBodyFlags; 0 leaves the gyroscopic torque out.
  BulletEngine(const Motion& motion, double step, int gyroscopicFlags)
      : step_(btScalar(step)),
        shape_(bulletVector(motion.book.size / 2)),
        body_(construction(motion.book.mass)) {
    world_.setGravity(btVector3(0, 0, 0));
    body_.setFlags(gyroscopicFlags);
    body_.setActivationState(DISABLE_DEACTIVATION);
    body_.setAngularVelocity(bulletVector(motion.angularVelocity));
    world_.addRigidBody(&body_);
  }

  ~BulletEngine() override { world_.removeRigidBody(&body_); }

  void advance(int steps) override {
    // No substeps asked for: Bullet then makes one step of just this length.
    for (int i = 0; i < steps; ++i) world_.stepSimulation(step_, 0);
  }

  EngineState state() const override {
    EngineState state;
    const btMatrix3x3& basis = body_.getWorldTransform().getBasis();
    for (int row = 0; row < 3; ++row) state.worldFromBody.row(row) = eigenVector(basis[row]);
    state.angularVelocity = eigenVector(body_.getAngularVelocity());
    return state;
  }

 private:
  btRigidBody::btRigidBodyConstructionInfo construction(double mass) {
    btVector3 inertia;
    shape_.calculateLocalInertia(btScalar(mass), inertia);
    return {btScalar(mass), nullptr, &shape_, inertia};
  }

  btScalar step_;  // [s]
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  btBoxShape shape_;
  btRigidBody body_;
};

Mode mode(const char* name, int gyroscopicFlags, double massFactor = 1) {
  return {name, [gyroscopicFlags, massFactor](const Motion& motion, double step) {
            Motion heavier = motion;
            heavier.book.mass *= massFactor;
            return std::make_unique<BulletEngine>(heavier, step, gyroscopicFlags);
          }};
}

// Explains why the default never turns this book over, and why a heavier one, which ought to move
// just the same, does: btMatrix3x3::solve33() divides by the determinant only if that is above
// SIMD_EPSILON, whatever its unit, and multiplies by it otherwise.
constexpr const char* kSinglePrecisionNote =
    "single precision. The implicit modes solve for the gyroscopic torque only if the\n"
    "  determinant of the inertia is above 1.2e-7 (kg m^2)^3. This book's is 4.9e-8, so they\n"
    "  apply next to none; one of ten times the mass ought to move the same, but is above.";

}  // namespace

Family bulletFamily() {
  constexpr int kImplicitBody = BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY;
  const int version = btGetVersion();
  Family family;
  family.name = "Bullet " + std::to_string(version / 100) + "." + std::to_string(version % 100);
  family.package = "libbullet-dev";
  const bool isSingle = sizeof(btScalar) == sizeof(float);
  family.note = isSingle ? kSinglePrecisionNote : "double precision";
  family.modes = {
      mode("default: implicit, body", kImplicitBody),
      mode("same, ten times the mass", kImplicitBody, 10),
      mode("implicit, world", BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD),
      mode("explicit", BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT),
      mode("no gyroscopic torque", 0),
  };
  return family;
}

}  // namespace rotatebook::bench
