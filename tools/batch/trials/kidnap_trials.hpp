/// Draws random kidnap trials in one world; each trial is a short simulation.
#pragma once

#include <cstdint>
#include <string>

#include "sim/map/free_space.hpp"
#include "tools/build/build_simulation.hpp"
#include "tools/build/foreign/lidar_facts.hpp"

namespace castaway::testbed {

/// Parameters of the trials.
struct KidnapTrialConfig {
  std::string world = "lab";  ///< A world's name or path, a ROS map's .yaml, or "office".
  double lead_s = 2.5;        ///< [s] Driving time before the kidnap, plus or minus half a
                              ///< second.
  double window_s = 15.0;     ///< [s] Driving time after the kidnap.
  sim::KidnapKind kind = sim::KidnapKind::kTeleportRandom;  ///< Or look-alike, nudge, turn.
  double min_distance_m = 3.0;  ///< [m] Least distance of a kidnap to a random or look-alike place.
  /// Profile of the lidar; "robot": that of the Waffle with a range of 12 m, 10 Hz.
  std::string lidar = "robot";
  std::optional<double> range_max{};  ///< [m] Replaces the lidar's.
  std::optional<double> fov_deg{};    ///< [deg] Replaces the lidar's.
  double near_m = 0.6;  ///< [m] Least distance of the obstacles from the kidnap's target.
  double far_m = 4.0;   ///< [m] Greatest distance of the obstacles from the kidnap's
                        ///< target.
  std::uint64_t seed = 1;
};

/// Throws std::invalid_argument if a value is out of range.
void validate(const KidnapTrialConfig& config);

/// One kidnap, ready to be simulated.
struct KidnapTrial {
  sim::SimulationConfig simulation;
  std::uint64_t seed = 0;  ///< Seed of the simulation and of the localizers.
};

/// Draws trials. A trial depends only on the seed, its index and the number of obstacles. Trials
/// that differ only in the number of obstacles have the same start and noise, and the same target
/// unless there is no room for the obstacles around it.
class KidnapTrials {
 public:
  /// Loads world and robot, a TurtleBot3 Waffle. Throws
  /// std::runtime_error or std::invalid_argument naming what is wrong.
  explicit KidnapTrials(const KidnapTrialConfig& config);

  /// Draws trial `index` with `obstacles` people (only around teleports): cylinders of 0.25 m
  /// radius and 1.8 m height that are on no map. Throws std::runtime_error if there is no place
  /// with room for them.
  [[nodiscard]] KidnapTrial draw(int index, int obstacles) const;
  /// Map that is given to the localizers.
  [[nodiscard]] const RosMap& map() const { return prepared_.map; }
  /// The lidars of the robot.
  [[nodiscard]] std::vector<LidarFacts> lidars() const;

 private:
  [[nodiscard]] sim::KidnapSpec draw_kidnap(sim::Rng& rng, const sim::Pose2& start) const;
  [[nodiscard]] bool add_people(int count, sim::Rng& rng, sim::SimulationConfig& config) const;
  [[nodiscard]] std::vector<Eigen::Vector2d> draw_people(int count, sim::Rng& rng,
                                                         const sim::SimulationConfig& config) const;

  KidnapTrialConfig config_;
  PreparedSimulation prepared_;
  sim::FreeSpace robot_space_;
  sim::FreeSpace person_space_;
};

}  // namespace castaway::testbed
