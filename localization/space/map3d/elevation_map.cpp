#include "localization/space/map3d/elevation_map.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace castaway::localization {

std::span<const GroundSurface> ElevationMap::at(const Eigen::Vector2i& cell) const {
  if (!frame.contains(cell)) return {};
  const std::size_t i = frame.index(cell);
  return std::span(surfaces).subspan(first[i], first[i + 1] - first[i]);
}

void validate(const ElevationMap& map) {
  const GridFrame& frame = map.frame;
  const bool sized = frame.width > 0 && frame.height > 0 && frame.resolution >= 1e-6 &&
                     map.first.size() == frame.size() + 1 && map.first.front() == 0 &&
                     map.first.back() == map.surfaces.size() && std::ranges::is_sorted(map.first);
  if (!sized) throw std::invalid_argument("an elevation map's cells do not fit its surfaces");
  if (map.levels.empty() || !std::ranges::is_sorted(map.levels)) {
    throw std::invalid_argument("an elevation map needs levels, in ascending order");
  }
  for (const GroundSurface& surface : map.surfaces) {
    const bool finite = std::isfinite(surface.z) && std::isfinite(surface.slope_x) &&
                        std::isfinite(surface.slope_y) && surface.clearance >= 0.0F;
    if (!finite) throw std::invalid_argument("an elevation map has a surface that is not finite");
    if (surface.level >= map.levels.size()) {
      throw std::invalid_argument("an elevation map has a surface on a level that it has not");
    }
  }
}

const GroundSurface* surface_near(const ElevationMap& map, const Eigen::Vector2d& p_map, double z) {
  return ground_at(map, grid_from_map(map) * p_map, z).surface;
}

double ground_height(const ElevationMap& map, const Eigen::Vector2d& p_map, double z) {
  return ground_at(map, grid_from_map(map) * p_map, z).z;
}

GroundPoint ground_at(const ElevationMap& map, const Eigen::Vector2d& p_grid, double z) {
  const Eigen::Vector2i cell = map.frame.cell_of(p_grid);
  const GroundSurface* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const GroundSurface& surface : map.at(cell)) {
    const double away = std::abs(static_cast<double>(surface.z) - z);
    if (away >= least) continue;
    least = away;
    nearest = &surface;
  }
  if (nearest == nullptr) return {};
  const Eigen::Vector2d from_centre = p_grid - map.frame.centre_of(cell);
  return {nearest, static_cast<double>(nearest->z) +
                       static_cast<double>(nearest->slope_x) * from_centre.x() +
                       static_cast<double>(nearest->slope_y) * from_centre.y()};
}

}  // namespace castaway::localization
