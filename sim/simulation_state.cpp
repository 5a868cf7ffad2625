#include "sim/simulation_state.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/common/seconds.hpp"
#include "sim/stages/drive_space.hpp"

namespace castaway::sim {
namespace {

using std::chrono::nanoseconds;

// [m] A localizer's output nearer to the true pose is right.
constexpr double kRightPosition = 0.5;
constexpr double kRightYaw = 0.35;  // [rad] The same for its heading.
// Stages of every step are timed in one of so many: reading the clock takes as long as some of
// them. A prime, so that no period of a sensor is a multiple of it.
constexpr int kTimedOf = 7;

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

std::size_t index_of_happening(const SimFrame& frame) {
  const auto* record = std::get_if<HappeningRecord>(&frame.data);
  return record != nullptr ? record->what.index() : 0;
}

/// Orders deliveries by time, then by their kinds' order in `SimFrame` and in `Happening`.
bool earlier(const SimFrame& a, const SimFrame& b) {
  if (a.stamp != b.stamp) return a.stamp < b.stamp;
  if (a.data.index() != b.data.index()) return a.data.index() < b.data.index();
  return index_of_happening(a) < index_of_happening(b);
}

}  // namespace

Simulation::State::State(SimulationConfig configuration, SimulationStreams random_streams,
                         CpuClock clock)
    : config(std::move(configuration)),
      streams(std::move(random_streams)),
      cpu_clock(std::move(clock)),
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
  require_level_support();
  robot.place(plane.standing_at(start));
}

/// What is planned for on one floor only.
void Simulation::State::require_level_support() const {
  const auto refuse = [](const char* what) {
    throw std::invalid_argument(fmt::format("a world with `levels: true` has {}", what));
  };
  if (config.people.blocked_share > 0.0) refuse("no crowds yet: leave people.crowd out");
  if (config.drive.by_estimate) refuse("no navigation by estimates yet: set drive.by to truth");
  if (!config.drive.path.empty()) refuse("no recorded paths: give a route");
  if (config.drive_model == DriveModel::kKinematic) refuse("no kinematic robots: use physics");
  if (!config.events.changes.empty()) refuse("no changes of the world yet: remove these events");
}

template <typename Work>
void Simulation::State::measure_cpu(const char* stage, Work work, int times) {
  if (!cpu_clock) return work();
  const nanoseconds before = cpu_clock();
  work();
  cpu[stage] += times * (cpu_clock() - before);
}

/// For stages of every step.
template <typename Work>
void Simulation::State::sample_cpu(const char* stage, Work work) {
  if (steps % kTimedOf != 0) return work();
  measure_cpu(stage, work, kTimedOf);
}

void Simulation::State::tell(Happening what, const Pose2& T_map_base) {
  frames.push_back({now, HappeningRecord{now, std::move(what), T_map_base}});
}

bool Simulation::State::localized() const {
  if (!watched) return false;
  const Eigen::Isometry3d& T_map_base = robot.state().T_map_base;
  const Pose2 error = inverse(to_planar(T_map_base)) * *watched;
  const double above = plane.levels() != nullptr ? watched_z - T_map_base.translation().z() : 0.0;
  return std::hypot(error.position().norm(), above) < kRightPosition &&
         std::abs(error.yaw) < kRightYaw;
}

void Simulation::State::kidnap() {
  const auto positions = [this] { return people.positions(); };
  const Pose2 from = plane.locate(robot.state().T_map_base);
  const KidnapOutcome outcome =
      kidnaps.advance({now, from, distance, localized(), positions}, streams.events);
  if (outcome.done) {
    teleport(*outcome.done);
    if (kidnaps.was_power_cycle()) sensors.reset_odometry();
  }
  if (outcome.picked_up) tell(*outcome.picked_up, plane.in_map(from));
  if (!kidnaps.holds()) kidnap_on_request();
}

void Simulation::State::kidnap_on_request() {
  if (!requested) return;
  const Pose2 from = plane.locate(robot.state().T_map_base);
  teleport({now, KidnapKind::kTeleportTo, from, *requested, now});
  requested.reset();
}

/// Takes the record's poses in frame plane.
void Simulation::State::teleport(KidnapRecord record) {
  people.on_kidnap(record.T_map_to);
  moved = true;
  if (plane.levels() != nullptr) {
    robot.place(plane.standing_at(record.T_map_to));
    record.z_from = plane.height_at(record.T_map_from);
    record.z_to = plane.height_at(record.T_map_to);
    record.T_map_from = plane.in_map(record.T_map_from);
    record.T_map_to = plane.in_map(record.T_map_to);
  } else {
    robot.teleport(record.T_map_to);
  }
  if (changed) find_ways();
  progress.on_teleport();
  frames.push_back({now, record});
}

void Simulation::State::take_commands() {
  const std::vector<DriveCommand>& commands = config.events.commands;
  for (; next_command < commands.size() && commands[next_command].at_s <= to_seconds(now);
       ++next_command) {
    drive.set_command(commands[next_command].twist);
  }
}

/// True if no robot or person is where something solid or somebody comes.
bool Simulation::State::has_room(const WorldChange& change) const {
  const Pose2 T_map_base = to_planar(robot.state().T_map_base);
  if (const auto* arrival = std::get_if<AddPeople>(&change.what)) {
    return people.has_room(*arrival, T_map_base, config, *spaces);
  }
  const std::optional<WorldObject> solid = solid_of(change, config.world);
  if (!solid) return true;
  const Occupants occupants{T_map_base.position(), config.robot.footprint_radius,
                            people.positions()};
  return is_clear(*solid, occupants, config.map.resolution);
}

/// Finds the part of the free space in which the robot is.
void Simulation::State::find_ways() {
  const Eigen::Vector2d p_map = to_planar(robot.state().T_map_base).position();
  const auto part = [&](double radius) { return spaces->driving_around(config, radius, p_map); };
  robot.set_free([&] { return part(standing_radius(config)); });
  if (!config.drive.by_estimate) {
    drive.set_free(part(config.robot.footprint_radius + kDriveMargin));
  }
}

void Simulation::State::take_new_world() {
  changed = true;
  spaces = std::make_shared<Spaces>(WalkParts::kAll);
  robot.set_objects(config.world);
  sensors.set_world(config.world);
  kidnaps.set_world(config, *spaces);
  if (people.people() != nullptr) people.set_cells(spaces->walking(config.world, config.map));
  find_ways();
}

bool Simulation::State::make(const WorldChange& change) {
  if (!has_room(change)) return false;
  const Pose2 T_map_base = to_planar(robot.state().T_map_base);
  WorldNews news = news_of(change, config.world);
  if (const auto* arrival = std::get_if<AddPeople>(&change.what)) {
    people.add(*arrival, now, T_map_base, config, *spaces);
  } else {
    apply(change, config.world);
    take_new_world();
  }
  noted.push_back({now, HappeningRecord{now, std::move(news), T_map_base}});
  return true;
}

/// Nothing is put where a robot may be that is held in the air.
void Simulation::State::change_world() {
  if (kidnaps.holds() || !changes.due(now)) return;
  changes.advance(now, [this](const WorldChange& change) { return make(change); });
}

void Simulation::State::add(const KidnapSpec& kidnap) {
  kidnaps.add(kidnap, plane.locate(robot.state().T_map_base));
}

void Simulation::State::add(const FaultSpec& fault) { sensors.add(fault); }

void Simulation::State::add(const DriveCommand& command) {
  validate(command);
  std::vector<DriveCommand>& commands = config.events.commands;
  const auto to_come = commands.begin() + static_cast<std::ptrdiff_t>(next_command);
  commands.insert(
      std::ranges::upper_bound(to_come, commands.end(), command.at_s, {}, &DriveCommand::at_s),
      command);
}

void Simulation::State::add(const WorldChange& change) {
  validate(change);
  if (config.levels) {
    throw std::invalid_argument("a world with `levels: true` cannot change yet");
  }
  if (!has_room(change)) {
    throw std::invalid_argument("there is no room: robot or people are in the way");
  }
  changes.add(change, config.world);
  change_world();  // As the next step would: what is added next must have room beside it.
}

void Simulation::State::move_people() {
  if (!people.due(now)) return;
  // People walk on the lowest floor, whose chart is map; those of other floors are far from it.
  const Pose2 T_plane_base = plane.locate(robot.state().T_map_base);
  measure_cpu("people", [&] { people.advance(now, T_plane_base, velocity, sensors.scene()); });
  for (const int person : people.take_hits()) {
    tell(Collision{Collision::Person{person}}, plane.in_map(T_plane_base));
  }
}

void Simulation::State::command() {
  const Pose2 T_map_base = to_planar(robot.state().T_map_base);
  commanded = drive.command(now, plane.locate(robot.state().T_map_base), people);
  robot.set_command(commanded);
  progress.update({now, T_map_base, robot.touching(), drive.wants() && !kidnaps.holds(),
                   drive.waypoints_reached()});
  for (const Driving& event : drive.take_events()) tell(event, T_map_base);
}

void Simulation::State::move_robot() {
  if (kidnaps.holds()) {
    robot.step_held(kidnaps.held_at(now + step), kidnaps.wheels());
  } else {
    robot.step();
  }
}

/// A robot that is switched off delivers nothing.
void Simulation::State::deliver(const std::vector<OdometryReading>& readings) {
  if (kidnaps.is_off()) return;
  for (const OdometryReading& reading : readings) {
    drive.on_odometry(reading);
    frames.push_back({reading.stamp, reading});
  }
}

void Simulation::State::deliver(std::vector<SimFrame> scans) {
  if (kidnaps.is_off()) return;
  for (SimFrame& frame : scans) {
    const auto& scan = std::get<LidarReading>(frame.data);
    drive.on_scan(scan, sensors.lidars()[scan.lidar]);
    frames.push_back(std::move(frame));
  }
}

void Simulation::State::read_further_sensors(const Motion& motion) {
  std::vector<SimFrame> readings = sensors.read_further(motion, std::exchange(moved, false));
  if (kidnaps.is_off()) return;
  std::ranges::move(readings, std::back_inserter(frames));
}

void Simulation::State::read_lidar(const Motion& motion) {
  sensors.set_covered(kidnaps.covered());
  std::vector<SimFrame> scans = sensors.read_lidars(people.around(sensors.scene()), motion);
  for (SimFrame& frame : scans) {
    auto& reading = std::get<LidarReading>(frame.data);
    const Eigen::Isometry3d T_map_base =
        to_isometry(reading.T_map_base_true) * reading.T_footprint_base_true;
    reading.people = people.readings(
        reading.stamp, config.levels ? plane.locate(T_map_base) : reading.T_map_base_true);
  }
  deliver(std::move(scans));
}

void Simulation::State::run_step() {
  change_world();
  std::ranges::move(noted, std::back_inserter(frames));
  noted.clear();
  kidnap();
  take_commands();
  move_people();
  const RobotState before = robot.state();
  if (drive.due(now)) measure_cpu("drive", [this] { command(); });
  sample_cpu("physics", [this] { move_robot(); });
  const RobotState& after = robot.state();
  const Motion motion{now, now + step, before.T_map_base, after.T_map_base};
  const Eigen::Vector2d way =
      (after.T_map_base.translation() - before.T_map_base.translation()).head<2>();
  if (!kidnaps.holds()) distance += way.norm();
  velocity = way / to_seconds(step);
  for (const FaultRecord& fault : sensors.read_faults(motion)) {
    const FaultEdge edge{SensorFault{fault.kind, fault.lidar}, fault.begins};
    frames.push_back({fault.stamp, HappeningRecord{fault.stamp, edge, fault.T_map_base_true}});
  }
  deliver(sensors.read_odometry(motion, before.wheels, after.wheels, robot.collisions()));
  read_further_sensors(motion);
  sample_cpu("lidar", [&] { read_lidar(motion); });
  if (frames.size() > 1) std::stable_sort(frames.begin(), frames.end(), earlier);
  now += step;
  ++steps;
}

}  // namespace castaway::sim
