#include "sim/people/people.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "sim/people/arrivals.hpp"
#include "sim/people/bodies/person_rays.hpp"
#include "sim/people/forces/mutual_forces.hpp"
#include "sim/people/gait.hpp"
#include "sim/people/intent.hpp"
#include "sim/people/reaction.hpp"
#include "sim/people/separation.hpp"

namespace castaway::sim {
namespace {

constexpr int kPlaces = 16;     // Places to walk to.
constexpr int kLookEvery = 4;   // [steps] Between updates of waypoints and of who sees the robot.
constexpr double kSight = 5.0;  // [m] People farther away do not react to the robot.
constexpr double kPersonTurnRate = 4.0;  // [rad/s]
constexpr double kHitGap = 0.5;          // [s] Touches closer in time are one hit.
constexpr double kInCrowd = 0.25;  // Share of the social force that is left among crowd members.

GoalFields goals_in(const WalkCells& cells, const NamedStreams& streams) {
  Rng rng = streams("people/places");
  return {cells, kPlaces, rng};
}

Eigen::Vector2d limit_speed(const Eigen::Vector2d& v, double most) {
  const double length = v.norm();
  return length > most ? Eigen::Vector2d(v * (most / length)) : v;
}

}  // namespace

People::People(const PeopleConfig& config, std::shared_ptr<const WalkCells> cells,
               const LidarConfig& lidar, const RobotBody& robot, const NamedStreams& streams)
    : cells_((validate(config), std::move(cells))), goals_(goals_in(*cells_, streams)) {
  agents_ = draw_people(config, space(), goals_, robot, streams);
  for (const Agent& agent : agents_) begin(agent);
  if (config.blocked_share > 0.0) crowd_.emplace(config.blocked_share, lidar);
}

void People::begin(const Agent& agent) {
  before_.push_back(agent.state);
  facing_.push_back({heading_vector(agent.state.heading), heading_vector(agent.state.heading)});
  clear_for_.push_back(kHitGap);
}

void People::add(const AddPeople& arrival, const RobotBody& robot, const NamedStreams& streams) {
  if (static_cast<int>(agents_.size()) + arrival.count > kMaxPeople) {
    throw std::runtime_error(fmt::format("people: more than {} in a run", kMaxPeople));
  }
  std::vector<Agent> agents = draw_arrivals(arrival, space(), goals_, robot, agents_, streams);
  if (agents.empty()) throw std::runtime_error("people: no room for those who come");
  for (Agent& agent : agents) {
    begin(agent);
    agents_.push_back(std::move(agent));
  }
}

void People::set_cells(std::shared_ptr<const WalkCells> cells) {
  goals_.set_cells(*cells);
  cells_ = std::move(cells);
}

void People::note_hits(const RobotBody& robot) {
  hits_.clear();
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    const Agent& agent = agents_[i];
    const double far = (agent.state.position - robot.T_map_base.position()).norm();
    const bool touches =
        far < robot.radius + agent.body.radius &&
        distance_to(robot, agent.state.position).distance < agent.body.radius - 1e-6;
    if (touches && clear_for_[i] >= kHitGap) hits_.push_back(static_cast<int>(i));
    clear_for_[i] = touches ? 0.0 : clear_for_[i] + kPeriod;
  }
}

void People::update_sight(const RobotBody& robot) {
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    if ((steps_ + static_cast<std::int64_t>(i)) % kLookEvery != 0) continue;
    Agent& agent = agents_[i];
    const Eigen::Vector2d p_robot = robot.T_map_base.position();
    agent.sees_robot = reacts(agent.behaviour) &&
                       (p_robot - agent.state.position).norm() < kSight &&
                       space().sees(agent.state.position, p_robot);
    const bool walks = agent.errand == Errand::kWalking && !agent.in_crowd;
    if (walks) agent.waypoint = goals_.ahead(agent.goal, agent.state.position);
  }
}

/// Sum of the social forces of all others on each person; less among members of a crowd.
std::vector<Eigen::Vector2d> People::social_forces() const {
  Crowding people;
  for (const Agent& agent : agents_) {
    people.positions.push_back(agent.state.position);
    people.velocities.push_back(agent.state.velocity);
  }
  std::vector<Eigen::Vector2d> sums = mutual_forces(forces_, people);
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    if (agents_[i].in_crowd) sums[i] *= kInCrowd;
  }
  return sums;
}

/// Force of walls and robot on a person.
Eigen::Vector2d People::force(std::size_t index, const RobotBody& robot, bool avoids_robot) const {
  const Agent& agent = agents_[index];
  const Eigen::Vector2d& p = agent.state.position;
  const WallDistance wall = space().wall(p);
  Eigen::Vector2d walls = obstacle_force(forces_, wall.distance - WalkSpace::kBodyRoom, wall.away);
  if (!avoids_robot) return walls;
  if (agent.behaviour == Behaviour::kImpassive) {
    const OutlineDistance outline = distance_to(robot, p);
    return walls + obstacle_force(forces_, outline.distance - agent.body.radius, outline.away);
  }
  return walls + social_force(forces_, robot.T_map_base.position() - p,
                              agent.state.velocity - robot.velocity);
}

void People::turn(std::size_t index, double wanted_heading) {
  PersonState& state = agents_[index].state;
  const double most = kPersonTurnRate * kPeriod;
  const double error = wrap_angle(wanted_heading - state.heading);
  state.heading = wrap_angle(state.heading + std::clamp(error, -most, most));
}

std::vector<Intent> People::intents(const RobotBody& robot) {
  const double now = static_cast<double>(steps_) * kPeriod;
  std::vector<Intent> result;
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    result.push_back(intend(i, agents_, goals_, robot, now));
  }
  return result;
}

/// Moves everybody by the forces, which are all computed before anybody moves.
void People::move(const std::vector<Intent>& intents, const RobotBody& robot) {
  const std::vector<Eigen::Vector2d> others = social_forces();
  std::vector<Eigen::Vector2d> ways;
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    const Eigen::Vector2d& v = agents_[i].state.velocity;
    const Eigen::Vector2d acceleration = driving_force(forces_, v, intents[i].velocity) +
                                         others[i] + force(i, robot, intents[i].avoids_robot);
    ways.emplace_back(kPeriod * limit_speed(v + kPeriod * acceleration, intents[i].top_speed));
  }
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    before_[i] = agents_[i].state;
    agents_[i].state.position = slide_along_walls(space(), before_[i].position, ways[i]);
  }
}

void People::step(const RobotBody& robot) {
  note_hits(robot);
  update_sight(robot);
  const std::vector<Intent> wanted = intents(robot);
  move(wanted, robot);
  separate(space(), robot, before_, agents_);
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    PersonState& state = agents_[i].state;
    const Eigen::Vector2d way = state.position - before_[i].position;
    state.velocity = limit_speed(way / kPeriod, wanted[i].top_speed);
    turn(i, wanted[i].heading);
    walk(space(), before_[i], kPeriod, state);
    keep_feet_off(robot, state);
    note_progress(wanted[i], kPeriod, agents_[i]);
    facing_[i] = {facing_[i].now, heading_vector(state.heading)};
  }
  ++steps_;
}

void People::gather(const RobotBody& robot, const RayScene& standing) {
  if (!crowd_) return;
  const MovingScene people = scene(1.0);
  crowd_->plan(robot, space(), {standing, people}, agents_);
}

void People::make_way(const RobotBody& robot) {
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    PersonState& state = agents_[i].state;
    if (!stands_close(robot, agents_[i])) continue;
    if (const auto p = place_aside(space(), robot, agents_[i])) state.position = *p;
    stand(state);
    before_[i] = state;
    facing_[i].before = facing_[i].now;
  }
}

std::vector<PersonState> People::states(double fraction) const {
  std::vector<PersonState> result;
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    result.push_back(between(before_[i], agents_[i].state, fraction));
  }
  return result;
}

MovingScene People::scene(double fraction) const {
  std::vector<MovingBody> bodies;
  bodies.reserve(agents_.size());
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    const auto& [before, now] = facing_[i];
    const Eigen::Vector2d ahead = (before + fraction * (now - before)).normalized();
    bodies.push_back(person_rays(agents_[i].body, between(before_[i], agents_[i].state, fraction),
                                 ahead, static_cast<int>(i)));
  }
  return MovingScene(std::move(bodies));
}

}  // namespace castaway::sim
