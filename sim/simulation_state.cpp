#include "sim/simulation_state.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/stages/drive_space.hpp"

namespace castaway::sim {
namespace {

using std::chrono::nanoseconds;

nanoseconds period_of(double hz, const char* what) {
  if (!(hz > 0.0) || hz > 1e5) {
    throw std::invalid_argument(fmt::format("simulation: {} is {}: give 0 to 100000", what, hz));
  }
  return nanoseconds(std::llround(1e9 / hz));
}

SimRobot make_robot(const SimulationConfig& config, Spaces& spaces, const Pose2& start,
                    nanoseconds step) {
  if (!config.drive.path.empty()) {
    return SimRobot(PathRobot(config.robot, config.drive.path, step));
  }
  const TwistLimits limits = limits_of(config.drive, config.robot);
  if (config.drive_model == DriveModel::kPhysics) {
    return SimRobot(RobotPhysics(config.world, config.robot, start, limits, step));
  }
  return SimRobot(KinematicRobot(config.robot, spaces.driving(config, standing_radius(config)),
                                 start, limits, step));
}

/// What is planned for on one floor only.
void require_level_support(const SimulationConfig& config) {
  const auto refuse = [](const char* what) {
    throw std::invalid_argument(fmt::format("a world with `levels: true` has {}", what));
  };
  if (config.people.blocked_share > 0.0) refuse("no crowds yet: leave people.crowd out");
  if (config.drive.by_estimate) refuse("no navigation by estimates yet: set drive.by to truth");
  if (!config.drive.path.empty()) refuse("no recorded paths: give a route");
  if (config.drive_model == DriveModel::kKinematic) refuse("no kinematic robots: use physics");
  if (!config.events.changes.empty()) refuse("no changes of the world yet: remove these events");
}

}  // namespace

Simulation::State::State(SimulationConfig configuration, SimulationStreams random_streams)
    : config(std::move(configuration)),
      streams(std::move(random_streams)),
      step(period_of(config.physics_hz, "physics_hz")),
      spaces(config.spaces ? config.spaces : std::make_shared<Spaces>()),
      plane(config.levels),
      start(castaway::sim::start_pose(config, *spaces, streams.events)),
      robot(make_robot(config, *spaces, start, step)),
      sensors(config, streams),
      kidnaps(config, *spaces, sensors.scene(), streams.named),
      drive(config, *spaces),
      people(config, *spaces, start, streams.named),
      progress(progress_of(config.drive, config.robot)),
      changes(config.world, config.events.changes) {
  if (!config.levels) return;
  require_level_support(config);
  robot.place(plane.standing_at(start));
}

}  // namespace castaway::sim
