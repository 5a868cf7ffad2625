#include "sim/simulation.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "sim/map/level_plane.hpp"
#include "sim/stages/drive_space.hpp"
#include "sim/steps.hpp"

namespace castaway::sim {

using std::chrono::nanoseconds;

namespace {

// Stages of every step are timed in one of so many: reading the clock takes as long as some of
// them. A prime, so that no period of a sensor is a multiple of it.
constexpr int kTimedOf = 7;

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

Simulation::Simulation(SimulationConfig config, SimulationStreams streams, CpuClock cpu_clock)
    : state_(std::make_unique<State>(std::move(config), std::move(streams))),
      cpu_clock_(std::move(cpu_clock)) {}

Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

std::optional<SimFrame> Simulation::next() {
  while (state_->frames.empty() && state_->now < state_->config.duration) make_step();
  const bool over =
      state_->frames.empty() || state_->frames.front().stamp >= state_->config.duration;
  if (over) return std::nullopt;
  SimFrame frame = std::move(state_->frames.front());
  state_->frames.pop_front();
  return frame;
}

void Simulation::make_step() {
  for (const SimulationStage& stage : kSimulationStages) {
    if (stage.due != nullptr && !stage.due(*state_)) continue;
    const int times = stage.due != nullptr ? 1 : kTimedOf;
    const bool timed = cpu_clock_ && stage.timed_as != nullptr && state_->steps % times == 0;
    const nanoseconds before = timed ? cpu_clock_() : nanoseconds{};
    stage.run(*state_);
    if (timed) cpu_[stage.timed_as] += times * (cpu_clock_() - before);
  }
  std::deque<SimFrame>& frames = state_->frames;
  if (frames.size() > 1) std::stable_sort(frames.begin(), frames.end(), earlier);
  state_->now += state_->step;
  ++state_->steps;
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
  std::visit([this](const auto& each) { sim::add(each, *state_); }, event);
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

std::map<std::string, nanoseconds> Simulation::cpu_by_stage() const { return cpu_; }

}  // namespace castaway::sim
