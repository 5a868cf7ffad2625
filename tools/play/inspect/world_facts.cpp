#include "tools/play/inspect/world_facts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "tools/play/inspect/world_likeness.hpp"

namespace castaway::testbed {
namespace {

constexpr double kTightRoute = 0.3;  // [m]

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
  const sim::FreeSpace way(obstacle_grid(world), kPlaceRadius);
  const sim::FreeSpace space = place_space(world);
  for (const auto& [name, route] : world.file.routes) {
    facts.routes.push_back(facts_of(name, route, way));
  }
  facts.change = sim::changed_beams(world.file.spec, world.grid, view);
  facts.ambiguity = sim::ambiguity_of(world_likeness(world, view));
  warn(world, space, facts);
  return facts;
}

}  // namespace castaway::testbed
