#include "sim/world/bullet/few_body_solver.hpp"

namespace castaway::sim {
namespace {

/// True if a body can move along and about all axes.
bool moves_freely(const btSolverBody& body) {
  const btVector3 one(1.0, 1.0, 1.0);
  return body.m_linearFactor == one && body.m_angularFactor == one;
}

}  // namespace

bool FewBodySolver::knows_all_rows(const btContactSolverInfo& info) const {
  const int fixed = m_fixedBodyId;
  for (int i = 0; i < m_tmpSolverBodyPool.size(); ++i) {
    if (i != fixed && !moves_freely(m_tmpSolverBodyPool[i])) return false;
  }
  for (int i = 0; i < m_tmpSolverNonContactConstraintPool.size(); ++i) {
    const btSolverConstraint& row = m_tmpSolverNonContactConstraintPool[i];
    if (row.m_solverBodyIdA == fixed || row.m_solverBodyIdB == fixed) return false;
    if (row.m_overrideNumSolverIterations != info.m_numIterations) return false;
  }
  for (int i = 0; i < m_tmpSolverContactConstraintPool.size(); ++i) {
    const btSolverConstraint& row = m_tmpSolverContactConstraintPool[i];
    if ((row.m_solverBodyIdA == fixed) == (row.m_solverBodyIdB == fixed)) return false;
  }
  const int other_modes =
      SOLVER_RANDMIZE_ORDER | SOLVER_INTERLEAVE_CONTACT_AND_FRICTION_CONSTRAINTS;
  return m_tmpSolverContactRollingFrictionConstraintPool.size() == 0 &&
         (info.m_solverMode & other_modes) == 0 && info.m_leastSquaresResidualThreshold == 0.0;
}

void FewBodySolver::load() {
  velocities_.resize(static_cast<std::size_t>(m_tmpSolverBodyPool.size()));
  for (int i = 0; i < m_tmpSolverBodyPool.size(); ++i) {
    const btVector3& linear = m_tmpSolverBodyPool[i].m_deltaLinearVelocity;
    const btVector3& angular = m_tmpSolverBodyPool[i].m_deltaAngularVelocity;
    BodyVelocity& v = velocities_[static_cast<std::size_t>(i)];
    for (int k = 0; k < 3; ++k) v[static_cast<std::size_t>(k)] = {linear[k], angular[k]};
  }
  load_joints();
  load_contacts();
}

void FewBodySolver::load_joints() {
  std::size_t used = 0;
  for (int i = 0; i < m_tmpSolverNonContactConstraintPool.size(); ++i) {
    const btSolverConstraint& row = m_tmpSolverNonContactConstraintPool[i];
    const auto a = static_cast<std::size_t>(row.m_solverBodyIdA);
    const auto b = static_cast<std::size_t>(row.m_solverBodyIdB);
    if (used == 0 || joints_[used - 1].a != a || joints_[used - 1].b != b) {
      if (++used > joints_.size()) joints_.emplace_back();
      joints_[used - 1].a = a;
      joints_[used - 1].b = b;
      joints_[used - 1].rows.clear();
    }
    joints_[used - 1].rows.push_back(joint_row(row, m_tmpSolverBodyPool[row.m_solverBodyIdA],
                                               m_tmpSolverBodyPool[row.m_solverBodyIdB]));
  }
  joints_.resize(used);
}

void FewBodySolver::load_contacts() {
  const auto row_of = [this](const btSolverConstraint& row) {
    return contact_row(row, m_tmpSolverBodyPool[row.m_solverBodyIdA],
                       m_tmpSolverBodyPool[row.m_solverBodyIdB]);
  };
  normals_.clear();
  frictions_.clear();
  for (int i = 0; i < m_tmpSolverContactConstraintPool.size(); ++i) {
    normals_.push_back(row_of(m_tmpSolverContactConstraintPool[i]));
  }
  for (int i = 0; i < m_tmpSolverContactFrictionConstraintPool.size(); ++i) {
    const btSolverConstraint& row = m_tmpSolverContactFrictionConstraintPool[i];
    const double applied = row.m_appliedImpulse;
    if (row.m_friction == 0.0 && applied == 0.0) continue;
    frictions_.push_back(
        {row_of(row), row.m_friction, static_cast<std::size_t>(row.m_frictionIndex), i});
  }
}

/// Solves all rows once. Returns false if nothing changed, as nothing ever will after that.
bool FewBodySolver::iterate() {
  bool changed = false;
  for (Joint& joint : joints_) changed = solve(joint, velocities_) || changed;
  for (ContactRow& row : normals_) changed = solve(row, velocities_[row.body]) || changed;
  for (FrictionRow& friction : frictions_) {
    const double normal = normals_[friction.normal].state.applied;
    if (!(normal > 0.0)) continue;
    ContactRow& row = friction.row;
    row.state.upper = friction.coefficient * normal;
    row.state.lower = -row.state.upper;
    changed = solve(row, velocities_[row.body]) || changed;
  }
  return changed;
}

void FewBodySolver::store() {
  for (int i = 0; i < m_tmpSolverBodyPool.size(); ++i) {
    if (i == m_fixedBodyId) continue;
    const BodyVelocity& v = velocities_[static_cast<std::size_t>(i)];
    btSolverBody& body = m_tmpSolverBodyPool[i];
    body.m_deltaLinearVelocity.setValue(v[0][0], v[1][0], v[2][0]);
    body.m_deltaAngularVelocity.setValue(v[0][1], v[1][1], v[2][1]);
  }
  int row = 0;
  for (const Joint& joint : joints_) {
    for (const JointRow& solved : joint.rows) {
      m_tmpSolverNonContactConstraintPool[row++].m_appliedImpulse = solved.state.applied;
    }
  }
  for (std::size_t i = 0; i < normals_.size(); ++i) {
    m_tmpSolverContactConstraintPool[static_cast<int>(i)].m_appliedImpulse =
        normals_[i].state.applied;
  }
  for (const FrictionRow& friction : frictions_) {
    m_tmpSolverContactFrictionConstraintPool[friction.source].m_appliedImpulse =
        friction.row.state.applied;
  }
}

// NOLINTNEXTLINE(readability-function-size): the parameters are Bullet's.
btScalar FewBodySolver::solveGroupCacheFriendlyIterations(
    btCollisionObject** bodies, int body_count, btPersistentManifold** manifolds,
    int manifold_count, btTypedConstraint** constraints, int constraint_count,
    const btContactSolverInfo& info, btIDebugDraw* draw) {
  if (!knows_all_rows(info)) {
    return btSequentialImpulseConstraintSolver::solveGroupCacheFriendlyIterations(
        bodies, body_count, manifolds, manifold_count, constraints, constraint_count, info, draw);
  }
  solveGroupCacheFriendlySplitImpulseIterations(bodies, body_count, manifolds, manifold_count,
                                                constraints, constraint_count, info, draw);
  load();
  for (int i = 0; i < info.m_numIterations && iterate(); ++i) {
  }
  store();
  return 0.0;
}

}  // namespace castaway::sim
