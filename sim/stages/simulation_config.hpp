/// All that a simulated run depends on.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "sim/common/geometry.hpp"
#include "sim/common/random.hpp"
#include "sim/events/fault.hpp"
#include "sim/events/kidnap.hpp"
#include "sim/map/grid.hpp"
#include "sim/navigation/twist_log.hpp"
#include "sim/people/people_config.hpp"
#include "sim/robot/bodies/twist_ramp.hpp"
#include "sim/robot/urdf/robot_model.hpp"
#include "sim/sensor/lidar_config.hpp"
#include "sim/sensor/wheel_odometry.hpp"
#include "sim/world/world_spec.hpp"

namespace castaway::sim {

/// Where the robot drives and how fast.
struct DriveConfig {
  std::vector<Eigen::Vector2d> waypoints;  ///< [m] In map; none: the robot stands still.
  bool loop = true;                        ///< Starts again after the last waypoint.
  std::vector<TimedTwist> log{};           ///< Driven instead of the waypoints; may be empty.
  bool by_estimate = false;                ///< Drives by `set_drive_pose`; false: by the true pose.
  TwistLimits limits;                      ///< The wheels' own limits apply too.
  double wait_s = 0.0;                     ///< [s] The robot stands still at first.
};

/// By what the robot moves.
enum class DriveModel : std::uint8_t {
  kPhysics,    ///< Bullet: masses, contacts, motors.
  kKinematic,  ///< Exactly as commanded; obstacles stop it.
};

/// All that a simulated run depends on, besides its random streams.
struct SimulationConfig {
  WorldSpec world;
  Grid map;  ///< What the robot's planner knows; objects missing on it are avoided all the same.
  RobotModel robot;
  /// With names of their own, at least one. People, guards and kidnaps go by the first.
  std::vector<LidarConfig> lidars{LidarConfig{}};
  OdometryConfig odometry;
  DriveConfig drive;
  std::vector<KidnapSpec> kidnaps;
  std::vector<FaultSpec> faults{};
  PeopleConfig people;
  Pose2 start;                ///< True pose of base in map; ignored if `random_start`.
  bool random_start = false;  ///< Draws a pose in reachable free space.
  std::chrono::nanoseconds duration = std::chrono::seconds(120);
  double physics_hz = 500.0;  ///< [Hz] Rounded to whole nanoseconds a step.
  DriveModel drive_model = DriveModel::kPhysics;
};

/// One stream of random numbers for each consumer.
struct SimulationStreams {
  Rng lidar;
  Rng odometry;
  Rng events;
  /// Streams by name, "people/...", "lidar/...", "odometry/..."; needed for people and for sensors
  /// with more than plain noise.
  std::function<Rng(const std::string& name)> named{};
};

}  // namespace castaway::sim
