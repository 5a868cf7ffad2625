/// Hours of people in a world, without lidar and physics: does anybody ever pass a wall?
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "sim/people/people_config.hpp"

namespace castaway::testbed {

/// What is watched.
struct CrowdHoursConfig {
  std::string world = "lab";  ///< A world's name or path, or a ROS map's .yaml.
  sim::PeopleConfig people;
  double hours = 1.0;  ///< [h] Simulated.
  std::uint64_t seed = 1;
};

/// What was seen. Walls are held against the world's true shapes, at four heights, which the people
/// themselves know only as cells of a grid.
struct CrowdHours {
  double hours = 0.0;           ///< [h] Simulated...
  double person_hours = 0.0;    ///< [h] ...times people.
  std::int64_t through = 0;     ///< Steps whose straight line meets something solid.
  std::int64_t inside = 0;      ///< Steps that end in something solid.
  double walked_km = 0.0;       ///< [km] By all.
  double closest_pair_m = 0.0;  ///< [m] Two middles, ever, once people are under way.
  std::int64_t robot_hits = 0;  ///< By a robot that drives its route at 0.4 m/s, come what may.
};

/// Watches. `on_hour` is told every simulated hour that is over. Throws std::runtime_error or
/// std::invalid_argument naming what is wrong.
CrowdHours watch_crowd(const CrowdHoursConfig& config,
                       const std::function<void(int hour)>& on_hour = {});

}  // namespace castaway::testbed
