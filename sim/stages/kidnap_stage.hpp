/// Kidnaps in a simulated run: when they come, where they go, and the robot in somebody's hands.
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "sim/casting/ray_scene.hpp"
#include "sim/events/kidnap_target.hpp"
#include "sim/events/look_alike.hpp"
#include "sim/robot/sim_robot.hpp"
#include "sim/stages/sim_frame.hpp"
#include "sim/stages/simulation_config.hpp"

namespace castaway::sim {

/// What kidnaps go by at a step.
struct KidnapInput {
  std::chrono::nanoseconds now{};
  Pose2 T_map_base;        ///< True pose of base.
  double driven = 0.0;     ///< [m] Since the start.
  bool localized = false;  ///< As in `TriggerInput`.
  /// Where people are, in map [m]; asked for when a place is chosen.
  std::function<std::vector<Eigen::Vector2d>()> people;
};

/// Where a kidnap leaves the robot within a step.
struct KidnapOutcome {
  std::optional<PickUpRecord> picked_up;  ///< It was lifted just now.
  std::optional<KidnapRecord> done;       ///< It stands where `T_map_to` says from now on.
};

/// The kidnaps of a run on its clock. One at a time: while the robot is held, others wait, and one
/// that has no place to go to right now is tried again at the next step.
class KidnapStage {
 public:
  /// `scene` must outlive it. @throws std::invalid_argument, std::runtime_error if a kidnap cannot
  /// be: its values, a given target in collision, no named streams for one at random times.
  KidnapStage(const SimulationConfig& config, const Grid& drive_grid, const RayScene& scene,
              const NamedStreams& streams);

  /// What happens at `input.now`. @throws std::runtime_error as `kidnap_target`.
  KidnapOutcome advance(const KidnapInput& input, Rng& rng);

  /// True while the robot is in somebody's hands.
  [[nodiscard]] bool holds() const { return held_ != nullptr; }
  /// While it is: pose of base at a time, what the wheels do, whether lidars are covered, whether
  /// the robot is switched off.
  [[nodiscard]] Eigen::Isometry3d held_at(std::chrono::nanoseconds stamp) const;
  [[nodiscard]] HeldWheels wheels() const { return held_->spec->lift.wheels; }
  [[nodiscard]] bool covered() const { return holds() && held_->spec->lift.covered; }
  [[nodiscard]] bool is_off() const { return holds() && held_->spec->power_cycle; }
  /// True if the last kidnap done was a power cycle.
  [[nodiscard]] bool was_power_cycle() const { return power_cycle_; }

 private:
  struct Entry {
    KidnapSpec spec;
    KidnapClock clock;
    double radius;                              ///< [m] Of the robot and the kidnap's margin.
    std::unique_ptr<LookAlikes> look_alikes{};  ///< Made when first needed.
  };
  struct Held {
    const KidnapSpec* spec;
    KidnapRecord record;
    Lift lift;
  };

  KidnapOutcome finish(std::chrono::nanoseconds now);
  KidnapOutcome begin(Entry& entry, const KidnapInput& input, Rng& rng);
  KidnapOutcome lifted(const Entry& entry, const KidnapInput& input, const KidnapTarget& target);
  const LookAlikes* look_alikes_of(Entry& entry);

  const RayScene* scene_;
  LidarConfig lidar_;
  double keep_clear_;                     ///< [m] Between people's middles and the robot's.
  std::map<double, FreeSpace> spaces_;    ///< By radius: a large map's takes 200 MB.
  std::optional<FreeSpace> carry_space_;  ///< Where any kidnap carries.
  std::vector<Entry> entries_;
  std::unique_ptr<Held> held_;
  bool power_cycle_ = false;
};

}  // namespace castaway::sim
