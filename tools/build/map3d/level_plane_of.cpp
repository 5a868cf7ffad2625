#include "tools/build/map3d/level_plane_of.hpp"

#include <algorithm>

#include "tools/build/map3d/survey_world.hpp"

namespace castaway::testbed {
namespace {

constexpr double kOverlap = 1.5;    // [m] Of charts: more than planners keep from obstacles.
constexpr double kHeadroom = 0.05;  // [m] Above a robot.

sim::LevelCell cell_of(const localization::Atlas& atlas, const Eigen::Vector2i& at) {
  const localization::GroundSurface* surface = atlas.surface_at(at);
  if (surface == nullptr) return {};
  const Eigen::Vector2i own = atlas.own_cell(at);
  return {surface->z, surface->slope_x, surface->slope_y, surface->level,
          static_cast<std::int32_t>(atlas.frame().index(own))};
}

}  // namespace

sim::LevelPlane to_level_plane(const localization::Atlas& atlas) {
  const auto& frame = atlas.frame();
  sim::LevelPlane plane;
  plane.grid = sim::make_grid(frame.width, frame.height, frame.resolution,
                              frame.T_map_grid.translation(), sim::Cell::kOccupied);
  plane.stride = atlas.stride();
  plane.levels = static_cast<int>(atlas.ground().levels.size());
  plane.cells.resize(frame.size());
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const std::size_t i = frame.index({x, y});
      plane.cells[i] = cell_of(atlas, {x, y});
      if (plane.cells[i].own >= 0) plane.grid.cells[i] = sim::Cell::kFree;
    }
  }
  return plane;
}

std::shared_ptr<const Map3d> survey_floors(const sim::WorldSpec& world, double height) {
  Map3dOptions options;
  options.ground.clearance = std::max(options.ground.clearance, height + kHeadroom);
  return std::make_shared<const Map3d>(survey_world(world, options));
}

std::shared_ptr<const sim::LevelPlane> level_plane_of(const Map3d& map) {
  const localization::Atlas atlas(map.ground, kOverlap);
  return std::make_shared<const sim::LevelPlane>(to_level_plane(atlas));
}

}  // namespace castaway::testbed
