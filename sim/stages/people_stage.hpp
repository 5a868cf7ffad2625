/// People in a simulated run: their motion, what lidars hit of them, and how the robot gives way.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "sim/navigation/people_guard.hpp"
#include "sim/navigation/route_runner.hpp"
#include "sim/people/people.hpp"
#include "sim/stages/simulation_config.hpp"

namespace castaway::sim {

/// Advances the people of a run. Without people it costs nothing and changes nothing.
class PeopleStage {
 public:
  /// `robot`: its pose at the start. @throws as `People`.
  PeopleStage(const SimulationConfig& config, Spaces& spaces, const Pose2& robot,
              const NamedStreams& streams);

  /// True if people have something to do at `now`.
  [[nodiscard]] bool due(std::chrono::nanoseconds now) const {
    return people_ && (now >= next_step_ || now >= next_scene_ || now >= next_crowd_);
  }
  /// True if there is room for people now. `spaces`: of the world as it is.
  [[nodiscard]] bool has_room(const AddPeople& arrival, const Pose2& T_map_base,
                              const SimulationConfig& config, Spaces& spaces) const;
  /// People come; there must be room. @throws as `People`.
  void add(const AddPeople& arrival, std::chrono::nanoseconds now, const Pose2& T_map_base,
           const SimulationConfig& config, Spaces& spaces);
  /// Lets people walk in a changed world, in all parts of it.
  void set_cells(std::shared_ptr<const WalkCells> cells) {
    if (people_) people_->set_cells(std::move(cells));
  }

  /// Advances people to `now`; the robot is at `T_map_base` and has `velocity` [m/s] in map.
  void advance(std::chrono::nanoseconds now, const Pose2& T_map_base,
               const Eigen::Vector2d& velocity, const RayScene& standing);
  /// Makes people step aside after the robot was put elsewhere.
  void on_kidnap(const Pose2& T_map_base);
  /// Returns the command to drive instead of `command` because of people; may re-plan `route`
  /// around them.
  Twist2 yield_to_people(const Twist2& command, RouteRunner& route);

  /// Everything that a beam can hit.
  [[nodiscard]] Surroundings around(const RayScene& standing) const;
  /// People whom the robot has run into since the last call.
  [[nodiscard]] std::vector<int> take_hits();
  /// States of people at a time within one step of now.
  [[nodiscard]] std::vector<PersonReading> readings(std::chrono::nanoseconds stamp,
                                                    const Pose2& T_map_base) const;
  /// Positions in map of all people. [m]
  [[nodiscard]] std::vector<Eigen::Vector2d> positions() const;
  /// nullptr without people.
  [[nodiscard]] const People* people() const { return people_.get(); }
  /// Position of `stamp` between the last step and the next one, in [0, 1].
  [[nodiscard]] double fraction(std::chrono::nanoseconds stamp) const;

 private:
  void begin(const SimulationConfig& config, Spaces& spaces, const Pose2& T_map_base);

  std::unique_ptr<People> people_;
  NamedStreams streams_;
  bool yields_;
  PeopleGuard guard_;
  int patience_;  ///< Calls of `yield_to_people` for which the robot waits before it re-plans.
  RobotBody robot_;
  MovingScene scene_;
  std::vector<int> hits_;
  std::chrono::nanoseconds next_step_{};
  std::chrono::nanoseconds next_scene_{};
  std::chrono::nanoseconds next_crowd_{};
};

}  // namespace castaway::sim
