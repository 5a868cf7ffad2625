/// Where the robot can stand and drive in a simulated run.
#pragma once

#include <vector>

#include "sim/map/free_space.hpp"
#include "sim/map/grid.hpp"
#include "sim/stages/simulation_config.hpp"

namespace castaway::sim {

/// The run's map with every object of the world marked that the robot's body could meet; ramps and
/// platforms are free, but for their ledges.
/// @throws std::invalid_argument if there is no map.
Grid drive_grid(const SimulationConfig& config);

/// Where a robot can be put down: the drive grid without ramps and platforms, since it is put onto
/// the floor.
Grid landing_grid(const SimulationConfig& config, Grid drive_grid);

/// The pose the run starts from: as given, or drawn.
/// @throws std::runtime_error if the robot would stand in something, or nothing is free.
Pose2 start_pose(const SimulationConfig& config, const Grid& drive_grid, Rng& rng);

/// Where the robot can stand without contact: half a cell of erosion is caution.
FreeSpace standing_space(const RobotModel& robot, const Grid& drive_grid);

/// Room that the planner keeps around the footprint. [m]
inline constexpr double kDriveMargin = 0.04;

}  // namespace castaway::sim
