/// The state of a simulated run, which the stages of a step share; for `Simulation` alone.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "sim/common/geometry.hpp"
#include "sim/map/level_plane.hpp"
#include "sim/robot/sim_robot.hpp"
#include "sim/simulation.hpp"
#include "sim/stages/drive_setup.hpp"
#include "sim/stages/drive_stage.hpp"
#include "sim/stages/kidnap_stage.hpp"
#include "sim/stages/people_stage.hpp"
#include "sim/stages/sensor_stage.hpp"
#include "sim/stages/spaces.hpp"
#include "sim/stages/world_stage.hpp"

namespace castaway::sim {

/// Follows the robot from floor to floor. Without floors, frame plane is map.
class PlaneTracker {
 public:
  explicit PlaneTracker(std::shared_ptr<const LevelPlane> plane) : plane_(std::move(plane)) {}

  /// T_plane_base; where there is no ground, in the chart of the last call.
  Pose2 locate(const Eigen::Isometry3d& T_map_base) {
    const Pose2 planar = to_planar(T_map_base);
    if (!plane_) return planar;
    const auto found = plane_->on_plane(planar, T_map_base.translation().z());
    if (found) shift_ = found->y - planar.y;
    return {planar.x, planar.y + shift_, planar.yaw};
  }

  /// T_map_base of a pose in the plane.
  [[nodiscard]] Pose2 in_map(const Pose2& T_plane_base) const {
    return plane_ ? plane_->in_map(T_plane_base) : T_plane_base;
  }
  /// [m] Height of the ground at a pose in the plane.
  [[nodiscard]] double height_at(const Pose2& T_plane_base) const {
    return plane_ ? plane_->p_map(T_plane_base.position()).z() : 0.0;
  }
  /// T_map_base of a base that stands at a pose in the plane.
  [[nodiscard]] Eigen::Isometry3d standing_at(const Pose2& T_plane_base) const {
    return plane_ ? plane_->standing_at(T_plane_base) : to_isometry(T_plane_base);
  }
  [[nodiscard]] const LevelPlane* levels() const { return plane_.get(); }

 private:
  std::shared_ptr<const LevelPlane> plane_;
  double shift_ = 0.0;  ///< [m] Along y from map to the chart.
};

/// What the stages of a step share. Time advances by physics steps [now, now + step).
struct Simulation::State {
  State(SimulationConfig configuration, SimulationStreams random_streams);

  /// T_plane_base, and T_map_base in the plane.
  Pose2 T_plane_base() { return plane.locate(robot.state().T_map_base); }
  [[nodiscard]] Pose2 T_map_base() const { return to_planar(robot.state().T_map_base); }
  /// Delivers that something happened now.
  void tell(Happening what, const Pose2& T_map_base) {
    frames.push_back({now, HappeningRecord{now, std::move(what), T_map_base}});
  }

  SimulationConfig config;
  SimulationStreams streams;

  std::chrono::nanoseconds step;
  std::chrono::nanoseconds now{};
  std::int64_t steps = 0;  ///< Made so far.
  Twist2 commanded;

  std::shared_ptr<Spaces> spaces;
  PlaneTracker plane;
  Pose2 start;  ///< On levels, in frame plane.
  SimRobot robot;
  SensorStage sensors;
  KidnapStage kidnaps;
  DriveStage drive;
  PeopleStage people;
  ProgressWatch progress;
  WorldStage changes;
  Motion motion{};                                     ///< Of base, in the step.
  WheelAngles wheels_before;                           ///< At the begin of the step.
  bool moved = false;                                  ///< By a kidnap, since the last step.
  bool changed = false;                                ///< The world is not the one of the start.
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< [m/s] Of base in map.
  std::optional<Pose2> watched;
  double watched_z = 0.0;          ///< [m]
  std::size_t next_command = 0;    ///< In `config.events.commands`.
  std::optional<Pose2> requested;  ///< Target of a kidnap that is due at the next step.
  double distance = 0.0;
  std::vector<SimFrame> noted;  ///< Changes of the world, to be delivered with the next step.
  std::deque<SimFrame> frames;
};

}  // namespace castaway::sim
