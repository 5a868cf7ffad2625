/// The people of a run.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/casting/moving_scene.hpp"
#include "sim/people/agent.hpp"
#include "sim/people/crowd.hpp"
#include "sim/people/goal_fields.hpp"
#include "sim/people/intent.hpp"
#include "sim/people/people_config.hpp"
#include "sim/people/population.hpp"
#include "sim/people/robot_body.hpp"
#include "sim/people/social_force.hpp"
#include "sim/people/walk_space.hpp"

namespace castaway::sim {

/// Moves all people in steps of 50 ms, each computed from the state of all before it, and tells
/// where they are in between. Nobody ever enters a wall (`walk_space.hpp`). People give way to the
/// robot and never push it.
class People {
 public:
  static constexpr double kPeriod = 0.05;  ///< [s] Of a step.

  /// `map`: what the robot's planner knows; people also keep off everything in `world`. `lidar`:
  /// whose beams a crowd blocks. @throws std::invalid_argument, std::runtime_error if there cannot
  /// be such people.
  People(const PeopleConfig& config, const WorldSpec& world, const Grid& map,
         const LidarConfig& lidar, const RobotBody& robot, const NamedStreams& streams);

  People(const People&) = delete;
  People& operator=(const People&) = delete;

  /// Moves on by a step; `robot` as it is now, before the step.
  void step(const RobotBody& robot);
  /// Has the crowd, if there is one, take new places; `standing`: all that does not move.
  void gather(const RobotBody& robot, const RayScene& standing);
  /// Whoever is where the robot was just put steps aside at once, as far as there is room.
  void make_way(const RobotBody& robot);
  /// People whom the robot ran into at the last step.
  [[nodiscard]] const std::vector<int>& hits() const { return hits_; }

  /// All people, in order of their numbers, at the end of the last step.
  [[nodiscard]] const std::vector<Agent>& agents() const { return agents_; }
  /// Where they are a fraction of the last step after its beginning.
  [[nodiscard]] std::vector<PersonState> states(double fraction) const;
  /// What lidars meet of them then.
  [[nodiscard]] MovingScene scene(double fraction) const;
  [[nodiscard]] const WalkSpace& space() const { return space_; }

 private:
  /// Where a person faces at the beginning and the end of the last step: unit vectors in map, kept
  /// since lidars ask far more often than anybody turns.
  struct Facing {
    Eigen::Vector2d before;
    Eigen::Vector2d now;
  };

  void note_hits(const RobotBody& robot);
  void look_about(const RobotBody& robot);
  [[nodiscard]] std::vector<Eigen::Vector2d> mutual_forces() const;
  [[nodiscard]] Eigen::Vector2d force(std::size_t index, const RobotBody& robot,
                                      bool minds_robot) const;
  std::vector<Intent> intents(const RobotBody& robot);
  void move(const std::vector<Intent>& intents, const RobotBody& robot);
  void turn(std::size_t index, double wanted_heading);

  SocialForceConfig forces_;
  WalkSpace space_;
  GoalFields goals_;
  std::vector<Agent> agents_;
  std::vector<PersonState> before_;  ///< At the beginning of the last step.
  std::vector<Facing> facing_;
  std::vector<double> clear_for_;  ///< [s] Since the robot last touched each.
  std::vector<int> hits_;
  std::optional<Crowd> crowd_;
  std::int64_t steps_ = 0;
};

}  // namespace castaway::sim
