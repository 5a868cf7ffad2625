#include "sim/map/open_ground.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "sim/map/grid_tools.hpp"

namespace castaway::sim {
namespace {

constexpr double kWhole = 100.0;    // [m] A plane with sides up to this length counts completely.
constexpr double kOfLarger = 50.0;  // [m] Margin around the objects on a larger plane.
constexpr double kOfEndless = 15.0;
constexpr float kInSight = 5.0F;  // [m] Well within the range of small robots' lidars.

Eigen::AlignedBox2d grow_extent(const WorldSpec& world, double by) {
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(by);
  return {world.min_corner - margin, world.max_corner + margin};
}

}  // namespace

std::optional<std::string> extend_over(const Ground& ground, WorldSpec& world) {
  std::optional<std::string> line;
  Eigen::AlignedBox2d box = ground.extent;
  if (box.isEmpty()) {
    box = grow_extent(world, kOfEndless);
    line = fmt::format("the ground plane has no size: it is used up to {} m around the objects",
                       kOfEndless);
  } else if (box.sizes().maxCoeff() > kWhole) {
    const Eigen::Vector2d size = box.sizes();
    const Eigen::AlignedBox2d near = box.intersection(grow_extent(world, kOfLarger));
    if (!near.isApprox(box)) {
      line = fmt::format(
          "the ground plane of {:.6g} m x {:.6g} m is used up to {} m around the objects", size.x(),
          size.y(), kOfLarger);
    }
    box = near;
  }
  if (box.isEmpty()) return std::nullopt;
  world.min_corner = world.min_corner.cwiseMin(box.min());
  world.max_corner = world.max_corner.cwiseMax(box.max());
  return line;
}

Grid near_obstacles(Grid grid) {
  const std::vector<float> distance = distance_to_obstacle(grid, GridEdge::kOpen);
  if (std::find(distance.begin(), distance.end(), 0.0F) == distance.end()) return grid;
  for (std::size_t i = 0; i < distance.size(); ++i) {
    if (distance[i] > kInSight) grid.cells[i] = Cell::kUnknown;
  }
  return grid;
}

}  // namespace castaway::sim
