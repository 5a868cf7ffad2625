/// The people of a run.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "sim/casting/moving_scene.hpp"
#include "sim/events/world_change.hpp"
#include "sim/people/agent.hpp"
#include "sim/people/crowd.hpp"
#include "sim/people/forces/social_force.hpp"
#include "sim/people/goal_fields.hpp"
#include "sim/people/intent.hpp"
#include "sim/people/people_config.hpp"
#include "sim/people/population.hpp"
#include "sim/people/robot_body.hpp"
#include "sim/people/walk_space.hpp"

namespace castaway::sim {

/// Moves all people in steps of 50 ms, each computed from the state of all before it, and
/// interpolates in between. Nobody ever enters a wall (`walk_space.hpp`). People give way to the
/// robot and never push it.
class People {
 public:
  static constexpr double kPeriod = 0.05;  ///< [s] Of one step.

  /// `cells`: where they can walk. `lidar`: whose beams a crowd blocks. @throws
  /// std::invalid_argument, std::runtime_error if such people are impossible.
  People(const PeopleConfig& config, std::shared_ptr<const WalkCells> cells,
         const LidarConfig& lidar, const RobotBody& robot, const NamedStreams& streams);

  People(const People&) = delete;
  People& operator=(const People&) = delete;

  /// People come; there must be room for them. @throws std::runtime_error if there is none, or if
  /// they would be more than `kMaxPeople`.
  void add(const AddPeople& arrival, const RobotBody& robot, const NamedStreams& streams);
  /// Lets them walk on other cells from now on: the world changed. Everybody must be in them.
  void set_cells(std::shared_ptr<const WalkCells> cells);

  /// Advances by one step; `robot` is its state before the step.
  void step(const RobotBody& robot);
  /// Assigns the crowd, if there is one, to new places. `standing`: everything that does not move.
  void gather(const RobotBody& robot, const RayScene& standing);
  /// Moves people who stand where the robot was just put aside at once, as far as there is room.
  void make_way(const RobotBody& robot);
  /// People whom the robot ran into during the last step.
  [[nodiscard]] const std::vector<int>& hits() const { return hits_; }

  /// All people by number, at the end of the last step.
  [[nodiscard]] const std::vector<Agent>& agents() const { return agents_; }
  /// State of all people at a fraction of the last step.
  [[nodiscard]] std::vector<PersonState> states(double fraction) const;
  /// What lidars can hit of the people at a fraction of the last step.
  [[nodiscard]] MovingScene scene(double fraction) const;
  [[nodiscard]] const WalkSpace& space() const { return cells_->space(); }

 private:
  /// Unit vectors in map of a person's heading at the beginning and the end of the last step, kept
  /// because lidars ask far more often than people turn.
  struct Facing {
    Eigen::Vector2d before;
    Eigen::Vector2d now;
  };

  void begin(const Agent& agent);
  void note_hits(const RobotBody& robot);
  void update_sight(const RobotBody& robot);
  [[nodiscard]] std::vector<Eigen::Vector2d> social_forces() const;
  [[nodiscard]] Eigen::Vector2d force(std::size_t index, const RobotBody& robot,
                                      bool avoids_robot) const;
  std::vector<Intent> intents(const RobotBody& robot);
  void move(const std::vector<Intent>& intents, const RobotBody& robot);
  void turn(std::size_t index, double wanted_heading);

  SocialForceConfig forces_;
  std::shared_ptr<const WalkCells> cells_;
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
