#include "sim/people/intent.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <boost/random/uniform_int_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include "sim/people/reaction.hpp"

namespace castaway::sim {
namespace {

constexpr double kTopSpeed = 1.3;     // Share of the desired speed (Helbing and Molnar 1995).
constexpr double kArrived = 0.7;      // [m]
constexpr double kLongestRest = 6.0;  // [s]
constexpr double kPatience = 4.0;     // [s] A walker that is stuck for longer picks another goal.
// [m/s] A walker whose smoothed headway is less than this is stuck.
constexpr double kStuckHeadway = 0.1;
constexpr double kSmoothing = 2.0;  // [s] Time constant of that headway: people in a throng jostle.
constexpr double kInTheWay = 2.0;   // [m] A robot this close may be what holds a walker up.
constexpr int kIntentTries = 8;     // Goals that a walker tries when it turns back.
constexpr double kMovingIntent =
    0.3;  // [m/s] A walker that wants less speed than this is not stuck.
constexpr double kDefaultHeadway = 0.5;  // [m/s]
constexpr double kAnchorEase = 1.0;      // [1/s] Speed wanted per metre off the place.
constexpr double kAnchorSpeed = 0.6;     // [m/s]
constexpr double kAtPlace = 0.05;        // [m]
constexpr double kSlotEase = 2.0;        // [1/s]
constexpr double kSlotSpeed = 1.8;       // [m/s] Enough to keep up with a robot.
constexpr double kFormationEase = 1.2;   // [1/s]
// [m] A follower farther off walks by its own path, and its leader slows down.
constexpr double kTooFarBehind = 1.8;
constexpr double kWalking = 0.15;  // [m/s] Faster people look where they go.
// [m] To the left of the leader.
constexpr std::array<double, 4> kAbreast = {0.0, 0.65, -0.65, 1.3};

double heading_of(const Eigen::Vector2d& v) { return std::atan2(v.y(), v.x()); }

Eigen::Vector2d ease_towards(const Eigen::Vector2d& way, double ease, double most) {
  const double distance = way.norm();
  if (distance < kAtPlace) return Eigen::Vector2d::Zero();
  return way / distance * std::min(ease * distance, most);
}

double facing(const Agent& agent, const RobotBody& robot) {
  return heading_of(robot.T_map_base.position() - agent.state.position);
}

Intent stand_there(const Agent& agent) {
  Intent intent;
  intent.velocity = ease_towards(agent.anchor - agent.state.position, kAnchorEase, kAnchorSpeed);
  intent.heading = agent.anchor_heading;
  intent.top_speed = kAnchorSpeed;
  return intent;
}

Intent join_crowd(const Agent& agent, const RobotBody& robot) {
  Intent intent;
  const Eigen::Vector2d way = agent.slot - agent.state.position;
  intent.velocity = robot.velocity + ease_towards(way, kSlotEase, kSlotSpeed);
  intent.heading = way.norm() > 0.5 ? heading_of(way) : facing(agent, robot);
  intent.top_speed = kSlotSpeed;
  intent.avoids_robot = false;
  return intent;
}

void next_goal(Agent& agent, const GoalFields& goals) {
  boost::random::uniform_int_distribution<std::size_t> any(0, goals.places().size() - 1);
  agent.goal = any(agent.rng);
  agent.headway = kDefaultHeadway;
  agent.stuck_for = 0.0;
}

/// Picks another goal whose path does not lead past a robot that stands in the way.
void turn_back(Agent& agent, GoalFields& goals, const RobotBody& robot) {
  const Eigen::Vector2d from_robot = agent.state.position - robot.T_map_base.position();
  for (int tries = 0; tries < kIntentTries; ++tries) {
    next_goal(agent, goals);
    agent.waypoint = goals.ahead(agent.goal, agent.state.position);
    const bool away = (agent.waypoint - agent.state.position).dot(from_robot) > 0.0;
    if (away || from_robot.norm() > kInTheWay) return;
  }
}

bool left_behind(const std::vector<Agent>& agents, std::size_t leader) {
  const Agent& first = agents[leader];
  for (std::size_t i = leader + 1; i < agents.size() && agents[i].leader == leader; ++i) {
    if ((agents[i].state.position - first.state.position).norm() > kTooFarBehind) return true;
  }
  return false;
}

/// Walks to the goal, or rests there.
Intent lead(std::size_t index, std::vector<Agent>& agents, GoalFields& goals,
            const RobotBody& robot, double now) {
  Agent& agent = agents[index];
  Intent intent;
  intent.top_speed = kTopSpeed * agent.body.desired_speed;
  intent.heading = agent.state.heading;
  if (now < agent.rests_until) return intent;
  const Eigen::Vector2d to_goal = goals.places()[agent.goal] - agent.state.position;
  if (to_goal.norm() < kArrived) {
    agent.rests_until =
        now + boost::random::uniform_real_distribution<double>(0.0, kLongestRest)(agent.rng);
    next_goal(agent, goals);
    return intent;
  }
  if (agent.stuck_for > kPatience) turn_back(agent, goals, robot);
  const double pace = left_behind(agents, index) ? 0.4 : 1.0;
  const Eigen::Vector2d way = agent.waypoint - agent.state.position;
  if (way.norm() < 1e-6) return intent;
  intent.velocity = way.normalized() * pace * agent.body.desired_speed;
  intent.heading = heading_of(way);
  return intent;
}

/// Walks beside the leader; where there is no room, along the own path to the same goal.
Intent follow(std::size_t index, std::vector<Agent>& agents) {
  Agent& agent = agents[index];
  const Agent& leader = agents[agent.leader];
  agent.goal = leader.goal;
  const Eigen::Vector2d ahead = heading_vector(leader.state.heading);
  const double aside = kAbreast[static_cast<std::size_t>(agent.rank) % kAbreast.size()];
  const Eigen::Vector2d place =
      leader.state.position + aside * Eigen::Vector2d(-ahead.y(), ahead.x());
  Intent intent;
  intent.top_speed = kTopSpeed * agent.body.desired_speed;
  intent.heading = leader.state.heading;
  Eigen::Vector2d way = place - agent.state.position;
  if (way.norm() > kTooFarBehind) way = agent.waypoint - agent.state.position;
  intent.velocity =
      leader.state.velocity + ease_towards(way, kFormationEase, agent.body.desired_speed);
  return intent;
}

}  // namespace

Intent intend(std::size_t index, std::vector<Agent>& agents, GoalFields& goals,
              const RobotBody& robot, double now) {
  Agent& agent = agents[index];
  if (agent.in_crowd) return join_crowd(agent, robot);
  if (const auto reaction = react(agent, robot, now)) {
    const bool walks = reaction->velocity.norm() > kWalking && !reaction->faces_robot;
    return {reaction->velocity, walks ? heading_of(reaction->velocity) : facing(agent, robot),
            kTopSpeed * agent.body.desired_speed, false};
  }
  if (agent.errand == Errand::kStanding) return stand_there(agent);
  return agent.leader == index ? lead(index, agents, goals, robot, now) : follow(index, agents);
}

void note_progress(const Intent& intent, double dt, Agent& agent) {
  const double wanted = intent.velocity.norm();
  const double headway =
      wanted > kMovingIntent ? agent.state.velocity.dot(intent.velocity) / wanted : kDefaultHeadway;
  agent.headway += std::min(dt / kSmoothing, 1.0) * (headway - agent.headway);
  agent.stuck_for = agent.headway < kStuckHeadway ? agent.stuck_for + dt : 0.0;
}

}  // namespace castaway::sim
