#include "tests/bench/workbench/crowd_hours.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/people/people.hpp"
#include "sim/people/robot_body.hpp"
#include "sim/stages/spaces.hpp"
#include "tools/build/build_simulation.hpp"
#include "tools/build/simulator_source.hpp"

namespace castaway::testbed {
namespace {

constexpr double kRobotSpeed = 0.4;  // [m/s]
constexpr double kSettling = 5.0;    // [s] Time in which people that were drawn too close together
                                     // separate.

/// Moves along its waypoints and ignores obstacles.
class RouteRobot {
 public:
  explicit RouteRobot(const sim::SimulationConfig& config)
      : waypoints_(config.drive.waypoints),
        body_{sim::robot_outline(config.robot), config.robot.footprint_radius, config.start, {}} {}

  void advance(double dt) {
    if (waypoints_.empty()) return;
    const Eigen::Vector2d way = waypoints_[next_] - body_.T_map_base.position();
    const double step = kRobotSpeed * dt;
    if (way.norm() <= step) {
      next_ = (next_ + 1) % waypoints_.size();
      return;
    }
    const Eigen::Vector2d ahead = way.normalized();
    const Eigen::Vector2d p = body_.T_map_base.position() + step * ahead;
    body_.T_map_base = {p.x(), p.y(), std::atan2(ahead.y(), ahead.x())};
    body_.velocity = kRobotSpeed * ahead;
  }
  [[nodiscard]] const sim::RobotBody& body() const { return body_; }

 private:
  std::vector<Eigen::Vector2d> waypoints_;
  std::size_t next_ = 0;
  sim::RobotBody body_;
};

/// Checks a step against the true shapes.
void check_step(const sim::RayScene& walls, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                CrowdHours& seen) {
  const double length = (to - from).norm();
  const Eigen::Vector2d ahead =
      length > 0.0 ? Eigen::Vector2d((to - from) / length) : Eigen::Vector2d::UnitX();
  bool through = false;
  bool inside = false;
  for (const double z : {0.1, 0.6, 1.1, 1.7}) {
    const Eigen::Vector3d direction(ahead.x(), ahead.y(), 0.0);
    const auto hit = walls.cast({{from.x(), from.y(), z}, direction}, length);
    through = through || hit.has_value();
    const auto here = walls.cast({{to.x(), to.y(), z}, direction}, 1e-6);
    inside = inside || here.has_value();
  }
  seen.through += through ? 1 : 0;
  seen.inside += inside ? 1 : 0;
  seen.walked_km += 1e-3 * length;
}

void step_and_judge(const sim::RayScene& walls, const sim::RobotBody& robot, sim::People& people,
                    CrowdHours& seen) {
  std::vector<Eigen::Vector2d> before;
  for (const sim::Agent& agent : people.agents()) before.push_back(agent.state.position);
  people.step(robot);
  for (std::size_t i = 0; i < before.size(); ++i) {
    check_step(walls, before[i], people.agents()[i].state.position, seen);
  }
}

double closest_pair(const std::vector<sim::Agent>& agents) {
  double closest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < agents.size(); ++i) {
    for (std::size_t j = i + 1; j < agents.size(); ++j) {
      closest = std::min(closest, (agents[i].state.position - agents[j].state.position).norm());
    }
  }
  return closest;
}

}  // namespace

CrowdHours watch_crowd(const CrowdHoursConfig& config, const std::function<void(int)>& on_hour) {
  Scenario scenario;
  scenario.world.file = config.world;
  scenario.seed = config.seed;
  const sim::SimulationConfig simulation = build_simulation(scenario, ".").config;
  const sim::RayScene walls(sim::ray_primitives(simulation.world));
  RouteRobot robot(simulation);
  sim::People people(config.people, simulation.spaces->walking(simulation.world, simulation.map),
                     simulation.lidars.front(), robot.body(),
                     simulation_streams(config.seed).named);
  CrowdHours seen;
  seen.closest_pair_m = std::numeric_limits<double>::infinity();
  const auto steps = static_cast<std::int64_t>(config.hours * 3600.0 / sim::People::kPeriod);
  const auto crowd_every = static_cast<std::int64_t>(sim::Crowd::kPeriod / sim::People::kPeriod);
  for (std::int64_t step = 0; step < steps; ++step) {
    const double now = static_cast<double>(step) * sim::People::kPeriod;
    robot.advance(sim::People::kPeriod);
    if (step % crowd_every == 0) people.gather(robot.body(), walls);
    step_and_judge(walls, robot.body(), people, seen);
    seen.robot_hits += static_cast<std::int64_t>(people.hits().size());
    if (now > kSettling) {
      seen.closest_pair_m = std::min(seen.closest_pair_m, closest_pair(people.agents()));
    }
    if (on_hour && (step + 1) % 72000 == 0) on_hour(static_cast<int>((step + 1) / 72000));
  }
  seen.hours = static_cast<double>(steps) * sim::People::kPeriod / 3600.0;
  seen.person_hours = seen.hours * static_cast<double>(people.agents().size());
  return seen;
}

}  // namespace castaway::testbed
