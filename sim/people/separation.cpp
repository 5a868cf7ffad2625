#include "sim/people/separation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/people/forces/cell_list.hpp"

namespace castaway::sim {
namespace {

constexpr int kSeparationRounds = 2;
constexpr double kSeparationFromRobot = 0.08;  // [m] Distance that people keep from the robot.
constexpr double kGiveWay = 0.02;  // [m] Largest step back from the robot in one period: 0.4 m/s.
// [m] Least distance from the middle of a foot to the robot.
constexpr double kSeparationOfFeet = 0.18;
constexpr double kPutDownOffset = 0.1;  // [m] Distance from a robot that was just put down.
constexpr double kRounding = 1e-9;      // [m] More than what rounding adds to a step.
constexpr int kAsideWays = 16;          // Directions tried when stepping aside.
constexpr int kAsideRings = 8;          // Rings tried, one after the other.
constexpr double kAsideRing = 0.2;      // [m] Between two rings.

Eigen::Vector2d shorten(const Eigen::Vector2d& v, double most) {
  const double length = v.norm();
  return length > most ? Eigen::Vector2d(v * (most / length)) : v;
}

/// Moves a person towards `target`, at most one step from `origin`, if that place is free.
void push(const WalkSpace& space, const Eigen::Vector2d& origin, const Eigen::Vector2d& target,
          Agent& agent) {
  const Eigen::Vector2d p = origin + shorten(target - origin, WalkSpace::kMaxStep);
  if (space.clear(p)) agent.state.position = p;
}

/// Pushes two people who overlap apart by half the overlap each.
void push_apart(const WalkSpace& space, const std::vector<PersonState>& before, std::size_t i,
                std::size_t j, std::vector<Agent>& agents) {
  const Eigen::Vector2d offset = agents[j].state.position - agents[i].state.position;
  const double touching = agents[i].body.radius + agents[j].body.radius;
  const double squared = offset.squaredNorm();
  if (squared >= touching * touching) return;
  const double distance = std::sqrt(squared);
  const Eigen::Vector2d apart = distance > 0.0
                                    ? Eigen::Vector2d(offset * (0.5 * (touching / distance - 1.0)))
                                    : Eigen::Vector2d(0.5 * touching, 0.0);
  push(space, before[i].position, agents[i].state.position - apart, agents[i]);
  push(space, before[j].position, agents[j].state.position + apart, agents[j]);
}

std::vector<Eigen::Vector2d> places(const std::vector<PersonState>& states) {
  std::vector<Eigen::Vector2d> result;
  for (const PersonState& state : states) result.push_back(state.position);
  return result;
}

/// Two people farther apart than this before a step do not touch in it: each moves by a step at
/// most.
double reach_of(const std::vector<Agent>& agents) {
  double radius = 0.0;
  for (const Agent& agent : agents) radius = std::max(radius, agent.body.radius);
  return 2.0 * (radius + WalkSpace::kMaxStep) + kRounding;
}

void out_of_robot(const WalkSpace& space, const RobotBody& robot, const Eigen::Vector2d& origin,
                  Agent& agent) {
  const Eigen::Vector2d far = agent.state.position - robot.T_map_base.position();
  const double wanted = agent.body.radius + kSeparationFromRobot;
  if (far.norm() > robot.radius + wanted) return;
  const OutlineDistance outline = distance_to(robot, agent.state.position);
  const double overlap = agent.body.radius - outline.distance;
  const double back = std::max(overlap, std::min(wanted - outline.distance, kGiveWay));
  if (back > 0.0) push(space, origin, agent.state.position + back * outline.away, agent);
}

}  // namespace

Eigen::Vector2d slide_along_walls(const WalkSpace& space, const Eigen::Vector2d& from,
                                  const Eigen::Vector2d& way) {
  const Eigen::Vector2d step = shorten(way, WalkSpace::kMaxStep);
  if (space.clear(from + step)) return from + step;
  const Eigen::Vector2d away = space.wall(from + step).away;
  const Eigen::Vector2d along = step - std::min(step.dot(away), 0.0) * away;
  for (const Eigen::Vector2d& other :
       {along, Eigen::Vector2d(step.x(), 0.0), Eigen::Vector2d(0.0, step.y())}) {
    if (space.clear(from + other)) return from + other;
  }
  return from;
}

void separate(const WalkSpace& space, const RobotBody& robot,
              const std::vector<PersonState>& before, std::vector<Agent>& agents) {
  const auto pairs = near_pairs(places(before), reach_of(agents));
  for (int round = 0; round < kSeparationRounds; ++round) {
    for (const auto& [i, j] : pairs) push_apart(space, before, i, j, agents);
  }
  for (std::size_t i = 0; i < agents.size(); ++i) {
    out_of_robot(space, robot, before[i].position, agents[i]);
  }
}

void keep_feet_off(const RobotBody& robot, PersonState& state) {
  for (Eigen::Vector2d& foot : state.feet) {
    if ((foot - robot.T_map_base.position()).norm() > robot.radius + kSeparationOfFeet) continue;
    const OutlineDistance outline = distance_to(robot, foot);
    foot += std::max(kSeparationOfFeet - outline.distance, 0.0) * outline.away;
  }
}

bool stands_close(const RobotBody& robot, const Agent& agent) {
  return distance_to(robot, agent.state.position).distance < agent.body.radius + kPutDownOffset;
}

std::optional<Eigen::Vector2d> place_aside(const WalkSpace& space, const RobotBody& robot,
                                           const Agent& agent) {
  const Eigen::Vector2d from = agent.state.position;
  const Eigen::Vector2d away = distance_to(robot, from).away;
  const double outwards = std::atan2(away.y(), away.x());
  // On each ring, the direction nearest to straight away comes first.
  for (int k = 0; k < kAsideRings * kAsideWays; ++k) {
    const int turn = (k % kAsideWays + 1) / 2 * (k % 2 == 0 ? 1 : -1);
    const double angle = outwards + 2.0 * std::numbers::pi * turn / kAsideWays;
    const int ring = k / kAsideWays + 1;
    const double distance = kAsideRing * ring;
    const Eigen::Vector2d p = from + distance * heading_vector(angle);
    const bool clear = distance_to(robot, p).distance >= agent.body.radius + kPutDownOffset;
    if (clear && space.clear(from, p)) return p;
  }
  return std::nullopt;
}

}  // namespace castaway::sim
