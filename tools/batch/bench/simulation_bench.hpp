/// CPU time of a simulated second over people, beams and obstacles, and the speed of ray casting.
#pragma once

#include <map>
#include <string>

namespace castaway::testbed {

/// A run without localizers: a lidar of 10 Hz and a moving robot, by physics at 240 Hz or
/// kinematically at 100 Hz.
struct SimulationCostSpec {
  int people = 0;
  int beams = 360;
  int obstacles = 0;         ///< 0: in the lab; otherwise this many boxes in a hall with 1.7 m^2
                             ///< per box.
  double duration_s = 60.0;  ///< [s] Simulated.
  bool kinematic = false;    ///< Without masses and contacts.
};

struct SimulationCost {
  SimulationCostSpec spec;
  double realtime_factor = 0.0;         ///< Simulated time over CPU time of one core.
  std::map<std::string, double> cpu_s;  ///< [s] CPU time by stage, from a separate run that
                                        ///< measures stages.
};

/// Runs the simulation. Throws std::runtime_error if there is no room for so many people.
SimulationCost time_simulation(const SimulationCostSpec& spec);

/// Speed of ray casts from places all over a hall of rotated boxes and walking people.
struct CastSpeed {
  int boxes = 0;
  int people = 0;
  double rays_per_s = 0.0;        ///< [1/s] On one core.
  double plain_rays_per_s = 0.0;  ///< [1/s] By a loop over all shapes with the same intersection
                                  ///< tests.
};
CastSpeed time_casts(int boxes, int people, double seconds);

}  // namespace castaway::testbed
