/// What a simulated second costs, over people, beams and obstacles, and how fast beams are cast.
#pragma once

#include <map>
#include <string>

namespace castaway::testbed {

/// A run without localizers: a lidar of 10 Hz, the robot driving, by physics at 240 Hz or
/// kinematically at 100 Hz.
struct SimulationCostSpec {
  int people = 0;
  int beams = 360;
  int obstacles = 0;         ///< 0: in the lab; else so many boxes in a hall with 1.7 m^2 for each.
  double duration_s = 60.0;  ///< [s] Simulated.
  bool kinematic = false;    ///< No masses, no contacts.
};

/// What it took.
struct SimulationCost {
  SimulationCostSpec spec;
  double realtime_factor = 0.0;         ///< Simulated time over CPU time of one core.
  std::map<std::string, double> cpu_s;  ///< [s] By stage, in a run that measures them.
};

/// Runs it. Throws std::runtime_error if there is no room for so many people.
SimulationCost time_simulation(const SimulationCostSpec& spec);

/// How fast beams are cast from places all over a hall of turned boxes with people in mid-step.
struct CastSpeed {
  int boxes = 0;
  int people = 0;
  double rays_per_s = 0.0;        ///< [1/s] One core.
  double plain_rays_per_s = 0.0;  ///< [1/s] By a loop over all shapes, same intersections.
};
CastSpeed time_casts(int boxes, int people, double seconds);

}  // namespace castaway::testbed
