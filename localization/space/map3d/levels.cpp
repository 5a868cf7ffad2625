#include "localization/space/map3d/levels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "localization/space/map3d/ground_walk.hpp"

namespace castaway::localization {
namespace {

constexpr float kStep = 0.03F;       // [m] Between neighbouring cells of one floor.
constexpr float kBelowFloor = 0.3F;  // [m] A floor's own unevenness, and sills.
constexpr std::size_t kMostLevels = 255;

/// A floor: connected level surfaces.
struct Floor {
  double height = 0.0;  ///< [m] Mean.
  double area = 0.0;    ///< [m^2]
};

/// All floors, of any area.
std::vector<Floor> find_floors(const ElevationMap& map, double slope) {
  const auto is_level = [&](const GroundSurface& surface) {
    const auto rise = static_cast<double>(std::hypot(surface.slope_x, surface.slope_y));
    return surface.drivable && rise <= slope;
  };
  const double cell_area = map.frame.resolution * map.frame.resolution;
  std::vector<Floor> floors;
  GroundWalk walk(map, kStep);
  for_each_surface(map, [&](const SurfaceAt& at) {
    double sum = 0.0;
    const std::size_t count = walk.from(at, is_level, [&](std::size_t index) {
      sum += static_cast<double>(map.surfaces[index].z);
    });
    if (count == 0) return;
    floors.push_back({sum / static_cast<double>(count), static_cast<double>(count) * cell_area});
  });
  return floors;
}

/// Heights of the floors, ascending; floors of nearly one height are joined by their area.
std::vector<float> join_floors(std::vector<Floor> floors, double height) {
  std::ranges::sort(floors, {}, &Floor::height);
  std::vector<Floor> joined;
  for (const Floor& floor : floors) {
    if (!joined.empty() && floor.height - joined.back().height < height) {
      Floor& below = joined.back();
      const double area = below.area + floor.area;
      below.height = (below.height * below.area + floor.height * floor.area) / area;
      below.area = area;
    } else if (joined.size() < kMostLevels) {
      joined.push_back(floor);
    }
  }
  std::vector<float> heights;
  for (const Floor& floor : joined) heights.push_back(static_cast<float>(floor.height));
  return heights;
}

float lowest_ground(const ElevationMap& map) {
  float lowest = std::numeric_limits<float>::infinity();
  for (const GroundSurface& surface : map.surfaces) {
    if (surface.drivable) lowest = std::min(lowest, surface.z);
  }
  return std::isfinite(lowest) ? lowest : 0.0F;
}

}  // namespace

void label_levels(ElevationMap& map, const LevelConfig& config) {
  std::vector<Floor> floors = find_floors(map, config.slope);
  std::erase_if(floors, [&](const Floor& floor) { return floor.area < config.area; });
  map.levels = join_floors(std::move(floors), config.height);
  if (map.levels.empty()) map.levels.push_back(lowest_ground(map));
  for (GroundSurface& surface : map.surfaces) {
    const auto above = std::ranges::upper_bound(map.levels, surface.z + kBelowFloor);
    const auto count = std::max<std::ptrdiff_t>(above - map.levels.begin(), 1);
    surface.level = static_cast<std::uint8_t>(count - 1);
  }
}

}  // namespace castaway::localization
