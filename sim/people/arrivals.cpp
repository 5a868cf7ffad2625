#include "sim/people/arrivals.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>
#include <boost/random/uniform_int_distribution.hpp>

#include "sim/people/population.hpp"

namespace castaway::sim {
namespace {

constexpr double kRobotGap = 0.1;        // [m] Between the robot's disc and a person who comes.
constexpr double kTalkingSpacing = 0.7;  // [m] Between neighbours of a group that talks.
constexpr std::array<double, 3> kBesideLeader = {0.55, 0.7, 0.9};  // [m] Tried in this order.
constexpr int kAngles = 12;                                        // Tried on each ring.

class Arrivals {
 public:
  Arrivals(const AddPeople& arrival, const WalkSpace& space, const RobotBody& robot,
           const std::vector<Agent>& present)
      : arrival_(arrival), space_(space), robot_(robot), present_(present) {}

  /// Poses of all of them; fewer if there is no room.
  [[nodiscard]] std::vector<Pose2> poses() const {
    const Pose2& first = arrival_.T_map_person;
    if (arrival_.count > 1 && !arrival_.walk) return circle();
    std::vector<Pose2> found;
    if (fits(first.position(), found)) found.push_back(first);
    while (!found.empty() && static_cast<int>(found.size()) < arrival_.count) {
      const auto p_map = beside(found);
      if (!p_map) break;
      found.push_back({p_map->x(), p_map->y(), first.yaw});
    }
    return found;
  }

 private:
  [[nodiscard]] bool fits(const Eigen::Vector2d& p_map, const std::vector<Pose2>& found) const {
    const double radius = PersonBody{}.radius;
    if (!space_.clear(p_map)) return false;
    const double from_robot = (p_map - robot_.T_map_base.position()).norm();
    if (from_robot < robot_.radius + radius + kRobotGap) return false;
    for (const Agent& other : present_) {
      if ((other.state.position - p_map).norm() < other.body.radius + radius) return false;
    }
    for (const Pose2& other : found) {
      if ((other.position() - p_map).norm() < 2.0 * radius) return false;
    }
    return true;
  }

  /// A place near the first one, within sight of it.
  [[nodiscard]] std::optional<Eigen::Vector2d> beside(const std::vector<Pose2>& found) const {
    const Eigen::Vector2d first = found.front().position();
    for (const double radius : kBesideLeader) {
      for (int i = 0; i < kAngles; ++i) {
        const double angle = found.front().yaw + 2.0 * std::numbers::pi * (i + 0.5) / kAngles;
        const Eigen::Vector2d p = first + radius * heading_vector(angle);
        if (fits(p, found) && space_.clear(first, p)) return p;
      }
    }
    return std::nullopt;
  }

  /// In a circle, facing its middle.
  [[nodiscard]] std::vector<Pose2> circle() const {
    const double radius = 0.5 * kTalkingSpacing / std::sin(std::numbers::pi / arrival_.count);
    const Eigen::Vector2d middle = arrival_.T_map_person.position();
    std::vector<Pose2> found;
    for (int i = 0; i < arrival_.count; ++i) {
      const double angle = arrival_.T_map_person.yaw + 2.0 * std::numbers::pi * i / arrival_.count;
      const Eigen::Vector2d p = middle + radius * heading_vector(angle);
      if (!fits(p, found) || !space_.clear(middle, p)) return {};
      found.push_back({p.x(), p.y(), wrap_angle(angle + std::numbers::pi)});
    }
    return found;
  }

  const AddPeople& arrival_;
  const WalkSpace& space_;
  const RobotBody& robot_;
  const std::vector<Agent>& present_;
};

}  // namespace

bool has_room(const AddPeople& arrival, const WalkSpace& space, const RobotBody& robot,
              const std::vector<Agent>& present) {
  const auto found = Arrivals(arrival, space, robot, present).poses().size();
  return static_cast<int>(found) == arrival.count;
}

std::vector<Agent> draw_arrivals(const AddPeople& arrival, const WalkSpace& space,
                                 const GoalFields& goals, const RobotBody& robot,
                                 const std::vector<Agent>& present, const NamedStreams& streams) {
  const std::vector<Pose2> poses = Arrivals(arrival, space, robot, present).poses();
  std::vector<Agent> agents;
  if (static_cast<int>(poses.size()) < arrival.count) return agents;
  const std::size_t leader = present.size();
  const Errand errand = arrival.walk ? Errand::kWalking : Errand::kStanding;
  for (const Pose2& pose : poses) {
    const std::size_t index = agents.size();
    Agent agent =
        draw_agent(fmt::format("added/{}", leader + index), errand, arrival.behaviour, streams);
    place_agent(pose.position(), pose.yaw, agent);
    agent.leader = arrival.walk ? leader : leader + index;
    agent.rank = arrival.walk ? static_cast<int>(index) : 0;
    if (index == 0) {
      agent.goal = boost::random::uniform_int_distribution<std::size_t>(
          0, goals.places().size() - 1)(agent.rng);
    } else if (arrival.walk) {
      agent.goal = agents.front().goal;
      agent.body.desired_speed = agents.front().body.desired_speed;
    }
    agents.push_back(std::move(agent));
  }
  return agents;
}

}  // namespace castaway::sim
