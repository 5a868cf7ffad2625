/// The columns of a 3-D map: what may be ground, cell by cell.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "localization/map/occupancy_grid.hpp"
#include "localization/space/map3d/voxel_map.hpp"

namespace castaway::localization {

/// A voxel with room above.
struct VoxelTop {
  Eigen::Vector3f p;       ///< [m] From the cell's centre; z in map.
  float clearance = 0.0F;  ///< [m]
};

/// Tops by cell, ascending in z.
struct VoxelColumns {
  GridFrame frame;
  std::vector<std::uint32_t> first;
  std::vector<VoxelTop> tops;

  [[nodiscard]] std::span<const VoxelTop> at(const Eigen::Vector2i& cell) const {
    if (!frame.contains(cell)) return {};
    const std::size_t i = frame.index(cell);
    return std::span(tops).subspan(first[i], first[i + 1] - first[i]);
  }
};

/// Finds the surfaces that face up with nothing within `clearance` [m] above them. Cells are as
/// large as voxels. Requires a map that is not empty. @throws std::invalid_argument if its cells
/// would be too many.
VoxelColumns find_tops(const VoxelMap& map, double clearance);

}  // namespace castaway::localization
