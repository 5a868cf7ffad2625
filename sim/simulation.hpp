/// The simulator as one object: a robot in a world, and what its sensors deliver.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "sim/common/geometry.hpp"
#include "sim/common/random.hpp"
#include "sim/events/fault.hpp"
#include "sim/events/kidnap.hpp"
#include "sim/map/grid.hpp"
#include "sim/navigation/twist_log.hpp"
#include "sim/people/people_config.hpp"
#include "sim/robot/urdf/robot_model.hpp"
#include "sim/sensor/lidar_config.hpp"
#include "sim/sensor/readings.hpp"
#include "sim/sensor/wheel_odometry.hpp"
#include "sim/stages/progress_watch.hpp"
#include "sim/world/world_spec.hpp"

namespace castaway::sim {

/// Where the robot drives and how fast.
struct DriveConfig {
  std::vector<Eigen::Vector2d> waypoints;  ///< [m] In map; none: the robot stands still.
  bool loop = true;                        ///< Starts again after the last waypoint.
  std::vector<TimedTwist> log{};           ///< Driven instead of the waypoints; may be empty.
  bool by_estimate = false;                ///< Drives by `set_drive_pose`; false: by the true pose.
  double max_speed = 0.5;                  ///< [m/s] The wheels' own limit applies too.
  double max_turn_rate = 1.0;              ///< [rad/s]
  double max_acceleration = 0.5;           ///< [m/s^2]
  double max_turn_acceleration = 2.0;      ///< [rad/s^2]
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
  LidarConfig lidar;                       ///< The first; people and guards go by it.
  std::vector<LidarConfig> more_lidars{};  ///< Further ones, with other names.
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

/// The robot was lifted from the floor. A kidnap's record follows when it stands again.
struct PickUpRecord {
  std::chrono::nanoseconds stamp{};
  KidnapKind kind = KidnapKind::kCarry;
  Pose2 T_map_base;  ///< True pose of base.
};

/// The robot recovered from not getting on, or stopped short.
struct DriveRecord {
  std::chrono::nanoseconds stamp{};
  std::string what;  ///< "wait", "re-plan", "back up", "spin" or "emergency stop".
  Pose2 T_map_base;  ///< True pose of base.
};

/// One delivery. A scan is delivered at the time of its last beam.
struct SimFrame {
  std::chrono::nanoseconds stamp{};
  std::variant<KidnapRecord, OdometryReading, LidarReading, PersonHit, FaultRecord, PickUpRecord,
               DriveRecord>
      data;
};

/// A run of the simulator. Same configuration, same streams: same frames, to the bit.
class Simulation {
 public:
  /// Time spent by this thread, for `cpu_by_stage`; may be empty. Never influences a frame.
  using CpuClock = std::function<std::chrono::nanoseconds()>;

  /// @throws std::invalid_argument, std::runtime_error if the configuration cannot be run (start or
  /// kidnap target in collision, no free space).
  Simulation(SimulationConfig config, SimulationStreams streams, CpuClock cpu_clock = {});
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;
  ~Simulation();

  /// The next delivery, in order of stamps; at the same time kidnap, odometry, scan, person hit,
  /// pick-up, driving.
  /// Nothing once the run's duration is over.
  /// @throws std::runtime_error if a kidnap is impossible where the robot is.
  std::optional<SimFrame> next();
  /// What the driving localizer believes; without a pose the robot stops. Ignored unless
  /// `DriveConfig::by_estimate`.
  void set_drive_pose(const std::optional<Pose2>& T_map_base);

  /// The output of the localizer that kidnaps on being localized go by; nothing while it has none
  /// or says it is lost.
  void set_watched_pose(const std::optional<Pose2>& T_map_base);

  /// True pose of base at the start of the run.
  [[nodiscard]] Pose2 start_pose() const;
  /// True pose of base now.
  [[nodiscard]] Pose2 true_pose() const;
  /// Pose of base now over its planar pose (base_footprint of REP-120): height, roll and pitch.
  [[nodiscard]] Eigen::Isometry3d T_footprint_base() const;
  /// The velocity that the robot was last commanded.
  [[nodiscard]] Twist2 commanded() const;
  /// Its wheels now.
  [[nodiscard]] WheelAngles wheels() const;
  /// Contacts of the robot with the world begun so far, floor and people aside.
  [[nodiscard]] std::int64_t collisions() const;
  /// Why the run is void, were it to end now; nothing: it is not.
  [[nodiscard]] std::optional<VoidRecord> void_record() const;
  /// Way driven by the base so far, kidnaps aside. [m]
  [[nodiscard]] double distance_driven() const;
  /// The people as they are now, by their bodies and states; none: empty.
  [[nodiscard]] std::vector<std::pair<PersonBody, PersonState>> people() const;
  /// CPU time by stage: "physics", "lidar", "drive", "people"; empty without a clock.
  [[nodiscard]] std::map<std::string, std::chrono::nanoseconds> cpu_by_stage() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace castaway::sim
