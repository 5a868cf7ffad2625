#include "sim/robot/bodies/robot_shapes.hpp"

#include <algorithm>

#include <BulletCollision/CollisionShapes/btShapeHull.h>

#include "sim/robot/urdf/part_points.hpp"
#include "sim/world/bullet_types.hpp"

namespace castaway::sim {
namespace {

constexpr double kFloorClearance = 0.004;  // [m] Of the hulls above the floor.
constexpr double kHullMargin = 0.001;      // [m]
constexpr int kMaxHullPoints = 64;

/// A hull with a thin margin; Bullet's default would grow it by 4 cm.
std::unique_ptr<btConvexHullShape> thin_hull() {
  auto shape = std::make_unique<btConvexHullShape>();
  shape->setMargin(kHullMargin);
  return shape;
}

/// A hull with fewer corners, sampled from the support of the full one.
std::unique_ptr<btConvexHullShape> reduce_hull(btConvexHullShape& full) {
  full.setMargin(0.0);  // Support points include the margin.
  btShapeHull corners(&full);
  corners.buildHull(0.0);
  auto shape = thin_hull();
  for (int i = 0; i < corners.numVertices(); ++i) {
    shape->addPoint(corners.getVertexPointer()[i], false);
  }
  shape->recalcLocalAabb();
  return shape;
}

/// Convex hull of a part, in coordinates about the centre of mass.
std::unique_ptr<btConvexHullShape> hull(const RobotPart& part, const Eigen::Vector3d& p_base_com) {
  auto shape = thin_hull();
  for (Eigen::Vector3d p : part_points(part)) {
    p.z() = std::max(p.z(), kFloorClearance + kHullMargin);
    shape->addPoint(to_bullet(Eigen::Vector3d(p - p_base_com)), false);
  }
  shape->recalcLocalAabb();
  return shape->getNumPoints() > kMaxHullPoints ? reduce_hull(*shape) : std::move(shape);
}

}  // namespace

ChassisShape::ChassisShape(const RobotModel& robot) {
  for (const RobotPart& part : robot.collisions) {
    add(hull(part, robot.p_base_com), Eigen::Vector3d::Zero());
  }
  for (const Caster& caster : robot.casters) {
    add(std::make_unique<btSphereShape>(caster.radius), caster.p_base_caster - robot.p_base_com);
  }
}

void ChassisShape::add(std::unique_ptr<btCollisionShape> shape,
                       const Eigen::Vector3d& p_com_shape) {
  compound_.addChildShape(btTransform(btQuaternion::getIdentity(), to_bullet(p_com_shape)),
                          shape.get());
  children_.push_back(std::move(shape));
}

}  // namespace castaway::sim
