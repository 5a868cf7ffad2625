/// Simulates hours of people in a world, without lidar and physics, to check that nobody passes a
/// wall.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "sim/people/people_config.hpp"

namespace castaway::testbed {

struct CrowdHoursConfig {
  std::string world = "lab";  ///< A world's name or path, or a ROS map's .yaml.
  sim::PeopleConfig people;
  double hours = 1.0;  ///< [h] Simulated.
  std::uint64_t seed = 1;
};

/// What was observed. Steps are checked against the world's true shapes at four heights; the people
/// themselves only know the walls as cells of a grid.
struct CrowdHours {
  double hours = 0.0;           ///< [h] Simulated time.
  double person_hours = 0.0;    ///< [h] Simulated time multiplied by the number of people.
  std::int64_t through = 0;     ///< Steps whose straight line crosses something solid.
  std::int64_t inside = 0;      ///< Steps that end inside something solid.
  double walked_km = 0.0;       ///< [km] Sum over all people.
  double closest_pair_m = 0.0;  ///< [m] Least distance ever between two people's centres, once they
                                ///< are under way.
  std::int64_t robot_hits = 0;  ///< Collisions with a robot that drives its route at 0.4 m/s and
                                ///< never yields.
};

/// Runs the check. `on_hour` is called after every simulated hour. Throws std::runtime_error or
/// std::invalid_argument naming what is wrong.
CrowdHours watch_crowd(const CrowdHoursConfig& config,
                       const std::function<void(int hour)>& on_hour = {});

}  // namespace castaway::testbed
