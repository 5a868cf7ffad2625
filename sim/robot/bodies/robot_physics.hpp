/// A robot in a world, simulated by Bullet.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>

#include <Eigen/Geometry>

#include "sim/common/geometry.hpp"
#include "sim/events/lift.hpp"
#include "sim/robot/bodies/robot_state.hpp"
#include "sim/robot/bodies/twist_ramp.hpp"
#include "sim/robot/urdf/robot_model.hpp"
#include "sim/world/world.hpp"

namespace castaway::sim {

/// Rigid bodies on hinges: the chassis and the driven wheels. Wheels are balls of the wheel's
/// radius that collide with the floor only (their true shape belongs to the chassis); casters are
/// balls without friction. The odometry error is 0.3 mm on a 20 m square at 500 Hz.
class RobotPhysics {
 public:
  /// Places the robot at `start` with wheel angles of 0. `time_step` [s]. @throws
  /// std::runtime_error if a mesh of the world or of the robot cannot be read.
  RobotPhysics(const WorldSpec& world, const RobotModel& robot, const Pose2& start,
               const TwistLimits& limits, std::chrono::nanoseconds time_step);
  RobotPhysics(RobotPhysics&&) noexcept;
  RobotPhysics& operator=(RobotPhysics&&) noexcept;
  ~RobotPhysics();

  /// Sets the velocity to ramp to from the next step on.
  void set_command(const Twist2& command);
  /// Advances by one time step.
  void step();
  /// Advances a held robot by one time step: base is at `T_map_base` at its end, and nothing
  /// collides.
  void step_held(const Eigen::Isometry3d& T_map_base, HeldWheels wheels);
  /// Puts the robot elsewhere, standing still. Keeps wheel angles and the number of collisions.
  void teleport(const Pose2& T_map_base);
  /// The same on ground that is not at z = 0.
  void place(const Eigen::Isometry3d& T_map_base);

  /// Replaces the objects of the world; nothing may be where the robot is. @throws
  /// std::runtime_error if a mesh cannot be read.
  void set_objects(const WorldSpec& world);

  [[nodiscard]] const RobotState& state() const;
  /// Number of contacts with the world, without the floor; a contact that returns within half a
  /// second is the same one.
  [[nodiscard]] std::int64_t collisions() const;
  /// True while in contact with the world, without the floor.
  [[nodiscard]] bool touching() const;

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace castaway::sim
