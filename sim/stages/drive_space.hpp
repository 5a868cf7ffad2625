/// Where the robot can stand and drive in a simulated run.
#pragma once

#include <vector>

#include "sim/map/free_space.hpp"
#include "sim/map/grid.hpp"
#include "sim/stages/simulation_config.hpp"
#include "sim/stages/spaces.hpp"

namespace castaway::sim {

/// The run's map with every object of the world marked that the robot's body could meet. Ramps and
/// platforms are free, except for their ledges.
/// @throws std::invalid_argument if there is no map.
Grid drive_grid(const SimulationConfig& config);

/// Where a robot can be put down: the drive grid without ramps and platforms, since the robot is
/// put onto the floor.
Grid landing_grid(const SimulationConfig& config, Grid drive_grid);

/// The pose at the start of the run, as configured or drawn.
/// @throws std::runtime_error if the robot would stand in an obstacle, or nothing is free.
Pose2 start_pose(const SimulationConfig& config, Spaces& spaces, Rng& rng);

/// [m] Radius of a disc that stands without contact where the robot does: reduced by a cell, since
/// erosion errs on the safe side.
double standing_radius(const SimulationConfig& config);

/// [m] Room that the planner keeps around the footprint.
inline constexpr double kDriveMargin = 0.04;

}  // namespace castaway::sim
