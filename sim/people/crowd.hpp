/// Keeps people around the robot so that they block a share of its lidar's beams.
#pragma once

#include <vector>

#include "sim/people/agent.hpp"
#include "sim/people/robot_body.hpp"
#include "sim/people/walk_space.hpp"
#include "sim/sensor/lidar.hpp"

namespace castaway::sim {

/// Chooses places around the robot greedily: the place whose legs (or torso, at the lidar's height)
/// would cover most uncovered beams comes next, until enough beams are covered. Places lie on rings
/// around the robot, off the lane ahead of it, where no wall is in between. The share really
/// blocked is measured by casting beams, and the share aimed at is corrected by the error.
class Crowd {
 public:
  static constexpr double kPeriod = 0.5;  ///< [s] Between two plans.

  /// `blocked_share`: share of the beams of `lidar`, in (0, 1).
  Crowd(double blocked_share, const LidarConfig& lidar);

  /// Assigns walkers to new places, and releases those that are no longer needed.
  void plan(const RobotBody& robot, const WalkSpace& space, const Surroundings& around,
            std::vector<Agent>& agents);

 private:
  /// A candidate place, and the beams that would end there.
  struct Place {
    Eigen::Vector2d p_map;  ///< [m]
    std::vector<bool> covers;
  };
  /// The places chosen so far, and the beams that they cover.
  struct Cover {
    std::vector<Eigen::Vector2d> chosen;  ///< [m]
    std::vector<bool> covered;
  };
  /// A beam of the level slice, and its range on what does not move.
  struct Sight {
    Ray ray;
    double range = 0.0;  ///< [m]
  };

  [[nodiscard]] std::vector<Sight> sights(const RobotBody& robot, const Surroundings& around) const;
  void measure(const std::vector<Sight>& sights, const Surroundings& around);
  [[nodiscard]] std::vector<Place> places(const RobotBody& robot, const WalkSpace& space,
                                          const std::vector<Sight>& sights) const;
  [[nodiscard]] std::vector<bool> covered_beams(const Eigen::Vector2d& p_map,
                                                const std::vector<Sight>& sights) const;
  static double gain(const Place& place, const Cover& cover, const std::vector<Agent>& agents);
  [[nodiscard]] std::vector<Eigen::Vector2d> choose(const std::vector<Place>& places,
                                                    const std::vector<Agent>& agents) const;

  double wanted_;
  double aim_;  ///< Share of beams that places are chosen for.
  Lidar lidar_;
  int stride_;  ///< One in so many of the lidar's beams is evaluated.
};

}  // namespace castaway::sim
