/// The simulator as a source of sensor data. The one place where poses, scans and maps of `sim` and
/// `localization` are turned into each other.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "localization/map/occupancy_grid.hpp"
#include "sim/scene/scene.hpp"
#include "sim/simulation.hpp"
#include "sim/stages/sensor_stage.hpp"
#include "tools/formats/ros_map.hpp"
#include "tools/ros/bag_drive.hpp"
#include "tools/run/sensor_source.hpp"

namespace castaway::testbed {

/// Planar pose of the simulator as a transform of the localizers, and back.
SE2 to_se2(const sim::Pose2& pose);
sim::Pose2 to_pose2(const SE2& pose);

/// A grid of the simulator as a ROS map, and back.
RosMap to_ros_map(const sim::Grid& grid, const std::string& name);
sim::Grid to_sim_grid(const RosMap& map);

/// The streams of a simulation, each by its own name.
sim::SimulationStreams simulation_streams(std::uint64_t seed);

/// Plays a simulation. Collisions become events; a run that is void ends with a "void" event.
class SimulatorSource final : public SensorSource {
 public:
  /// `lidars` are those that the simulation was configured with (`SimulationConfig::lidars`).
  SimulatorSource(sim::Simulation simulation, std::vector<sim::LidarConfig> lidars, Stamp duration);

  std::optional<Frame> next() override;
  void set_drive_pose(const std::optional<SE2>& T_map_base) override;
  void set_watched_pose(const std::optional<SE2>& T_map_base) override;
  [[nodiscard]] std::optional<SE2> start_pose() const override;
  [[nodiscard]] Stamp duration() const override { return duration_; }
  [[nodiscard]] std::map<std::string, std::chrono::nanoseconds> cpu_by_stage() const override;
  [[nodiscard]] std::vector<std::string> warnings() const override { return warnings_; }
  /// The run begins then: what is delivered before, or began before, is left out.
  void begin_at(Stamp stamp) { begin_ = stamp; }
  /// The run ends once so much is driven, kidnaps aside; 0: it does not. [m]
  void stop_after(double metres) { stop_after_ = metres; }
  /// From now on scans bring their points in space.
  void keep_clouds() { clouds_ = true; }
  /// Command and wheels as they are now: up to a step of physics after the newest frame.
  [[nodiscard]] DriveNow drive_now(const std::vector<sim::DriveWheel>& wheels) const;
  /// Height, roll and pitch of base as they are now, for pictures.
  [[nodiscard]] Eigen::Isometry3d T_footprint_base() const {
    return simulation_.T_footprint_base();
  }
  /// The people as they are now, for pictures.
  [[nodiscard]] std::vector<sim::SceneItem> people_items() const;

 private:
  std::optional<Frame> next_of_all();
  void take_next();
  void tell(EventKind kind, const std::string& detail, const sim::Pose2& pose,
            std::optional<Stamp> since = {});
  void note(const sim::KidnapRecord& kidnap);
  void finish();
  [[nodiscard]] Frame convert(const sim::SimFrame& frame) const;
  [[nodiscard]] ScanFrame convert(const sim::LidarReading& reading) const;

  sim::Simulation simulation_;
  std::vector<sim::LidarConfig> lidars_;
  bool clouds_ = false;
  double stop_after_ = 0.0;
  Stamp begin_{};
  Stamp duration_;
  std::int64_t collisions_ = 0;
  std::deque<Frame> pending_;
  std::vector<std::string> warnings_;
  Stamp newest_{};     ///< Of the last frame.
  bool over_ = false;  ///< All frames are out.
};

}  // namespace castaway::testbed
