/// Bullet's world without the work that a single robot among fixed bodies does not need. Internal
/// to sim/world.
#pragma once

#include <btBulletDynamicsCommon.h>

namespace castaway::sim {

/// `btDiscreteDynamicsWorld` for moving bodies that are all joined to each other, never sleep, have
/// no damping and no continuous collision detection, among fixed ones. Such bodies are one island,
/// and no step visits the fixed bodies. Trajectories equal Bullet's bit for bit.
class OneRobotWorld : public btDiscreteDynamicsWorld {
 public:
  using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;

  void updateAabbs() override;
  void solveConstraints(btContactSolverInfo& info) override;

 protected:
  void predictUnconstraintMotion(btScalar time_step) override;
  void createPredictiveContacts(btScalar /*time_step*/) override {}
  void calculateSimulationIslands() override {}
  void saveKinematicState(btScalar /*time_step*/) override {}

 private:
  void collect_manifolds();

  btAlignedObjectArray<btCollisionObject*> moving_;
  btAlignedObjectArray<btPersistentManifold*> manifolds_;
};

}  // namespace castaway::sim
