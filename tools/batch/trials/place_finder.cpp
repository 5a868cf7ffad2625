#include "tools/batch/trials/place_finder.hpp"

#include "localization/map/ray_cast.hpp"
#include "localization/search/map_search.hpp"

namespace castaway::testbed {
namespace {

using localization::SE2;

constexpr double kBlocked = 0.3;  // [m]

}  // namespace

PlaceFinder::PlaceFinder(const localization::MhAmclConfig& config,
                         const localization::OccupancyGrid& map)
    : models_(config, map) {}

std::vector<FoundPlace> PlaceFinder::find(const localization::ScanPoints& points) const {
  std::vector<FoundPlace> found;
  for (const auto& place : find_places(models_.context, *models_.matcher, points)) {
    found.push_back({place.T_map_base, place.newest.log_likelihood});
  }
  return found;
}

FoundPlace PlaceFinder::refine(const localization::ScanPoints& points,
                               const SE2& T_map_base) const {
  const auto places = refine_candidates(models_.context, {{T_map_base, 0.0}}, points);
  return {places.front().T_map_base, places.front().newest.log_likelihood};
}

double PlaceFinder::blocked_share(const localization::ScanPoints& points,
                                  const SE2& T_map_base) const {
  if (points.empty()) return 0.0;
  const localization::OccupancyGrid& grid = std::get<localization::PlanarMap>(models_.ground).grid;
  const double resolution = grid.frame.resolution;
  const SE2 T_grid_base = grid.frame.T_map_grid.inverse() * T_map_base;
  int blocked = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d from =
        T_grid_base * Eigen::Vector2d(points.origin_x[i], points.origin_y[i]);
    const Eigen::Vector2d to = T_grid_base * Eigen::Vector2d(points.x[i], points.y[i]);
    const double longest = static_cast<double>(points.range[i]) + kBlocked;
    const double way = resolution * cast_ray(grid, from / resolution, (to - from).normalized(),
                                             longest / resolution);
    if (way >= longest) ++blocked;
  }
  return static_cast<double>(blocked) / static_cast<double>(points.size());
}

}  // namespace castaway::testbed
