#include "sim/people/reaction.hpp"

#include <algorithm>

namespace castaway::sim {
namespace {

/// When a reaction starts and how long it lasts.
struct Rule {
  double within;   ///< [m] Distance to the robot.
  double lasts;    ///< [s]
  double not_for;  ///< [s] Pause before the next one.
};

constexpr Rule kSurprise{3.0, 4.0, 15.0};
constexpr Rule kCuriosity{4.0, 12.0, 20.0};
constexpr Rule kThreat{4.0, 12.0, 20.0};
constexpr double kLookFrom = 0.9;      // [m]
constexpr double kBlockAt = 0.8;       // [m] Ahead of the robot's centre.
constexpr double kScaredWithin = 3.0;  // [m]
constexpr double kSafe = 4.0;          // [m]
constexpr double kHaste = 1.25;        // Share of the desired speed.
constexpr double kEase = 1.5;          // [1/s] Speed wanted per metre left.

/// True while the agent reacts to the robot under a rule. Starts the reaction when its time has
/// come.
bool hold_attention(Agent& agent, const Rule& rule, double distance, double now) {
  if (now < agent.busy_until) return true;
  if (now < agent.unmoved_until || !agent.sees_robot || distance > rule.within) return false;
  agent.busy_until = now + rule.lasts;
  agent.unmoved_until = agent.busy_until + rule.not_for;
  return true;
}

/// Walks towards a point, slower on the last metre.
Reaction approach(const Agent& agent, const Eigen::Vector2d& p_map, bool faces_robot) {
  const Eigen::Vector2d way = p_map - agent.state.position;
  const double distance = way.norm();
  if (distance < 1e-9) return {};
  return {way / distance * std::min(agent.body.desired_speed, kEase * distance), faces_robot};
}

std::optional<Reaction> flee(Agent& agent, const Eigen::Vector2d& to_robot, double now) {
  const double distance = to_robot.norm();
  const bool fleeing = now < agent.busy_until && distance < kSafe;
  if (!fleeing && (distance > kScaredWithin || !agent.sees_robot)) return std::nullopt;
  agent.busy_until = now + 1.0;
  const double speed = kHaste * agent.body.desired_speed;
  return Reaction{-speed * to_robot / std::max(distance, 1e-9), false};
}

}  // namespace

std::optional<Reaction> react(Agent& agent, const RobotBody& robot, double now) {
  const Eigen::Vector2d p_robot = robot.T_map_base.position();
  const Eigen::Vector2d to_robot = p_robot - agent.state.position;
  const double distance = to_robot.norm();
  switch (agent.behaviour) {
    case Behaviour::kRegular:
    case Behaviour::kImpassive:
      return std::nullopt;
    case Behaviour::kSurprised:
      if (hold_attention(agent, kSurprise, distance, now)) return Reaction{};
      return std::nullopt;
    case Behaviour::kCurious:
      if (!hold_attention(agent, kCuriosity, distance, now)) return std::nullopt;
      if (distance <= kLookFrom) return Reaction{};
      return approach(agent, p_robot - kLookFrom * to_robot / distance, true);
    case Behaviour::kScared:
      return flee(agent, to_robot, now);
    case Behaviour::kThreatening:
      if (!hold_attention(agent, kThreat, distance, now)) return std::nullopt;
      return approach(agent, robot.T_map_base * Eigen::Vector2d(kBlockAt, 0.0), true);
  }
  return std::nullopt;
}

}  // namespace castaway::sim
