#include "sim/simulation.hpp"

#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "sim/map/level_plane.hpp"
#include "sim/simulation_state.hpp"
#include "sim/stages/drive_space.hpp"

namespace castaway::sim {

using std::chrono::nanoseconds;

Simulation::Simulation(SimulationConfig config, SimulationStreams streams, CpuClock cpu_clock)
    : state_(std::make_unique<State>(std::move(config), std::move(streams), std::move(cpu_clock))) {
}

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
  state_->drive.set_pose(T_map_base);
}

void Simulation::set_watched_pose(const std::optional<Pose2>& T_map_base, double z) {
  state_->watched = T_map_base;
  state_->watched_z = z;
}

void Simulation::set_command(const std::optional<Twist2>& command) {
  state_->drive.set_command(command);
}

void Simulation::add(const EventSpec& event) {
  if (!state_->config.open) throw std::logic_error("an event for a run that is not open");
  std::visit([this](const auto& each) { state_->add(each); }, event);
}

const WorldSpec& Simulation::world() const { return state_->config.world; }

nanoseconds Simulation::now() const { return state_->now; }

void Simulation::kidnap(const Pose2& T_map_base) {
  if (!state_->config.drive.path.empty()) {
    throw std::invalid_argument("kidnap: the robot follows a recorded path to its end");
  }
  const SimulationConfig& config = state_->config;
  const FreeSpace standing = state_->spaces->landing(config, standing_radius(config));
  std::optional<Pose2> target = T_map_base;
  if (config.levels) {
    const double z = state_->robot.state().T_map_base.translation().z();
    target = config.levels->nearest_ground(T_map_base, z);
  }
  if (!target || !standing.contains(target->position())) {
    throw std::invalid_argument(fmt::format("kidnap: the robot has no room at ({:.2f}, {:.2f}) m",
                                            T_map_base.x, T_map_base.y));
  }
  state_->requested = target;
}

Pose2 Simulation::start_pose() const { return state_->plane.in_map(state_->start); }
double Simulation::start_height() const { return state_->plane.height_at(state_->start); }

Pose2 Simulation::true_pose() const { return to_planar(state_->robot.state().T_map_base); }

Eigen::Isometry3d Simulation::T_footprint_base() const {
  const Eigen::Isometry3d& T_map_base = state_->robot.state().T_map_base;
  return to_isometry(to_planar(T_map_base)).inverse() * T_map_base;
}

Twist2 Simulation::last_command() const { return state_->commanded; }

WheelAngles Simulation::wheels() const { return state_->robot.state().wheels; }

std::int64_t Simulation::collisions() const { return state_->robot.collisions(); }

std::optional<VoidRecord> Simulation::void_record() const { return state_->progress.verdict(); }

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
