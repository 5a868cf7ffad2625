#include "sim/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "sim/drive_setup.hpp"
#include "sim/drive_space.hpp"
#include "sim/navigation/proximity_guard.hpp"
#include "sim/navigation/route_runner.hpp"
#include "sim/people_stage.hpp"
#include "sim/robot/robot_physics.hpp"
#include "sim/sensor_stage.hpp"
#include "sim/world/free_space.hpp"

namespace castaway::sim {
namespace {

using std::chrono::nanoseconds;

constexpr nanoseconds kControlPeriod = std::chrono::milliseconds(50);

nanoseconds period_of(double hz, const char* what) {
  if (!(hz > 0.0) || hz > 1e5) {
    throw std::invalid_argument(fmt::format("simulation: {} is {}: give 0 to 100000", what, hz));
  }
  return nanoseconds(std::llround(1e9 / hz));
}

/// Order of deliveries at the same time: kidnap, odometry, scan, person hit.
bool earlier(const SimFrame& a, const SimFrame& b) {
  return a.stamp != b.stamp ? a.stamp < b.stamp : a.data.index() < b.data.index();
}

}  // namespace

/// Time advances by physics steps [now, now + step). At the start of a step come kidnaps, people
/// and control; then physics moves on, and the sensors read what they are due within the step.
struct Simulation::State {
  State(SimulationConfig configuration, SimulationStreams random_streams, CpuClock clock);

  void run_step();
  void kidnap_if_due();
  void move_people();
  void control();
  void read_lidar(const Motion& motion);
  template <typename Reading>
  void deliver(const std::vector<Reading>& readings);
  template <typename Work>
  void measured(const char* stage, Work work);

  SimulationConfig config;
  SimulationStreams streams;
  CpuClock cpu_clock;
  std::map<std::string, nanoseconds> cpu;

  nanoseconds step;
  nanoseconds now{};
  nanoseconds next_control{};

  Grid grid;     ///< Where it drives...
  Grid landing;  ///< ...and where it is put down.
  Pose2 start;
  std::vector<KidnapSpec> kidnaps;
  std::size_t next_kidnap = 0;
  RobotPhysics robot;
  SensorStage sensors;
  RouteRunner route;
  ProximityGuard guard;
  PeopleStage people;
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< [m/s] Of base in map.
  std::optional<Pose2> drive_pose;
  double distance = 0.0;
  std::deque<SimFrame> frames;
};

Simulation::State::State(SimulationConfig configuration, SimulationStreams random_streams,
                         CpuClock clock)
    : config(std::move(configuration)),
      streams(random_streams),
      cpu_clock(std::move(clock)),
      step(period_of(config.physics_hz, "physics_hz")),
      grid(drive_grid(config)),
      landing(landing_grid(config, grid)),
      start(castaway::sim::start_pose(config, landing, streams.events)),
      kidnaps(checked_kidnaps(config, landing)),
      robot(config.world, config.robot, start, limits_of(config.drive, config.robot), step),
      sensors(config, streams),
      route(route_of(config.drive, config.robot),
            FreeSpace(grid, config.robot.footprint_radius + kDriveMargin)),
      guard(guard_of(config.drive, config.robot)),
      people(config, start, streams.named) {}

template <typename Work>
void Simulation::State::measured(const char* stage, Work work) {
  if (!cpu_clock) return work();
  const nanoseconds before = cpu_clock();
  work();
  cpu[stage] += cpu_clock() - before;
}

void Simulation::State::kidnap_if_due() {
  while (next_kidnap < kidnaps.size() &&
         std::chrono::duration<double>(now).count() >= kidnaps[next_kidnap].at_s) {
    const KidnapSpec& spec = kidnaps[next_kidnap++];
    const Pose2 from = to_planar(robot.state().T_map_base);
    const FreeSpace free = kidnap_space(spec, config.robot, landing);
    const Pose2 to = kidnap_target(spec, from, free, streams.events);
    robot.teleport(to);
    people.on_kidnap(to);
    frames.push_back({now, KidnapRecord{now, spec.kind, from, to}});
  }
}

void Simulation::State::move_people() {
  if (!people.due(now)) return;
  const Pose2 T_map_base = to_planar(robot.state().T_map_base);
  measured("people", [&] { people.advance(now, T_map_base, velocity, sensors.scene()); });
  for (const int person : people.take_hits()) {
    frames.push_back({now, PersonHit{now, person, T_map_base}});
  }
}

void Simulation::State::control() {
  next_control += kControlPeriod;
  if (!config.drive.by_estimate) {
    const Twist2 command = route.command(to_planar(robot.state().T_map_base));
    robot.set_command(people.yielded(command, route, grid));
  } else if (drive_pose) {
    robot.set_command(guard.guarded(route.command(drive_pose)));
  } else {
    robot.set_command({});
  }
}

template <typename Reading>
void Simulation::State::deliver(const std::vector<Reading>& readings) {
  for (const Reading& reading : readings) frames.push_back({reading.stamp, reading});
}

void Simulation::State::read_lidar(const Motion& motion) {
  for (SimFrame& frame : sensors.read_lidars(people.around(sensors.scene()), motion)) {
    auto& reading = std::get<LidarReading>(frame.data);
    reading.people = people.readings(reading.stamp, reading.T_map_base_true);
    if (config.drive.by_estimate) guard.on_scan(reading, sensors.lidars()[reading.lidar]);
    frames.push_back(std::move(frame));
  }
}

void Simulation::State::run_step() {
  kidnap_if_due();
  move_people();
  if (now >= next_control) measured("drive", [this] { control(); });
  const RobotState before = robot.state();
  measured("physics", [this] { robot.step(); });
  const RobotState& after = robot.state();
  const Motion motion{now, now + step, before.T_map_base, after.T_map_base};
  const Eigen::Vector2d way =
      (after.T_map_base.translation() - before.T_map_base.translation()).head<2>();
  distance += way.norm();
  velocity = way / std::chrono::duration<double>(step).count();
  deliver(sensors.read_faults(motion));
  deliver(sensors.read_odometry(motion, before.wheels, after.wheels, robot.collisions()));
  measured("lidar", [&] { read_lidar(motion); });
  if (frames.size() > 1) std::stable_sort(frames.begin(), frames.end(), earlier);
  now += step;
}

Simulation::Simulation(SimulationConfig config, SimulationStreams streams, CpuClock cpu_clock)
    : state_(std::make_unique<State>(std::move(config), streams, std::move(cpu_clock))) {}

Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

std::optional<SimFrame> Simulation::next() {
  while (state_->frames.empty() && state_->now < state_->config.duration) state_->run_step();
  const bool over =
      state_->frames.empty() || state_->frames.front().stamp >= state_->config.duration;
  if (over) return std::nullopt;
  SimFrame frame = std::move(state_->frames.front());
  state_->frames.pop_front();
  return frame;
}

void Simulation::set_drive_pose(const std::optional<Pose2>& T_map_base) {
  state_->drive_pose = T_map_base;
}

Pose2 Simulation::start_pose() const { return state_->start; }

Pose2 Simulation::true_pose() const { return to_planar(state_->robot.state().T_map_base); }

std::int64_t Simulation::collisions() const { return state_->robot.collisions(); }

double Simulation::distance_driven() const { return state_->distance; }

std::vector<std::pair<PersonBody, PersonState>> Simulation::people() const {
  std::vector<std::pair<PersonBody, PersonState>> result;
  const People* people = state_->people.people();
  if (people == nullptr) return result;
  const auto states = people->states(state_->people.fraction(state_->now));
  for (std::size_t i = 0; i < states.size(); ++i) {
    result.emplace_back(people->agents()[i].body, states[i]);
  }
  return result;
}

std::map<std::string, nanoseconds> Simulation::cpu_by_stage() const { return state_->cpu; }

}  // namespace castaway::sim
