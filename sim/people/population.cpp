#include "sim/people/population.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_int_distribution.hpp>

#include "sim/map/grid_tools.hpp"
#include "sim/people/gait.hpp"

namespace castaway::sim {
namespace {

constexpr double kMeanSpeed = 1.34;   // [m/s] Desired speeds are normal, cut to [0.5, 2].
constexpr double kSpeedSigma = 0.26;  // [m/s]
// [m] Least distance from a person to the robot's disc at the start.
constexpr double kRobotRoom = 0.6;
constexpr int kPlaceTries = 2000;

double desired_speed(Rng& rng) {
  boost::random::normal_distribution<double> normal(kMeanSpeed, kSpeedSigma);
  while (true) {
    const double speed = normal(rng);
    if (speed >= 0.5 && speed <= 2.0) return speed;
  }
}

class Draw {
 public:
  Draw(const PeopleConfig& config, const WalkSpace& space, const GoalFields& goals,
       const RobotBody& robot, const NamedStreams& streams)
      : config_(config), space_(space), goals_(goals), robot_(robot), streams_(streams) {
    const Grid& grid = space.free().grid();
    for (int row = 0; row < grid.height; ++row) {
      for (int column = 0; column < grid.width; ++column) {
        if (grid.at(column, row) == Cell::kFree) free_.push_back({column, row});
      }
    }
  }

  std::vector<Agent> all() {
    for (std::size_t i = 0; i < config_.placed.size(); ++i) place(i, config_.placed[i]);
    for (int i = 0; i < config_.standing; ++i) stand_alone(i);
    for (std::size_t i = 0; i < config_.talking.size(); ++i) talk(i, config_.talking[i]);
    for (int i = 0; i < config_.walking; ++i) walk(i);
    return std::move(agents_);
  }

 private:
  [[nodiscard]] Agent agent(const std::string& name, Errand errand) const {
    return draw_agent(name, errand, config_.behaviour, streams_);
  }

  void add(Agent agent, const Eigen::Vector2d& p_map, double heading) {
    place_agent(p_map, heading, agent);
    agents_.push_back(std::move(agent));
  }

  [[nodiscard]] bool fits(const Eigen::Vector2d& p_map, double radius) const {
    if (!space_.clear(p_map)) return false;
    const double from_robot = (p_map - robot_.T_map_base.position()).norm();
    if (from_robot < robot_.radius + radius + kRobotRoom) return false;
    for (const Agent& other : agents_) {
      if ((other.state.position - p_map).norm() < other.body.radius + radius) return false;
    }
    return true;
  }

  /// Draws a free place; next to `near` if there is room.
  Eigen::Vector2d room(const Agent& agent, const std::string& name, Rng& rng,
                       const Eigen::Vector2d* near = nullptr) const {
    boost::random::uniform_int_distribution<std::size_t> any(0, free_.size() - 1);
    for (int i = 0; i < kPlaceTries; ++i) {
      Eigen::Vector2d p = center_of(space_.free().grid(), free_[any(rng)]);
      if (near != nullptr && i < kPlaceTries / 2) {
        const double angle = draw_between(-std::numbers::pi, std::numbers::pi, rng);
        p = *near + draw_between(0.45, 0.8, rng) * heading_vector(angle);
        if (!space_.clear(*near, p)) continue;
      }
      if (fits(p, agent.body.radius)) return p;
    }
    throw std::runtime_error(fmt::format("people: no room for {}: give fewer", name));
  }

  void place(std::size_t index, const Pose2& pose) {
    const std::string name = fmt::format("placed/{}", index);
    if (!space_.clear(pose.position())) {
      throw std::runtime_error(fmt::format(
          "people: nobody can stand at ({}, {}): move it away from obstacles", pose.x, pose.y));
    }
    add(agent(name, Errand::kStanding), pose.position(), pose.yaw);
  }

  void stand_alone(int index) {
    const std::string name = fmt::format("standing/{}", index);
    Agent person = agent(name, Errand::kStanding);
    const Eigen::Vector2d p = room(person, name, person.rng);
    const double heading = draw_between(-std::numbers::pi, std::numbers::pi, person.rng);
    add(std::move(person), p, heading);
  }

  /// Places a group in a circle, 0.7 m from neighbour to neighbour, facing the middle.
  void talk(std::size_t group, int size) {
    const double radius = 0.35 / std::sin(std::numbers::pi / size);
    Rng rng = streams_(fmt::format("people/talking/{}", group));
    boost::random::uniform_int_distribution<std::size_t> any(0, free_.size() - 1);
    for (int tries = 0; tries < kPlaceTries; ++tries) {
      const Eigen::Vector2d middle = center_of(space_.free().grid(), free_[any(rng)]);
      const double turn = draw_between(-std::numbers::pi, std::numbers::pi, rng);
      if (circle_fits(middle, radius, turn, size)) return circle(group, middle, radius, turn, size);
    }
    throw std::runtime_error(fmt::format("people: no room for talking/{}: give fewer", group));
  }

  [[nodiscard]] bool circle_fits(const Eigen::Vector2d& middle, double radius, double turn,
                                 int size) const {
    for (int i = 0; i < size; ++i) {
      const double angle = turn + 2.0 * std::numbers::pi * i / size;
      const Eigen::Vector2d p = middle + radius * heading_vector(angle);
      if (!fits(p, PersonBody{}.radius) || !space_.clear(middle, p)) return false;
    }
    return true;
  }

  void circle(std::size_t group, const Eigen::Vector2d& middle, double radius, double turn,
              int size) {
    for (int i = 0; i < size; ++i) {
      const double angle = turn + 2.0 * std::numbers::pi * i / size;
      const std::string name = fmt::format("talking/{}/{}", group, i);
      add(agent(name, Errand::kStanding), middle + radius * heading_vector(angle),
          wrap_angle(angle + std::numbers::pi));
    }
  }

  /// Draws a walker; the first of a group also draws how many follow it.
  void walk(int index) {
    const std::string name = fmt::format("walking/{}", index);
    Agent person = agent(name, Errand::kWalking);
    const double single = draw_between(0.0, 1.0, person.rng);
    const int size = boost::random::uniform_int_distribution<int>(2, 4)(person.rng);
    const auto goal = boost::random::uniform_int_distribution<std::size_t>(
        0, goals_.places().size() - 1)(person.rng);
    // Groups have 3 members on average, so that single people are drawn more often.
    const bool leads = single < config_.in_groups / (3.0 - 2.0 * config_.in_groups);
    if (followers_ > 0) return follow(std::move(person), name);
    person.goal = goal;
    person.leader = leader_ = agents_.size();
    if (leads) followers_ = size - 1;
    const Eigen::Vector2d p = room(person, name, person.rng);
    const double heading = draw_between(-std::numbers::pi, std::numbers::pi, person.rng);
    add(std::move(person), p, heading);
  }

  void follow(Agent person, const std::string& name) {
    --followers_;
    const Agent& leader = agents_[leader_];
    person.leader = leader_;
    person.rank = static_cast<int>(agents_.size() - leader_);
    person.goal = leader.goal;
    person.body.desired_speed = leader.body.desired_speed;
    const Eigen::Vector2d p = room(person, name, person.rng, &leader.state.position);
    const double heading = leader.state.heading;
    add(std::move(person), p, heading);
  }

  const PeopleConfig& config_;
  const WalkSpace& space_;
  const GoalFields& goals_;
  const RobotBody& robot_;
  const NamedStreams& streams_;
  std::vector<CellIndex> free_;
  std::vector<Agent> agents_;
  std::size_t leader_ = 0;  ///< Of the group that is being drawn.
  int followers_ = 0;       ///< Members which that group still lacks.
};

}  // namespace

Agent draw_agent(const std::string& name, Errand errand, std::optional<Behaviour> behaviour,
                 const NamedStreams& streams) {
  Agent agent;
  agent.rng = streams("people/" + name);
  agent.errand = errand;
  agent.body.desired_speed = desired_speed(agent.rng);
  agent.body.height = draw_between(1.55, 1.92, agent.rng);
  agent.body.leg_radius = draw_between(0.06, 0.08, agent.rng);
  const int dice = boost::random::uniform_int_distribution<int>(-5, 4)(agent.rng);
  const Behaviour mixed = kBehaviours[static_cast<std::size_t>(std::max(dice + 1, 0))];
  agent.behaviour = behaviour.value_or(mixed);
  return agent;
}

void place_agent(const Eigen::Vector2d& p_map, double heading, Agent& agent) {
  agent.state.position = agent.anchor = agent.waypoint = p_map;
  agent.state.heading = agent.anchor_heading = heading;
  stand(agent.state);
}

std::vector<Agent> draw_people(const PeopleConfig& config, const WalkSpace& space,
                               const GoalFields& goals, const RobotBody& robot,
                               const NamedStreams& streams) {
  return Draw(config, space, goals, robot, streams).all();
}

}  // namespace castaway::sim
