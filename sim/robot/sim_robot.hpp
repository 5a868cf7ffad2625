/// The robot of a run: with physics, without, or on a recorded path.
#pragma once

#include <cstdint>
#include <utility>
#include <variant>

#include "sim/robot/bodies/kinematic_robot.hpp"
#include "sim/robot/bodies/path_robot.hpp"
#include "sim/robot/bodies/robot_physics.hpp"

namespace castaway::sim {

/// Each kind of robot behind one interface.
class SimRobot {
 public:
  explicit SimRobot(RobotPhysics robot) : robot_(std::move(robot)) {}
  explicit SimRobot(KinematicRobot robot) : robot_(std::move(robot)) {}
  explicit SimRobot(PathRobot robot) : robot_(std::move(robot)) {}

  /// Sets the velocity to ramp to from the next step on.
  void set_command(const Twist2& command) {
    std::visit([&](auto& robot) { robot.set_command(command); }, robot_);
  }
  /// Advances by one time step.
  void step() {
    std::visit([](auto& robot) { robot.step(); }, robot_);
  }
  /// Advances a held robot by one time step: base is at `T_map_base` at its end.
  void step_held(const Eigen::Isometry3d& T_map_base, HeldWheels wheels) {
    std::visit([&](auto& robot) { robot.step_held(T_map_base, wheels); }, robot_);
  }
  /// Puts the robot elsewhere, standing still; keeps wheel angles.
  void teleport(const Pose2& T_map_base) {
    std::visit([&](auto& robot) { robot.teleport(T_map_base); }, robot_);
  }
  /// The same on ground that is not at z = 0; for a robot with physics.
  void place(const Eigen::Isometry3d& T_map_base) {
    if (auto* robot = std::get_if<RobotPhysics>(&robot_)) robot->place(T_map_base);
  }
  /// Takes the objects of a changed world as bodies, if it has physics.
  void set_objects(const WorldSpec& world) {
    if (auto* robot = std::get_if<RobotPhysics>(&robot_)) robot->set_objects(world);
  }
  /// Takes what `make_free` returns as the free space for the robot's disc, if it has no physics.
  template <typename MakeFree>
  void set_free(const MakeFree& make_free) {
    if (auto* robot = std::get_if<KinematicRobot>(&robot_)) robot->set_free(make_free());
  }
  [[nodiscard]] const RobotState& state() const {
    return std::visit([](const auto& robot) -> const RobotState& { return robot.state(); }, robot_);
  }
  /// Number of contacts with the world, without the floor.
  [[nodiscard]] std::int64_t collisions() const {
    return std::visit([](const auto& robot) { return robot.collisions(); }, robot_);
  }
  /// True while in contact with the world, without the floor.
  [[nodiscard]] bool touching() const {
    return std::visit([](const auto& robot) { return robot.touching(); }, robot_);
  }

 private:
  std::variant<RobotPhysics, KinematicRobot, PathRobot> robot_;
};

}  // namespace castaway::sim
