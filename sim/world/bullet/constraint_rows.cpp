#include "sim/world/bullet/constraint_rows.hpp"

namespace castaway::sim {
namespace {

/// Changes of the velocities of two bodies; pairs hold body a and body b.
struct JointVelocity {
  VectorPair linear;
  VectorPair angular;
};

JointVelocity joint_velocity(const BodyVelocity& a, const BodyVelocity& b) {
  JointVelocity v;
  for (std::size_t i = 0; i < 3; ++i) {
    v.linear[i] = {a[i][0], b[i][0]};
    v.angular[i] = {a[i][1], b[i][1]};
  }
  return v;
}

inline Eigen::Array2d dots(const VectorPair& u, const VectorPair& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

inline void add(const VectorPair& response, double impulse, VectorPair& v) {
  v[0] += response[0] * impulse;
  v[1] += response[1] * impulse;
  v[2] += response[2] * impulse;
}

inline bool solve_joint_row(JointRow& row, JointVelocity& v) {
  Eigen::Array2d speeds = dots(row.angular, v.angular);
  if (!row.is_angular) speeds = dots(row.linear, v.linear) + speeds;
  speeds *= row.state.mass;
  const double impulse = row.state.apply(row.state.wanted() - speeds[0] - speeds[1]);
  if (impulse == 0.0) return false;
  if (!row.is_angular) add(row.linear_response, impulse, v.linear);
  add(row.angular_response, impulse, v.angular);
  return true;
}

VectorPair side_by_side(const btVector3& first, const btVector3& second) {
  return {Eigen::Array2d(first.x(), second.x()), Eigen::Array2d(first.y(), second.y()),
          Eigen::Array2d(first.z(), second.z())};
}

}  // namespace

RowState::RowState(const btSolverConstraint& row)
    : mass(row.m_jacDiagABInv),
      rhs(row.m_rhs),
      cfm(row.m_cfm),
      lower(row.m_lowerLimit),
      upper(row.m_upperLimit),
      applied(row.m_appliedImpulse) {}

inline double RowState::apply(double impulse) {
  const double before = applied;
  const double sum = before + impulse;
  if (sum < lower) {
    applied = lower;
    return lower - before;
  }
  if (sum > upper) {
    applied = upper;
    return upper - before;
  }
  applied = sum;
  return impulse;
}

JointRow joint_row(const btSolverConstraint& row, const btSolverBody& a, const btSolverBody& b) {
  return {side_by_side(row.m_contactNormal1, row.m_contactNormal2),
          side_by_side(row.m_relpos1CrossNormal, row.m_relpos2CrossNormal),
          side_by_side(row.m_contactNormal1 * a.m_invMass, row.m_contactNormal2 * b.m_invMass),
          side_by_side(row.m_angularComponentA, row.m_angularComponentB),
          row.m_contactNormal1.isZero() && row.m_contactNormal2.isZero(),
          RowState(row)};
}

ContactRow contact_row(const btSolverConstraint& row, const btSolverBody& a,
                       const btSolverBody& b) {
  if (a.m_originalBody != nullptr) {
    return {side_by_side(row.m_contactNormal1, row.m_relpos1CrossNormal),
            side_by_side(row.m_contactNormal1 * a.m_invMass, row.m_angularComponentA),
            static_cast<std::size_t>(row.m_solverBodyIdA), RowState(row)};
  }
  return {side_by_side(row.m_contactNormal2, row.m_relpos2CrossNormal),
          side_by_side(row.m_contactNormal2 * b.m_invMass, row.m_angularComponentB),
          static_cast<std::size_t>(row.m_solverBodyIdB), RowState(row)};
}

bool solve(Joint& joint, std::vector<BodyVelocity>& velocities) {
  JointVelocity v = joint_velocity(velocities[joint.a], velocities[joint.b]);
  bool changed = false;
  for (JointRow& row : joint.rows) changed = solve_joint_row(row, v) || changed;
  for (std::size_t i = 0; i < 3; ++i) {
    velocities[joint.a][i] = {v.linear[i][0], v.angular[i][0]};
    velocities[joint.b][i] = {v.linear[i][1], v.angular[i][1]};
  }
  return changed;
}

bool solve(ContactRow& row, BodyVelocity& velocity) {
  const Eigen::Array2d speeds = dots(row.jacobian, velocity);
  const double excess = (speeds[0] + speeds[1]) * row.state.mass;
  const double impulse = row.state.apply(row.state.wanted() - excess);
  if (impulse == 0.0) return false;
  add(row.response, impulse, velocity);
  return true;
}

}  // namespace castaway::sim
