/// Collision shapes of a chassis for Bullet. Internal to sim/robot.
#pragma once

#include <memory>
#include <vector>

#include <btBulletDynamicsCommon.h>

#include "sim/robot/urdf/robot_model.hpp"

namespace castaway::sim {

/// A compound of convex hulls and casters about the centre of mass, with the axes of base. Hulls
/// end just above the floor, on which only wheels and casters roll.
class ChassisShape {
 public:
  explicit ChassisShape(const RobotModel& robot);

  [[nodiscard]] btCompoundShape* compound() { return &compound_; }

 private:
  void add(std::unique_ptr<btCollisionShape> shape, const Eigen::Vector3d& p_com_shape);

  std::vector<std::unique_ptr<btCollisionShape>> children_;
  btCompoundShape compound_;
};

}  // namespace castaway::sim
