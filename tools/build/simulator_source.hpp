/// The simulator as a source of sensor data.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "sim/scene/scene.hpp"
#include "sim/simulation.hpp"
#include "tools/build/sim_conversion.hpp"
#include "tools/ros/bag_drive.hpp"
#include "tools/run/sensor_source.hpp"
#include "tools/scenario/sections/scenario.hpp"

namespace castaway::testbed {

/// Random streams of a simulation, each derived by its own name.
sim::SimulationStreams simulation_streams(std::uint64_t seed);

/// Plays a simulation. Collisions become events; a void run ends with a "void" event.
class SimulatorSource final : public SensorSource {
 public:
  /// `lidars` are those that the simulation was configured with (`SimulationConfig::lidars`).
  SimulatorSource(sim::Simulation simulation, std::vector<sim::LidarConfig> lidars, Stamp duration);

  std::optional<Frame> next() override;
  void set_drive_pose(const std::optional<SE2>& T_map_base) override;
  void set_watched_pose(const std::optional<SE2>& T_map_base, double z) override;
  void set_velocity(const BaseVelocity& velocity) override {
    set_command(sim::Twist2{velocity.v, velocity.w});
  }
  [[nodiscard]] std::optional<SE2> start_pose() const override;
  [[nodiscard]] Stamp duration() const override { return duration_; }
  [[nodiscard]] std::map<std::string, std::chrono::nanoseconds> cpu_by_stage() const override;
  [[nodiscard]] std::vector<std::string> warnings() const override { return warnings_; }
  /// Sets the beginning of the run; earlier data is discarded, and so are scans that began earlier.
  void begin_at(Stamp stamp) { begin_ = stamp; }
  /// Ends the run after this driven distance [m], kidnaps excluded; 0: no limit.
  void stop_after(double metres) { stop_after_ = metres; }
  /// From now on, scans and odometry include height, roll and pitch of base.
  void keep_heights() { converter_.keep_heights(); }
  /// [m] Height of the ground at the start.
  [[nodiscard]] double start_height() const { return simulation_.start_height(); }
  /// From now on, scans include their point clouds.
  void keep_clouds() { converter_.keep_clouds(); }
  /// Drive and kidnap the robot from outside, as those of sim::Simulation do.
  void set_command(const std::optional<sim::Twist2>& command) { simulation_.set_command(command); }
  void kidnap(const SE2& T_map_base) { simulation_.kidnap(to_pose2(T_map_base)); }
  /// Add an event, as those of sim::Simulation do; its configuration must be open.
  void add(const sim::EventSpec& event) { simulation_.add(event); }
  /// The world as it is now.
  [[nodiscard]] const sim::WorldSpec& world() const { return simulation_.world(); }
  /// Time of the next step, and the true pose of base then.
  [[nodiscard]] Stamp now() const { return simulation_.now(); }
  [[nodiscard]] SE2 true_pose() const { return to_se2(simulation_.true_pose()); }
  /// Current command and wheel states, up to one physics step after the newest frame.
  [[nodiscard]] DriveNow drive_now(const std::vector<sim::DriveWheel>& wheels) const;
  /// Current height, roll and pitch of base, for pictures.
  [[nodiscard]] Eigen::Isometry3d T_footprint_base() const {
    return simulation_.T_footprint_base();
  }
  /// Current people, for pictures.
  [[nodiscard]] std::vector<sim::SceneItem> people_items() const;
  /// Their bodies, by number.
  [[nodiscard]] std::vector<sim::PersonBody> people_bodies() const;

 private:
  std::optional<Frame> next_of_all();
  void take_next();
  void add_event(EventData what, const sim::Pose2& pose, std::optional<Stamp> since = {});
  void note(const sim::KidnapRecord& kidnap);
  void finish();

  sim::Simulation simulation_;
  SimFrameConverter converter_;
  double stop_after_ = 0.0;
  Stamp begin_{};
  Stamp duration_;
  std::int64_t collisions_ = 0;
  std::deque<Frame> pending_;
  std::vector<std::string> warnings_;
  Stamp newest_{};     ///< Stamp of the last frame.
  bool over_ = false;  ///< All frames were delivered.
};

/// The source of a scenario whose simulation is configured. Throws as sim::Simulation.
std::unique_ptr<SimulatorSource> build_source(const Scenario& scenario,
                                              sim::SimulationConfig config);

}  // namespace castaway::testbed
