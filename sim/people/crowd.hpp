/// Keeps people about the robot so that they block a share of its lidar's beams.
#pragma once

#include <vector>

#include "sim/people/agent.hpp"
#include "sim/people/robot_body.hpp"
#include "sim/people/walk_space.hpp"
#include "sim/sensor/lidar.hpp"

namespace castaway::sim {

/// Gives walkers places around the robot, facing it, greedily: the place whose legs (at the lidar's
/// height: whose torso) would cover most beams that are not covered yet, until enough are. Places
/// stand on rings about the robot, off the lane before it, where nothing solid is in between. What
/// is really blocked is measured by casting beams, and more or less is aimed at by the difference.
class Crowd {
 public:
  static constexpr double kPeriod = 0.5;  ///< [s] Between two plans.

  /// `blocked_share`: of the beams of `lidar`, in (0, 1).
  Crowd(double blocked_share, const LidarConfig& lidar);

  /// Calls walkers to new places, and lets those go that are not needed.
  void plan(const RobotBody& robot, const WalkSpace& space, const Surroundings& around,
            std::vector<Agent>& agents);

 private:
  /// A place for somebody, and the beams that would end there.
  struct Place {
    Eigen::Vector2d p_map;  ///< [m]
    std::vector<bool> covers;
  };
  /// Places that are chosen, and the beams that they cover.
  struct Cover {
    std::vector<Eigen::Vector2d> chosen;  ///< [m]
    std::vector<bool> covered;
  };
  /// A beam seen from above, and where it ends on what stands.
  struct Sight {
    Ray ray;
    double range = 0.0;  ///< [m]
  };

  [[nodiscard]] std::vector<Sight> sights(const RobotBody& robot, const Surroundings& around) const;
  void measure(const std::vector<Sight>& sights, const Surroundings& around);
  [[nodiscard]] std::vector<Place> places(const RobotBody& robot, const WalkSpace& space,
                                          const std::vector<Sight>& sights) const;
  [[nodiscard]] std::vector<bool> covered(const Eigen::Vector2d& p_map,
                                          const std::vector<Sight>& sights) const;
  static double gain(const Place& place, const Cover& cover, const std::vector<Agent>& agents);
  [[nodiscard]] std::vector<Eigen::Vector2d> choose(const std::vector<Place>& places,
                                                    const std::vector<Agent>& agents) const;

  double wanted_;
  double aim_;  ///< Share that places are chosen for.
  Lidar lidar_;
  int stride_;  ///< Every so many of the lidar's beams are looked at.
};

}  // namespace castaway::sim
