/// What a simulation consists of; for `Simulation` alone.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/robot/sim_robot.hpp"
#include "sim/simulation.hpp"
#include "sim/stages/drive_setup.hpp"
#include "sim/stages/drive_stage.hpp"
#include "sim/stages/kidnap_stage.hpp"
#include "sim/stages/people_stage.hpp"
#include "sim/stages/plane_tracker.hpp"
#include "sim/stages/sensor_stage.hpp"
#include "sim/stages/spaces.hpp"
#include "sim/stages/world_stage.hpp"

namespace castaway::sim {

/// Time advances by physics steps [now, now + step). Each step starts with kidnaps, people and
/// control; then physics advances, and the sensors deliver the readings due within the step.
struct Simulation::State {
  State(SimulationConfig configuration, SimulationStreams random_streams, CpuClock clock);

  void run_step();
  void kidnap();
  void kidnap_on_request();
  void take_commands();
  void change_world();
  bool make(const WorldChange& change);
  void take_new_world();
  void find_ways();
  [[nodiscard]] bool has_room(const WorldChange& change) const;
  void require_open() const;
  void teleport(KidnapRecord record);
  void require_level_support() const;
  [[nodiscard]] bool localized() const;
  void move_people();
  void command();
  void move_robot();
  void deliver(const std::vector<OdometryReading>& readings);
  void deliver(std::vector<SimFrame> scans);
  void read_imu(const Motion& motion);
  void read_lidar(const Motion& motion);
  template <typename Work>
  void measure_cpu(const char* stage, Work work, int times = 1);
  template <typename Work>
  void sample_cpu(const char* stage, Work work);

  SimulationConfig config;
  SimulationStreams streams;
  CpuClock cpu_clock;
  std::map<std::string, std::chrono::nanoseconds> cpu;

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
  bool moved = false;                                  ///< By a kidnap, since the last step.
  bool changed = false;                                ///< The world is not the one of the start.
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< [m/s] Of base in map.
  std::optional<Pose2> watched;
  double watched_z = 0.0;          ///< [m]
  std::size_t next_command = 0;    ///< In `config.commands`.
  std::optional<Pose2> requested;  ///< Target of a kidnap that is due at the next step.
  double distance = 0.0;
  std::vector<SimFrame> noted;  ///< Changes of the world, to be delivered with the next step.
  std::deque<SimFrame> frames;
};

}  // namespace castaway::sim
