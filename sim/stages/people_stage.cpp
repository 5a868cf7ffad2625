#include "sim/stages/people_stage.hpp"

#include <algorithm>
#include <utility>

#include "sim/map/grid_tools.hpp"
#include "sim/people/arrivals.hpp"
#include "sim/stages/drive_setup.hpp"
#include "sim/stages/drive_space.hpp"

namespace castaway::sim {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;

constexpr nanoseconds kPeopleStep = milliseconds(50);  // As `People::kPeriod`.
constexpr nanoseconds kScene = milliseconds(10);       // Legs move 2 cm in this time.
constexpr nanoseconds kCrowd = milliseconds(500);
constexpr int kPushPatience =
    60;  // Calls of `yield_to_people` for which the robot waits first: 3 s.
constexpr int kLongestPatience = 480;  // The wait doubles each time in a throng, up to 24 s.

/// Discs of the people within 4 m of the robot.
std::vector<RoundObstacle> discs_near(const std::vector<Agent>& agents, const Pose2& robot) {
  constexpr double kWithin = 4.0;
  std::vector<RoundObstacle> discs;
  for (const Agent& agent : agents) {
    const bool near = (agent.state.position - robot.position()).norm() <= kWithin;
    if (near) discs.push_back({agent.state.position, agent.body.radius});
  }
  return discs;
}

RobotBody body_of(const SimulationConfig& config, const Pose2& T_map_base) {
  return {robot_outline(config.robot), config.robot.footprint_radius, T_map_base, {0.0, 0.0}};
}

}  // namespace

PeopleStage::PeopleStage(const SimulationConfig& config, Spaces& spaces, const Pose2& robot,
                         const NamedStreams& streams)
    : streams_(streams),
      yields_(config.people.robot_yields),
      guard_(guard_of(config.drive, config.robot), PersonBody{}.radius),
      patience_(kPushPatience) {
  if (config.people.count() > 0) begin(config, spaces, robot);
}

void PeopleStage::begin(const SimulationConfig& config, Spaces& spaces, const Pose2& T_map_base) {
  if (!streams_) {
    throw std::invalid_argument(
        "people: no random streams for them: give SimulationStreams::named");
  }
  robot_ = body_of(config, T_map_base);
  people_ = std::make_unique<People>(config.people, spaces.walking(config.world, config.map),
                                     config.lidars.front(), robot_, streams_);
}

bool PeopleStage::has_room(const AddPeople& arrival, const Pose2& T_map_base,
                           const SimulationConfig& config, Spaces& spaces) const {
  const std::shared_ptr<const WalkCells> cells = spaces.walking(config.world, config.map);
  const std::vector<Agent> nobody;
  return sim::has_room(arrival, cells->space(), body_of(config, T_map_base),
                       people_ ? people_->agents() : nobody);
}

void PeopleStage::add(const AddPeople& arrival, nanoseconds now, const Pose2& T_map_base,
                      const SimulationConfig& config, Spaces& spaces) {
  if (!people_) {
    begin(config, spaces, T_map_base);
    next_step_ = next_scene_ = next_crowd_ = now;
  }
  robot_.T_map_base = T_map_base;
  people_->add(arrival, robot_, streams_);
}

void PeopleStage::advance(nanoseconds now, const Pose2& T_map_base, const Eigen::Vector2d& velocity,
                          const RayScene& standing) {
  if (!people_) return;
  robot_.T_map_base = T_map_base;
  robot_.velocity = velocity;
  if (now >= next_crowd_) {
    next_crowd_ += kCrowd;
    people_->gather(robot_, standing);
  }
  if (now >= next_step_) {
    next_step_ += kPeopleStep;
    people_->step(robot_);
    hits_.insert(hits_.end(), people_->hits().begin(), people_->hits().end());
  }
  if (now >= next_scene_) {
    next_scene_ += kScene;
    scene_ = people_->scene(fraction(now));
  }
}

double PeopleStage::fraction(nanoseconds stamp) const {
  const double past = static_cast<double>((stamp - (next_step_ - kPeopleStep)).count());
  return std::clamp(past / static_cast<double>(kPeopleStep.count()), 0.0, 1.0);
}

void PeopleStage::on_kidnap(const Pose2& T_map_base) {
  if (!people_) return;
  robot_.T_map_base = T_map_base;
  robot_.velocity.setZero();
  people_->make_way(robot_);
  scene_ = people_->scene(1.0);
}

Twist2 PeopleStage::yield_to_people(const Twist2& command, RouteRunner& route) {
  if (!people_ || !yields_) return command;
  const Pose2 T_base_map = inverse(robot_.T_map_base);
  std::vector<Eigen::Vector2d> p_base;
  for (const Eigen::Vector2d& p_map : positions()) p_base.emplace_back(T_base_map * p_map);
  const Twist2 twist = guard_.limit(command, p_base);
  if (twist.v == command.v) patience_ = kPushPatience;
  if (guard_.has_waited(patience_)) {
    patience_ = std::min(2 * patience_, kLongestPatience);
    const std::vector<RoundObstacle> discs = discs_near(people_->agents(), robot_.T_map_base);
    route.detour(robot_.T_map_base, route.free().with_discs(discs));
  }
  return twist;
}

Surroundings PeopleStage::around(const RayScene& standing) const {
  return people_ ? Surroundings(standing, scene_) : Surroundings(standing);
}

std::vector<Eigen::Vector2d> PeopleStage::positions() const {
  std::vector<Eigen::Vector2d> result;
  if (!people_) return result;
  for (const Agent& agent : people_->agents()) result.push_back(agent.state.position);
  return result;
}

std::vector<int> PeopleStage::take_hits() { return std::exchange(hits_, {}); }

std::vector<PersonReading> PeopleStage::readings(nanoseconds stamp, const Pose2& T_map_base) const {
  std::vector<PersonReading> result;
  if (!people_) return result;
  RobotBody robot = robot_;
  robot.T_map_base = T_map_base;
  const std::vector<PersonState> states = people_->states(fraction(stamp));
  for (std::size_t i = 0; i < states.size(); ++i) {
    const PersonState& state = states[i];
    const double gap =
        distance_to(robot, state.position).distance - people_->agents()[i].body.radius;
    result.push_back({static_cast<int>(i),
                      {state.position.x(), state.position.y(), state.heading},
                      state.velocity,
                      gap});
  }
  return result;
}

}  // namespace castaway::sim
