#include "sim/world/bullet/few_body_solver.hpp"

#include <memory>
#include <vector>

#include <btBulletDynamicsCommon.h>
#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

/// A cart of a box and two balls on motors, on a slab and against a wall, in Bullet's own world.
template <typename Solver>
class Cart {
 public:
  Cart() {
    world_.setGravity(btVector3(0.0, 0.0, -9.81));
    world_.getSolverInfo().m_numIterations = 20;
    world_.getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
    add(0.0, ground_, {0.0, 0.0, -0.5});
    add(0.0, wall_, {0.8, 0.05, 0.5});
    btRigidBody& chassis = add(2.0, box_, {-0.02, 0.0, 0.06});
    for (const double y : {0.15, -0.15}) {
      btRigidBody& wheel = add(0.3, ball_, {0.05, y, 0.05});
      const btQuaternion z_to_y(btVector3(1.0, 0.0, 0.0), -SIMD_HALF_PI);
      hinges_.push_back(std::make_unique<btHingeConstraint>(
          chassis, wheel, btTransform(z_to_y, btVector3(0.07, y, -0.01)), btTransform(z_to_y)));
      world_.addConstraint(hinges_.back().get(), true);
    }
  }
  ~Cart() {
    for (const auto& hinge : hinges_) world_.removeConstraint(hinge.get());
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
  }
  Cart(const Cart&) = delete;
  Cart& operator=(const Cart&) = delete;

  void step(double left, double right) {
    hinges_[0]->enableAngularMotor(true, -left, 0.02);
    hinges_[1]->enableAngularMotor(true, -right, 0.02);
    world_.stepSimulation(1.0 / 240.0, 0);
  }
  [[nodiscard]] std::vector<double> numbers() const {
    std::vector<double> result;
    for (const auto& body : bodies_) {
      for (const btVector3& v : {body->getWorldTransform().getOrigin(), body->getLinearVelocity(),
                                 body->getAngularVelocity()}) {
        result.insert(result.end(), {v.x(), v.y(), v.z()});
      }
    }
    return result;
  }
  [[nodiscard]] btVector3 position() const { return bodies_[2]->getWorldTransform().getOrigin(); }

 private:
  btRigidBody& add(double mass, btCollisionShape& shape, const btVector3& position) {
    btVector3 inertia(0.0, 0.0, 0.0);
    if (mass > 0.0) shape.calculateLocalInertia(mass, inertia);
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &shape, inertia);
    info.m_startWorldTransform.setOrigin(position);
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    bodies_.back()->setActivationState(mass > 0.0 ? DISABLE_DEACTIVATION : ISLAND_SLEEPING);
    const bool fixed = mass == 0.0;
    world_.addRigidBody(bodies_.back().get(), fixed ? 1 : 2, fixed ? 2 : 1);
    return *bodies_.back();
  }

  btBoxShape ground_{btVector3(5.0, 5.0, 0.5)};
  btBoxShape wall_{btVector3(0.05, 1.0, 0.5)};
  btBoxShape box_{btVector3(0.15, 0.1, 0.05)};
  btSphereShape ball_{0.05};
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  Solver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::vector<std::unique_ptr<btHingeConstraint>> hinges_;
};

/// It drives, tilts on its edge and runs into the wall at an angle.
TEST(FewBodySolver, MovesACartAsBulletDoesToTheBit) {
  Cart<btSequentialImpulseConstraintSolver> bullet;
  Cart<FewBodySolver> ours;
  for (int i = 0; i < 1200; ++i) {
    const double left = i < 700 ? 6.0 : -4.0;
    const double right = i < 700 ? 6.5 : -2.0;
    bullet.step(left, right);
    ours.step(left, right);
    ASSERT_EQ(ours.numbers(), bullet.numbers()) << "step " << i;
    if (i == 699) {
      EXPECT_GT(ours.position().x(), 0.3);
    }
  }
}

/// Two boxes on each other: Bullet solves what there are no rows for.
TEST(FewBodySolver, LeavesContactsOfMovingBodiesToBullet) {
  const auto fall = [](auto solver) {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    btDiscreteDynamicsWorld world(&dispatcher, &broadphase, solver.get(), &configuration);
    world.setGravity(btVector3(0.0, 0.0, -9.81));
    btBoxShape slab(btVector3(5.0, 5.0, 0.5));
    btBoxShape box(btVector3(0.1, 0.1, 0.1));
    const btVector3 inertia(0.01, 0.01, 0.01);
    btRigidBody ground(0.0, nullptr, &slab);
    btRigidBody lower(1.0, nullptr, &box, inertia);
    btRigidBody upper(1.0, nullptr, &box, inertia);
    lower.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0.0, 0.0, 0.65)));
    upper.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0.03, 0.0, 0.9)));
    for (btRigidBody* body : {&ground, &lower, &upper}) world.addRigidBody(body);
    for (int i = 0; i < 200; ++i) world.stepSimulation(1.0 / 240.0, 0);
    const double height = upper.getWorldTransform().getOrigin().z();
    for (btRigidBody* body : {&ground, &lower, &upper}) world.removeRigidBody(body);
    return height;
  };
  const double ours = fall(std::make_unique<FewBodySolver>());
  EXPECT_EQ(ours, fall(std::make_unique<btSequentialImpulseConstraintSolver>()));
  EXPECT_NEAR(ours, 0.8, 0.02);
}

}  // namespace
}  // namespace castaway::sim
