/// People in a simulated run: when they move, what the lidar meets of them, how the robot yields.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include "sim/navigation/people_guard.hpp"
#include "sim/navigation/route_runner.hpp"
#include "sim/people/people.hpp"
#include "sim/stages/simulation_config.hpp"

namespace castaway::sim {

/// The people of a run on its clock. Without people it costs nothing and changes nothing.
class PeopleStage {
 public:
  /// `robot`: where it starts. @throws as `People`.
  PeopleStage(const SimulationConfig& config, const Pose2& robot, const NamedStreams& streams);

  /// True where people have something to do at `now`.
  [[nodiscard]] bool due(std::chrono::nanoseconds now) const {
    return people_ && (now >= next_step_ || now >= next_scene_ || now >= next_crowd_);
  }
  /// Brings people to `now`, with the robot there at `T_map_base` and `velocity` [m/s] in map.
  void advance(std::chrono::nanoseconds now, const Pose2& T_map_base,
               const Eigen::Vector2d& velocity, const RayScene& standing);
  /// The robot was put elsewhere.
  void on_kidnap(const Pose2& T_map_base);
  /// What the robot does instead of `command` because of people; may send `route` around them.
  Twist2 yielded(const Twist2& command, RouteRunner& route);

  /// All that a beam can meet.
  [[nodiscard]] Surroundings around(const RayScene& standing) const;
  /// People whom the robot has run into since the last call.
  [[nodiscard]] std::vector<int> take_hits();
  /// Where people are at a time within a step of now.
  [[nodiscard]] std::vector<PersonReading> readings(std::chrono::nanoseconds stamp,
                                                    const Pose2& T_map_base) const;
  /// Where in map they stand or walk. [m]
  [[nodiscard]] std::vector<Eigen::Vector2d> positions() const;
  /// Nothing if there are none.
  [[nodiscard]] const People* people() const { return people_.get(); }
  /// How far between its last step and its next one `stamp` is, in [0, 1].
  [[nodiscard]] double fraction(std::chrono::nanoseconds stamp) const;

 private:
  std::unique_ptr<People> people_;
  bool yields_;
  PeopleGuard guard_;
  int patience_;  ///< Calls of `yielded` for which the robot waits before it looks for another way.
  RobotBody robot_;
  MovingScene scene_;
  std::vector<int> hits_;
  std::chrono::nanoseconds next_step_{};
  std::chrono::nanoseconds next_scene_{};
  std::chrono::nanoseconds next_crowd_{};
};

}  // namespace castaway::sim
