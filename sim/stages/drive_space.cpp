#include "sim/stages/drive_space.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/common/cell_index.hpp"
#include "sim/map/ground.hpp"
#include "sim/map/rasterise.hpp"
#include "sim/world/floor.hpp"

namespace castaway::sim {
namespace {

// [m] Thinner boards may pass between two slices of a tall robot.
constexpr double kSliceStep = 0.04;

}  // namespace

Grid drive_grid(const SimulationConfig& config) {
  if (config.map.cells.empty()) {
    throw std::invalid_argument("simulation: the map has no cells: rasterise the world first");
  }
  Grid grid = config.map;
  const double height = config.robot.height;
  const int slices = std::max(4, cell_index(std::ceil(height / kSliceStep)));
  std::vector<double> heights{kFloorTop + 0.001, 0.02};
  for (int i = 1; i <= slices; ++i) heights.push_back(height * i / slices);
  const std::vector<float> ground = ground_heights(config.world, grid);
  free_raised(grid, ground);
  mark_objects(grid, config.world, heights);
  mark_ledges(grid, ground);
  return grid;
}

Grid landing_grid(const SimulationConfig& config, Grid drive_grid) {
  mark_raised(drive_grid, ground_heights(config.world, drive_grid));
  return drive_grid;
}

Pose2 start_pose(const SimulationConfig& config, Spaces& spaces, Rng& rng) {
  if (!config.drive.path.empty()) return pose_at(config.drive.path, 0.0);
  const double radius = config.robot.footprint_radius;
  if (config.random_start) {
    const auto pose = spaces.landing(config, radius + kDriveMargin).sample(rng);
    if (pose) return *pose;
    throw std::runtime_error(fmt::format(
        "start: no free place for a robot of radius {:.2f} m: check the map and its scale",
        radius));
  }
  const FreeSpace standing = spaces.landing(config, standing_radius(config));
  if (standing.contains(config.start.position())) return config.start;
  throw std::runtime_error(fmt::format(
      "start: at ({}, {}) a robot of radius {:.2f} m stands in an obstacle or outside of the free "
      "space: move it",
      config.start.x, config.start.y, radius));
}

double standing_radius(const SimulationConfig& config) {
  return std::max(config.robot.footprint_radius - config.map.resolution, 0.0);
}

}  // namespace castaway::sim
