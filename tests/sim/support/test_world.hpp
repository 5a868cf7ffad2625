/// A small room, its map and a robot for tests.
#pragma once

#include <string>
#include <vector>

#include "sim/map/grid.hpp"
#include "sim/robot/urdf/robot_model.hpp"
#include "sim/simulation.hpp"
#include "sim/world/world.hpp"

namespace castaway::sim {

/// A wall or a piece of furniture: a box that stands on the floor.
WorldObject box_on_floor(const std::string& name, const Eigen::Vector3d& size,
                         const Eigen::Vector2d& center, double yaw = 0.0);

/// A room of 8 m x 6 m centred at the origin, with walls of 0.1 m, a table, a shelf and a pillar.
WorldSpec test_room();

/// A robot similar to the Waffle, built in code without a file and without a lidar.
RobotModel test_robot();

/// The robot drives around the table in the room for 10 s, with ideal sensors.
SimulationConfig test_simulation();

/// As `test_simulation`, with real sensor errors and a random kidnap at 4 s.
SimulationConfig noisy_kidnap_simulation();

/// Streams that differ by seed and name.
SimulationStreams test_streams(unsigned seed);

/// A grid from string art, first line on top: '#' occupied, '.' free, '?' unknown.
Grid grid_from_art(const std::vector<std::string>& lines, double resolution = 1.0);

/// The inverse of `grid_from_art`.
std::vector<std::string> art_of(const Grid& grid);

}  // namespace castaway::sim
