#include "sim/difference/changed_beams.hpp"

#include <algorithm>
#include <cmath>

#include "sim/map/rasterise.hpp"

namespace castaway::sim {
namespace {

constexpr double kBeamRadius = 0.2;  // [m]
constexpr double kSpacing = 0.5;     // [m]
constexpr double kMostPlaces = 4e3;
constexpr double kFine = 0.1;    // [m]
constexpr double kCoarse = 0.2;  // [m]

/// The world as it was when its map was made.
WorldSpec as_surveyed(WorldSpec world) {
  for (WorldObject& object : world.objects) object.in_world = object.in_map;
  return world;
}

}  // namespace

BeamChange changed_beams(const WorldSpec& world, const Grid& map, const PlaceView& view) {
  Grid free_in_both = map;
  mark_objects(free_in_both, world, {view.z});
  const FreeSpace free(free_in_both, kBeamRadius);
  const auto cells = std::count(free.grid().cells.begin(), free.grid().cells.end(), Cell::kFree);
  const double area = static_cast<double>(cells) * map.resolution * map.resolution;
  const auto places = even_places(free, std::max(kSpacing, std::sqrt(area / kMostPlaces)));
  const RayScene before = level_scene(as_surveyed(world), view.z);
  const RayScene now = level_scene(world, view.z);
  long fine = 0;
  long coarse = 0;
  for (const Eigen::Vector2d& place : places) {
    const auto a = scan_at(before, place, 0.0, view);
    const auto b = scan_at(now, place, 0.0, view);
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double change = std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i]));
      fine += change > kFine ? 1 : 0;
      coarse += change > kCoarse ? 1 : 0;
    }
  }
  const double beams = std::max(1.0, static_cast<double>(places.size()) * view.beams);
  return {static_cast<double>(coarse) / beams, static_cast<double>(fine) / beams,
          static_cast<int>(places.size())};
}

}  // namespace castaway::sim
