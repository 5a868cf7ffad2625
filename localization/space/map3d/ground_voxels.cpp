#include "localization/space/map3d/ground_voxels.hpp"

#include <cmath>

namespace castaway::localization {
namespace {

constexpr int kAround = 2;          // [cells]
constexpr double kOffGround = 1.5;  // [voxels]

/// True if a surface, continued by its slope, passes a point within `most` in height. [m]
bool passes(const GroundSurface& surface, const Eigen::Vector2d& from_centre, double z,
            double most) {
  const double height =
      surface.z + surface.slope_x * from_centre.x() + surface.slope_y * from_centre.y();
  return surface.drivable && std::abs(height - z) <= most;
}

bool is_ground(const Eigen::Vector3d& p_map, const ElevationMap& ground, double most) {
  const Eigen::Vector2d p_grid = ground.frame.T_map_grid.inverse() * p_map.head<2>();
  const Eigen::Vector2i own = ground.frame.cell_of(p_grid);
  const auto at = [&](const Eigen::Vector2i& cell) {
    const Eigen::Vector2d from_centre = p_grid - ground.frame.centre_of(cell);
    for (const GroundSurface& surface : ground.at(cell)) {
      if (passes(surface, from_centre, p_map.z(), most)) return true;
    }
    return false;
  };
  if (at(own)) return true;
  for (int dy = -kAround; dy <= kAround; ++dy) {
    for (int dx = -kAround; dx <= kAround; ++dx) {
      if (at(own + Eigen::Vector2i(dx, dy))) return true;
    }
  }
  return false;
}

}  // namespace

VoxelMap without_ground(const VoxelMap& voxels, const ElevationMap& ground) {
  VoxelMap others;
  others.resolution = voxels.resolution;
  const double most = kOffGround * voxels.resolution;
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    if (voxels.faces_up[i] != 0 && is_ground(voxels.point(i), ground, most)) continue;
    others.keys.push_back(voxels.keys[i]);
    others.offsets.push_back(voxels.offsets[i]);
    others.faces_up.push_back(voxels.faces_up[i]);
  }
  return others;
}

}  // namespace castaway::localization
