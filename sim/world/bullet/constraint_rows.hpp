/// Rows of a projected Gauss-Seidel solver, laid out for pairs of numbers. Internal to sim/world.
///
/// All sums have the order of Bullet's `gResolveSingleConstraintRowGeneric`, so that results are
/// the same bit for bit.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <BulletDynamics/ConstraintSolver/btSolverBody.h>
#include <BulletDynamics/ConstraintSolver/btSolverConstraint.h>
#include <Eigen/Core>

namespace castaway::sim {

/// What a row asks for, and the impulse that it has applied so far. Units: of Bullet's rows, kg m/s
/// for linear ones and kg m^2/s for angular ones.
struct RowState {
  explicit RowState(const btSolverConstraint& row);
  /// Adds an impulse to `applied`, within its limits. Returns what was added.
  double apply(double impulse);
  /// Impulse that bodies without a change of velocity would need.
  [[nodiscard]] double wanted() const { return rhs - applied * cfm; }

  double mass;  ///< Effective mass along the row.
  double rhs;
  double cfm;
  double lower;  ///< Limits of `applied`.
  double upper;
  double applied;
};

/// Two vectors, coordinate by coordinate side by side.
using VectorPair = std::array<Eigen::Array2d, 3>;

/// A row between two bodies; pairs hold the vectors of bodies a and b.
struct JointRow {
  VectorPair linear;            ///< Jacobian.
  VectorPair angular;           ///< Jacobian.
  VectorPair linear_response;   ///< Change of velocity by a unit impulse.
  VectorPair angular_response;  ///< Change of angular velocity by a unit impulse.
  bool is_angular;              ///< The linear part is zero.
  RowState state;
};

/// A row between a body and the fixed world; pairs hold the linear and the angular vector.
struct ContactRow {
  VectorPair jacobian;
  VectorPair response;  ///< Change of velocity by a unit impulse.
  std::size_t body;     ///< Index of the body that can move.
  RowState state;
};

/// Rows of a joint between bodies a and b.
struct Joint {
  std::size_t a;
  std::size_t b;
  std::vector<JointRow> rows;
};

/// Changes of a body's velocity so far; the pair holds the linear and the angular vector.
using BodyVelocity = VectorPair;

JointRow joint_row(const btSolverConstraint& row, const btSolverBody& a, const btSolverBody& b);

/// `a` or `b` must be fixed.
ContactRow contact_row(const btSolverConstraint& row, const btSolverBody& a, const btSolverBody& b);

/// Solve rows once, one after the other. Return true if any impulse changed.
bool solve(Joint& joint, std::vector<BodyVelocity>& velocities);
bool solve(ContactRow& row, BodyVelocity& velocity);

}  // namespace castaway::sim
