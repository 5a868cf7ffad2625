#include "localization/space/map3d/survey_ground.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

#include <Eigen/Dense>

#include "localization/space/map3d/ground_walk.hpp"
#include "localization/space/map3d/levels.hpp"
#include "localization/space/map3d/voxel_columns.hpp"

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

constexpr int kNeighbours = 6;  // Of eight, that a drivable surface needs.

/// The top of a cell that continues one at the height `z`; null if none is within `window`. [m]
const VoxelTop* continue_at(std::span<const VoxelTop> tops, float z, float window) {
  const VoxelTop* nearest = nullptr;
  for (const VoxelTop& top : tops) {
    if (std::abs(top.p.z() - z) > window) continue;
    if (nearest == nullptr || std::abs(top.p.z() - z) < std::abs(nearest->p.z() - z)) {
      nearest = &top;
    }
  }
  return nearest;
}

/// How planes are fitted to the ground.
struct PlaneFit {
  int radius = 1;        ///< [cells]
  float window = 0.0F;   ///< [m] In height.
  double max_slope = 0;  ///< Of drivable ground.
};

/// On a rough map slopes are stairs: planes reach farther.
PlaneFit fit_of(const VoxelMap& map, double max_slope) {
  const int radius = is_rough(map) ? 3 : 1;
  const double window = map.resolution * (1.5 * radius * max_slope + 0.5);
  return {radius, static_cast<float>(window), max_slope};
}

/// The plane through a top and those around it, by least squares.
GroundSurface fit_surface(const VoxelColumns& columns, const Eigen::Vector2i& cell,
                          const VoxelTop& top, const PlaneFit& fit) {
  Eigen::Matrix3d normal = Eigen::Vector3d(1e-9, 1e-9, 0.0).asDiagonal();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  int neighbours = -1;  // Without itself.
  for (int y = -fit.radius; y <= fit.radius; ++y) {
    for (int x = -fit.radius; x <= fit.radius; ++x) {
      const auto tops = columns.at(cell + Eigen::Vector2i(x, y));
      const VoxelTop* other = continue_at(tops, top.p.z(), fit.window);
      if (other == nullptr) continue;
      if (std::abs(x) <= 1 && std::abs(y) <= 1) ++neighbours;
      const Eigen::Vector3d row(static_cast<double>(other->p.x()) + x * columns.frame.resolution,
                                static_cast<double>(other->p.y()) + y * columns.frame.resolution,
                                1.0);
      normal += row * row.transpose();
      right += row * static_cast<double>(other->p.z() - top.p.z());
    }
  }
  const Eigen::Vector3d plane = normal.ldlt().solve(right);
  const bool gentle = plane.head<2>().norm() <= fit.max_slope;
  return {top.p.z() + static_cast<float>(plane.z()),
          static_cast<float>(plane.x()),
          static_cast<float>(plane.y()),
          top.clearance,
          0,
          gentle && neighbours >= kNeighbours};
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

void validate(const GroundConfig& config) {
  const bool fine = config.clearance > 0.0 && config.max_slope > 0.0 && config.max_slope <= 1.7 &&
                    config.step > 0.0 && config.level_slope >= 0.0 && config.level_area > 0.0 &&
                    config.level_height > 0.0;
  if (!fine) throw std::invalid_argument("settings of the survey of the ground are out of range");
}

ElevationMap survey_ground(const VoxelMap& map, const GroundConfig& config,
                           const std::optional<Eigen::Vector3d>& start) {
  validate(map);
  validate(config);
  if (map.size() == 0) throw std::invalid_argument("a 3-D map without surfaces has no ground");
  const VoxelColumns columns = find_tops(map, config.clearance);
  const PlaneFit fit = fit_of(map, config.max_slope);
  ElevationMap ground;
  ground.frame = columns.frame;
  ground.first = columns.first;
  ground.surfaces.reserve(columns.tops.size());
  for (int y = 0; y < columns.frame.height; ++y) {
    for (int x = 0; x < columns.frame.width; ++x) {
      for (const VoxelTop& top : columns.at({x, y})) {
        ground.surfaces.push_back(fit_surface(columns, {x, y}, top, fit));
      }
    }
  }
  keep_reachable(ground, start, config.step);
  label_levels(ground, {config.level_slope, config.level_area, config.level_height});
  return ground;
}

}  // namespace castaway::localization
