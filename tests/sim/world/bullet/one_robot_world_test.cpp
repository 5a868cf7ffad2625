#include "sim/world/bullet/one_robot_world.hpp"

#include <memory>
#include <vector>

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

/// A dumb-bell of two hinged boxes that falls among fixed boxes; its states, step by step.
template <typename World>
std::vector<double> tumble() {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  World world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity(btVector3(0.0, 0.0, -9.81));
  world.setForceUpdateAllAabbs(false);
  btBoxShape slab(btVector3(5.0, 5.0, 0.5));
  btBoxShape box(btVector3(0.1, 0.2, 0.1));
  std::vector<std::unique_ptr<btRigidBody>> bodies;
  const auto add = [&](double mass, btCollisionShape& shape, const btVector3& position) {
    const btVector3 inertia(0.01 * mass, 0.01 * mass, 0.01 * mass);
    bodies.push_back(std::make_unique<btRigidBody>(
        btRigidBody::btRigidBodyConstructionInfo(mass, nullptr, &shape, inertia)));
    const btQuaternion turn(btVector3(1.0, 2.0, 0.5).normalized(), mass > 0.0 ? 0.4 : 0.0);
    bodies.back()->setWorldTransform(btTransform(turn, position));
    if (mass > 0.0) bodies.back()->setActivationState(DISABLE_DEACTIVATION);
    world.addRigidBody(bodies.back().get(), mass > 0.0 ? 2 : 1, mass > 0.0 ? 1 : 2);
  };
  add(0.0, slab, {0.0, 0.0, -0.5});
  for (int i = 0; i < 12; ++i) add(0.0, box, {0.3 * (i % 4) - 0.5, 0.5 * (i / 4) - 0.5, 0.1});
  add(1.0, box, {0.0, 0.0, 0.9});
  add(2.0, box, {0.3, 0.1, 1.0});
  btHingeConstraint hinge(*bodies[13], *bodies[14], btVector3(0.15, 0.0, 0.0),
                          btVector3(-0.15, 0.0, 0.0), btVector3(0.0, 1.0, 0.0),
                          btVector3(0.0, 1.0, 0.0));
  world.addConstraint(&hinge, true);
  std::vector<double> states;
  for (int i = 0; i < 600; ++i) {
    world.stepSimulation(1.0 / 240.0, 0);
    for (const std::size_t k : {13U, 14U}) {
      const btVector3& p = bodies[k]->getWorldTransform().getOrigin();
      states.insert(states.end(), {p.x(), p.y(), p.z()});
    }
  }
  world.removeConstraint(&hinge);
  for (const auto& body : bodies) world.removeRigidBody(body.get());
  return states;
}

TEST(OneRobotWorld, MovesJoinedBodiesAsBulletDoesToTheBit) {
  const std::vector<double> states = tumble<OneRobotWorld>();
  EXPECT_EQ(states, tumble<btDiscreteDynamicsWorld>());
  EXPECT_LT(states.back(), 0.6);  // It has fallen among the boxes.
}

}  // namespace
}  // namespace castaway::sim
