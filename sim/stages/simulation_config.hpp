/// Configuration of a simulated run.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "sim/common/geometry.hpp"
#include "sim/common/random.hpp"
#include "sim/events/event_lists.hpp"
#include "sim/map/grid.hpp"
#include "sim/navigation/twist_log.hpp"
#include "sim/people/people_config.hpp"
#include "sim/robot/bodies/path_robot.hpp"
#include "sim/robot/bodies/twist_ramp.hpp"
#include "sim/robot/urdf/robot_model.hpp"
#include "sim/sensor/further_sensors.hpp"
#include "sim/sensor/lidar_config.hpp"
#include "sim/sensor/wheel_odometry.hpp"
#include "sim/world/world.hpp"

namespace castaway::sim {

struct LevelPlane;
class Spaces;

/// Where and how fast the robot drives.
struct DriveConfig {
  std::vector<Eigen::Vector2d> waypoints;  ///< [m] In map; if empty, the robot stands still.
  bool loop = true;                        ///< Starts again after the last waypoint.
  std::vector<TimedTwist> log{};           ///< Driven instead of the waypoints if not empty.
  /// Followed exactly if not empty, without physics, from its first pose on.
  std::vector<TimedPose> path{};
  bool by_estimate = false;  ///< Drives by the pose of `set_drive_pose`; false: by the true pose.
  TwistLimits limits;        ///< The limits of the wheels apply, too.
  double wait_s = 0.0;       ///< [s] Time for which the robot stands still at first.
};

/// How the robot's motion is computed.
enum class DriveModel : std::uint8_t {
  kPhysics,    ///< Bullet: masses, contacts, motors.
  kKinematic,  ///< Exactly as commanded; obstacles stop the robot.
};

/// Everything that a simulated run depends on, except its random streams.
struct SimulationConfig {
  WorldSpec world;
  /// The floors on which the robot drives, if there are several: `start`, `drive.waypoints` and
  /// targets of kidnaps are then in frame plane (sim/map/level_plane.hpp).
  std::shared_ptr<const LevelPlane> levels{};
  Grid map;  ///< Known to the robot's planner; objects that it lacks are avoided nevertheless.
  RobotModel robot;
  /// At least one, with unique names. Crowds and look-alike kidnaps use the first.
  std::vector<LidarConfig> lidars{LidarConfig{}};
  OdometryConfig odometry;
  FurtherSensors sensors;
  DriveConfig drive;
  EventLists events;
  /// Events may be added while it runs (`Simulation::add`). A run that is configured with them
  /// gives the same bytes.
  bool open = false;
  PeopleConfig people;
  /// A watched output nearer to the true pose is right (`KidnapTrigger::On::kLocalized`).
  double right_position = 0.0;  ///< [m]
  double right_yaw = 0.0;       ///< [rad]
  Pose2 start;                  ///< True pose of base in map; ignored if `random_start`.
  bool random_start = false;    ///< Draws a pose in reachable free space.
  std::chrono::nanoseconds duration = std::chrono::seconds(120);
  double physics_hz = 500.0;  ///< [Hz] Rounded to whole nanoseconds a step.
  DriveModel drive_model = DriveModel::kPhysics;
  /// Of this world and map, to be shared with other runs; empty: the run computes its own.
  std::shared_ptr<Spaces> spaces{};
};

/// One stream of random numbers per consumer.
struct SimulationStreams {
  Rng lidar;
  Rng odometry;
  Rng events;
  /// Returns a stream by name: "people/...", "lidar/...", "odometry/...". Required for people and
  /// for sensors with more than plain noise.
  std::function<Rng(const std::string& name)> named{};
};

}  // namespace castaway::sim
