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
#include <vector>

#include "sim/common/geometry.hpp"
#include "sim/people/bodies/person.hpp"
#include "sim/stages/progress_watch.hpp"
#include "sim/stages/sim_frame.hpp"
#include "sim/stages/simulation_config.hpp"

namespace castaway::sim {

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
