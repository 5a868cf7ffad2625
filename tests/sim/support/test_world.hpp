/// A small room, its map and a robot for tests.
#pragma once

#include <string>
#include <vector>

#include "sim/map/grid.hpp"
#include "sim/robot/urdf/robot_model.hpp"
#include "sim/simulation.hpp"
#include "sim/world/world_spec.hpp"

namespace castaway::sim {

/// A wall or a piece of furniture: a box whose lower side is on the floor.
WorldObject box_on_floor(const std::string& name, const Eigen::Vector3d& size,
                         const Eigen::Vector2d& center, double yaw = 0.0);

/// A room of 8 m x 6 m about the origin, walls of 0.1 m, with a table, a shelf and a pillar.
WorldSpec test_room();

/// A robot of the Waffle class, built in code: no file, no lidar.
RobotModel test_robot();

/// The robot in the room, driving round the table; ideal sensors; 10 s.
SimulationConfig test_simulation();

/// The same with the errors of real sensors and a random kidnap at 4 s.
SimulationConfig noisy_kidnap_simulation();

/// Streams that differ by seed and from each other.
SimulationStreams test_streams(unsigned seed);

/// A grid from string art, first line on top: '#' occupied, '.' free, '?' unknown.
Grid grid_from_art(const std::vector<std::string>& lines, double resolution = 1.0);

/// The reverse.
std::vector<std::string> art_of(const Grid& grid);

}  // namespace castaway::sim
