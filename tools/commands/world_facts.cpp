#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "sim/world/ground.hpp"
#include "sim/world/rasterise.hpp"
#include "tools/commands/world_report.hpp"

namespace castaway::testbed {
namespace {

constexpr double kRadius = 0.25;     // [m] Of the disc that ambiguity is looked for with.
constexpr double kTightRoute = 0.3;  // [m]

/// Where a robot stands on the floor itself.
sim::Grid on_the_floor(const LoadedWorld& world, sim::Grid grid) {
  sim::mark_raised(grid, sim::ground_heights(world.file.spec, grid));
  return grid;
}

/// The map with all that a low robot could run into.
sim::Grid obstacles(const LoadedWorld& world) {
  sim::Grid grid = world.grid;
  std::vector<double> heights;
  for (double z = 0.02; z < 0.35; z += 0.04) heights.push_back(z);
  const std::vector<float> ground = sim::ground_heights(world.file.spec, grid);
  sim::free_raised(grid, ground);
  sim::mark_objects(grid, world.file.spec, heights);
  sim::mark_ledges(grid, ground);
  return grid;
}

RouteFacts facts_of(const std::string& name, const std::vector<Eigen::Vector2d>& route,
                    const sim::FreeSpace& space) {
  RouteFacts facts{name, 0.0, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < route.size(); ++i) {
    const Eigen::Vector2d& from = route[i];
    const Eigen::Vector2d& to = route[(i + 1) % route.size()];
    const double length = (to - from).norm();
    facts.length += length;
    const int steps = static_cast<int>(length / 0.02) + 1;
    for (int k = 0; k <= steps; ++k) {
      const sim::CellIndex cell = sim::cell_of(space.grid(), from + (to - from) * k / steps);
      const bool inside = space.grid().contains(cell.column, cell.row);
      const double room =
          inside ? static_cast<double>(space.clearance()[sim::flat_index(space.grid(), cell)])
                 : 0.0;
      facts.clearance = std::min(facts.clearance, room);
    }
  }
  return facts;
}

void warn(const LoadedWorld& world, const sim::FreeSpace& space, WorldFacts& facts) {
  facts.warnings = world.warnings;
  for (const RouteFacts& route : facts.routes) {
    if (route.clearance >= kTightRoute) continue;
    facts.warnings.push_back(
        fmt::format("route {} passes within {:.2f} m of an obstacle", route.name, route.clearance));
  }
  if (world.has_start && !space.contains(world.file.start.position())) {
    facts.warnings.push_back(
        fmt::format("the start ({}, {}) is not free", world.file.start.x, world.file.start.y));
  }
  if (facts.ambiguity.places == 0) {
    facts.warnings.emplace_back("no free space for a robot: check the extent and the heights");
  }
}

}  // namespace

WorldFacts world_facts(const LoadedWorld& world, const sim::PlaceView& view) {
  WorldFacts facts;
  const auto free = std::count(world.grid.cells.begin(), world.grid.cells.end(), sim::Cell::kFree);
  facts.free_area = static_cast<double>(free) * world.grid.resolution * world.grid.resolution;
  const sim::Grid drive = obstacles(world);
  const sim::FreeSpace way(drive, kRadius);
  const sim::FreeSpace space(on_the_floor(world, drive), kRadius);
  for (const auto& [name, route] : world.file.routes) {
    facts.routes.push_back(facts_of(name, route, way));
  }
  facts.change = sim::changed_beams(world.file.spec, world.grid, view);
  facts.ambiguity =
      sim::ambiguity(sim::RayScene(sim::ray_primitives(world.file.spec)), space, view);
  warn(world, space, facts);
  return facts;
}

}  // namespace castaway::testbed
