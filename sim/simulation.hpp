/// The simulator: a robot in a world, and what its sensors deliver.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/common/geometry.hpp"
#include "sim/people/bodies/person.hpp"
#include "sim/stages/progress_watch.hpp"
#include "sim/stages/sim_frame.hpp"
#include "sim/stages/simulation_config.hpp"

namespace castaway::sim {

/// A run of the simulator. The same configuration and streams give bit-identical frames.
class Simulation {
 public:
  /// Returns the CPU time of this thread, for `cpu_by_stage`; may be empty. Never influences a
  /// frame.
  using CpuClock = std::function<std::chrono::nanoseconds()>;

  /// @throws std::invalid_argument, std::runtime_error if the configuration is impossible (start or
  /// kidnap target in collision, no free space).
  Simulation(SimulationConfig config, SimulationStreams streams, CpuClock cpu_clock = {});
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;
  ~Simulation();

  /// Returns the next delivery, in order of stamps; at the same time in the order kidnap, odometry,
  /// scan, person hit, fault, pick-up, driving, change of the world, IMU. Returns nothing once the
  /// run's duration is over.
  /// @throws std::runtime_error if a kidnap is impossible where the robot is.
  std::optional<SimFrame> next();
  /// Sets the driving localizer's estimate; without a pose the robot stops. Ignored unless
  /// `DriveConfig::by_estimate`.
  void set_drive_pose(const std::optional<Pose2>& T_map_base);

  /// Sets the output of the localizer that `KidnapTrigger::On::kLocalized` watches; nothing while
  /// it has none or reports to be lost. `z` [m]: height of the ground there.
  void set_watched_pose(const std::optional<Pose2>& T_map_base, double z = 0.0);

  /// Drives the robot by this velocity from the next control step (20 Hz) on, in place of its
  /// route; nothing: by its route again. A robot that is driven so is never stuck (`void_record`).
  void set_command(const std::optional<Twist2>& command);
  /// Adds an event to a run that is open (`SimulationConfig::open`), as if it had been configured;
  /// an event whose time is over takes place at the next step. A change of the world for which
  /// there is no room right now is impossible. @throws std::invalid_argument, std::runtime_error if
  /// it is impossible, std::logic_error if the run is not open.
  void add(const EventSpec& event);
  /// Time of the next step.
  [[nodiscard]] std::chrono::nanoseconds now() const;

  /// Teleports the robot at the next step; if it is being held, once it stands again. On levels, to
  /// the ground nearest in height.
  /// @throws std::invalid_argument if it would stand in an obstacle, or on a recorded path.
  void kidnap(const Pose2& T_map_base);

  /// The world as it is now.
  [[nodiscard]] const WorldSpec& world() const;
  /// True pose of base at the start of the run, and the height of the ground there. [m]
  [[nodiscard]] Pose2 start_pose() const;
  [[nodiscard]] double start_height() const;
  /// True pose of base now.
  [[nodiscard]] Pose2 true_pose() const;
  /// Pose of base relative to its planar pose (base_footprint of REP-120): height, roll and pitch.
  [[nodiscard]] Eigen::Isometry3d T_footprint_base() const;
  /// The last commanded velocity.
  [[nodiscard]] Twist2 last_command() const;
  /// Current wheel angles.
  [[nodiscard]] WheelAngles wheels() const;
  /// Contacts with the world begun so far, without floor and people.
  [[nodiscard]] std::int64_t collisions() const;
  /// Returns why the run is void if it ends now; nothing if it is not.
  [[nodiscard]] std::optional<VoidRecord> void_record() const;
  /// Distance driven by base so far, without kidnaps. [m]
  [[nodiscard]] double distance_driven() const;
  /// Bodies and current states of all people; empty without people.
  [[nodiscard]] std::vector<std::pair<PersonBody, PersonState>> people() const;
  /// CPU time by stage: "physics", "lidar", "drive", "people"; empty without a clock. The first two
  /// are seven times what one of seven steps took.
  [[nodiscard]] std::map<std::string, std::chrono::nanoseconds> cpu_by_stage() const;

  /// What the stages of a step share (sim/steps.hpp).
  struct State;

 private:
  void make_step();

  std::unique_ptr<State> state_;
  CpuClock cpu_clock_;
  std::map<std::string, std::chrono::nanoseconds> cpu_;
};

}  // namespace castaway::sim
