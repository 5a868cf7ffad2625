/// Random kidnaps in one world: each a short simulation, drawn by its number.
#pragma once

#include <cstdint>
#include <string>

#include "sim/map/free_space.hpp"
#include "tools/sources/build_simulation.hpp"

namespace castaway::testbed {

/// What a trial is made of.
struct KidnapTrialConfig {
  std::string world = "lab";    ///< A world's name or path, a ROS map's .yaml, or "office".
  double lead_s = 2.5;          ///< [s] Driven before the kidnap, give or take half a second.
  double window_s = 15.0;       ///< [s] Driven on after it.
  double min_distance_m = 3.0;  ///< [m] From where the robot was.
  double near_m = 0.6;          ///< [m] Obstacles stand so far from where it comes to, at least...
  double far_m = 4.0;           ///< [m] ...and at most.
  std::uint64_t seed = 1;
};

/// Throws std::invalid_argument where a figure is out of its range.
void validate(const KidnapTrialConfig& config);

/// One kidnap, ready to be played.
struct KidnapTrial {
  sim::SimulationConfig simulation;
  std::uint64_t seed = 0;  ///< Of the simulation and the localizers.
};

/// Draws trials. A trial depends on the seed, its number and its obstacles only; with other
/// obstacles it has the same start, noise and, unless there is no room for them, target.
class KidnapTrials {
 public:
  /// Loads world and robot (TurtleBot3 Waffle with a lidar of 12 m and 10 Hz). Throws
  /// std::runtime_error or std::invalid_argument naming what is wrong.
  explicit KidnapTrials(const KidnapTrialConfig& config);

  /// Trial `index` with so many people about: cylinders of 0.25 m radius and 1.8 m height that are
  /// on no map. Throws std::runtime_error if there is no place with room for them.
  [[nodiscard]] KidnapTrial draw(int index, int obstacles) const;
  /// What the localizers are given.
  [[nodiscard]] const RosMap& map() const { return prepared_.map; }

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
