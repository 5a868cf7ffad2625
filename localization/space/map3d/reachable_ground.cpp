#include "localization/space/map3d/reachable_ground.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "localization/space/map3d/ground_walk.hpp"

namespace castaway::localization {
namespace {

bool is_drivable(const GroundSurface& surface) { return surface.drivable; }

/// Number of the connected part of each surface; 0: not drivable.
struct Parts {
  std::vector<std::uint32_t> of_surface;
  std::vector<std::size_t> sizes{0};  ///< By number.
};

Parts number_parts(const ElevationMap& map, double step) {
  Parts parts;
  parts.of_surface.assign(map.surfaces.size(), 0);
  GroundWalk walk(map, static_cast<float>(step));
  for_each_surface(map, [&](const SurfaceAt& at) {
    const auto number = static_cast<std::uint32_t>(parts.sizes.size());
    const std::size_t size =
        walk.from(at, is_drivable, [&](std::size_t index) { parts.of_surface[index] = number; });
    if (size > 0) parts.sizes.push_back(size);
  });
  return parts;
}

/// The part of the drivable surface nearest to a point; 0 if none is within a metre.
std::uint32_t part_at(const ElevationMap& map, const Parts& parts, const Eigen::Vector3d& p_map) {
  std::uint32_t part = 0;
  double least = 1.0;
  for_each_surface(map, [&](const SurfaceAt& at) {
    const Eigen::Vector2d p = map.frame.T_map_grid * map.frame.centre_of(at.cell);
    const Eigen::Vector3d centre(p.x(), p.y(), static_cast<double>(map.surfaces[at.index].z));
    const double away = (centre - p_map).norm();
    if (parts.of_surface[at.index] == 0 || away >= least) return;
    least = away;
    part = parts.of_surface[at.index];
  });
  return part;
}

}  // namespace

void keep_reachable(ElevationMap& map, const std::optional<Eigen::Vector3d>& start, double step) {
  const Parts parts = number_parts(map, step);
  std::uint32_t kept = start ? part_at(map, parts, *start) : 0;
  if (kept == 0) {
    const auto largest = std::ranges::max_element(parts.sizes);
    kept = static_cast<std::uint32_t>(largest - parts.sizes.begin());
  }
  for (std::size_t i = 0; i < map.surfaces.size(); ++i) {
    if (parts.of_surface[i] != kept) map.surfaces[i].drivable = false;
  }
}

}  // namespace castaway::localization
