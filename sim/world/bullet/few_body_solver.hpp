/// Bullet's solver of contacts and hinges, made faster for few bodies. Internal to sim/world.
#pragma once

#include <cstddef>
#include <vector>

#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>

#include "sim/world/bullet/constraint_rows.hpp"

namespace castaway::sim {

/// `btSequentialImpulseConstraintSolver` (projected Gauss-Seidel; E. Catto, "Iterative Dynamics
/// with Temporal Coherence", 2005) with iterations over compact rows. It leaves out what changes
/// nothing: fixed bodies, linear parts of angular rows, friction rows of frictionless contacts.
/// Velocities equal Bullet's bit for bit. What it has no rows for (contacts of two moving bodies,
/// rolling friction) is left to Bullet.
class FewBodySolver : public btSequentialImpulseConstraintSolver {
 protected:
  btScalar solveGroupCacheFriendlyIterations(btCollisionObject** bodies, int body_count,
                                             btPersistentManifold** manifolds, int manifold_count,
                                             btTypedConstraint** constraints, int constraint_count,
                                             const btContactSolverInfo& info,
                                             btIDebugDraw* draw) override;

 private:
  /// Friction of a contact: limited by the impulse of its normal row.
  struct FrictionRow {
    ContactRow row;
    double coefficient;
    std::size_t normal;  ///< Index into `normals_`.
    int source;          ///< Index into Bullet's rows.
  };

  [[nodiscard]] bool knows_all_rows(const btContactSolverInfo& info) const;
  void load();
  void load_joints();
  void load_contacts();
  bool iterate();
  void store();

  std::vector<BodyVelocity> velocities_;
  std::vector<Joint> joints_;
  std::vector<ContactRow> normals_;
  std::vector<FrictionRow> frictions_;
};

}  // namespace castaway::sim
