/// Kidnaps in a simulated run: their times, their targets, and the robot while it is held.
#pragma once

#include <chrono>
#include <deque>
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

/// Input of a step. On levels, its pose and those of `KidnapOutcome` are in frame plane.
struct KidnapInput {
  std::chrono::nanoseconds now{};
  Pose2 T_map_base;        ///< True pose of base.
  double driven = 0.0;     ///< [m] Since the start.
  bool localized = false;  ///< As in `TriggerInput`.
  /// Returns the positions of people in map [m]; called when a place is chosen.
  std::function<std::vector<Eigen::Vector2d>()> people;
};

/// Result of a step.
struct KidnapOutcome {
  std::optional<PickUp> picked_up;   ///< The robot has just been lifted.
  std::optional<KidnapRecord> done;  ///< The robot stands at `T_map_to` from now on.
};

/// Runs the kidnaps of a run, one at a time: others wait while the robot is held, and a kidnap that
/// has no target right now is tried again at the next step.
class KidnapStage {
 public:
  /// `scene` must outlive this. @throws std::invalid_argument, std::runtime_error if a kidnap is
  /// impossible: wrong values, a given target in collision, or no named streams for random times.
  KidnapStage(const SimulationConfig& config, Spaces& spaces, const RayScene& scene,
              const NamedStreams& streams);

  /// Adds a kidnap; the robot is at `T_map_base`. @throws as the constructor.
  void add(const KidnapSpec& spec, const Pose2& T_map_base);

  /// Targets are drawn in another world from now on; `spaces` are its own. What `scene` refers to
  /// has changed, too. A robot that is held goes on to where it was meant to go.
  void set_world(const SimulationConfig& config, Spaces& spaces);

  /// Advances to `input.now`. @throws std::runtime_error as `kidnap_target`.
  KidnapOutcome advance(const KidnapInput& input, Rng& rng);

  /// True while the robot is held.
  [[nodiscard]] bool holds() const { return held_ != nullptr; }
  /// While the robot is held: its pose of base at a time, the motion of its wheels, whether its
  /// lidars are covered, and whether it is switched off.
  [[nodiscard]] Eigen::Isometry3d held_at(std::chrono::nanoseconds stamp) const;
  [[nodiscard]] HeldWheels wheels() const { return held_->spec->lift.wheels; }
  [[nodiscard]] bool covered() const { return holds() && held_->spec->lift.covered; }
  [[nodiscard]] bool is_off() const { return holds() && held_->spec->power_cycle; }
  /// True if the last finished kidnap was a power cycle.
  [[nodiscard]] bool was_power_cycle() const { return power_cycle_; }

 private:
  struct Entry {
    KidnapSpec spec;
    KidnapClock clock;
    double radius;                              ///< [m] Of the robot and the kidnap's margin.
    std::unique_ptr<LookAlikes> look_alikes{};  ///< Built on first use.
  };
  struct Held {
    const KidnapSpec* spec;
    KidnapRecord record;
    Lift lift;
  };

  KidnapOutcome finish(std::chrono::nanoseconds now);
  KidnapOutcome begin(Entry& entry, const KidnapInput& input, Rng& rng);
  KidnapOutcome begin_lift(const Entry& entry, const KidnapInput& input,
                           const KidnapTarget& target);
  [[nodiscard]] LiftWay way_of(const Entry& entry, const Pose2& from, const Pose2& to) const;
  const LookAlikes* look_alikes_of(Entry& entry);

  std::function<FreeSpace(double radius)> landing_;  ///< Where a body of this radius can be put.
  double footprint_;                                 ///< [m] Radius of the robot.
  NamedStreams streams_;
  const RayScene* scene_;
  LidarConfig lidar_;
  double keep_clear_;  ///< [m] Least distance between the centres of robot and people.
  std::map<double, FreeSpace> spaces_;    ///< By radius; shared, since a large map's takes 200 MB.
  std::optional<FreeSpace> carry_space_;  ///< Free space for the paths of all carried robots.
  std::deque<Entry> entries_;  ///< A deque: the kidnap that holds the robot is one of them.
  std::unique_ptr<Held> held_;
  bool power_cycle_ = false;
};

}  // namespace castaway::sim
