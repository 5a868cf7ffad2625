#include "sim/world/bullet/one_robot_world.hpp"

namespace castaway::sim {
namespace {

/// Bullet sorts contacts and constraints by island, with a sort that is not stable: with one island
/// it only permutes them. The same permutation gives the same sums.
constexpr auto kSameIsland = [](const auto*, const auto*) { return false; };

}  // namespace

void OneRobotWorld::updateAabbs() {
  for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
    updateSingleAabb(m_nonStaticRigidBodies[i]);
  }
}

void OneRobotWorld::predictUnconstraintMotion(btScalar time_step) {
  for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
    btRigidBody& body = *m_nonStaticRigidBodies[i];
    body.predictIntegratedTransform(time_step, body.getInterpolationWorldTransform());
  }
}

void OneRobotWorld::collect_manifolds() {
  manifolds_.resize(0);
  for (int i = 0; i < m_dispatcher1->getNumManifolds(); ++i) {
    btPersistentManifold* manifold = m_dispatcher1->getManifoldByIndexInternal(i);
    if (m_dispatcher1->needsResponse(manifold->getBody0(), manifold->getBody1())) {
      manifolds_.push_back(manifold);
    }
  }
  manifolds_.quickSort(kSameIsland);
}

void OneRobotWorld::solveConstraints(btContactSolverInfo& info) {
  if (m_nonStaticRigidBodies.size() == 0) return;
  moving_.resize(0);
  for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
    moving_.push_back(m_nonStaticRigidBodies[i]);
  }
  collect_manifolds();
  m_sortedConstraints.copyFromArray(m_constraints);
  m_sortedConstraints.quickSort(kSameIsland);
  const auto first = [](auto& array) { return array.size() > 0 ? &array[0] : nullptr; };
  m_constraintSolver->solveGroup(first(moving_), moving_.size(), first(manifolds_),
                                 manifolds_.size(), first(m_sortedConstraints),
                                 m_sortedConstraints.size(), info, m_debugDrawer, m_dispatcher1);
}

}  // namespace castaway::sim
