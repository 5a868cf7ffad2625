#include "localization/space/map3d/voxel_columns.hpp"

#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>

namespace castaway::localization {
namespace {

constexpr std::int64_t kMostCells = std::int64_t{1} << 28U;

/// The cells that hold the voxels.
struct CellBox {
  Eigen::Vector2i low = Eigen::Vector2i::Zero();  ///< Index of the voxels above cell (0, 0).
  GridFrame frame;

  [[nodiscard]] std::size_t cell_of(VoxelKey key) const {
    return frame.index(Eigen::Vector2i(voxel_index(key).head<2>() - low));
  }
};

CellBox box_of(const VoxelMap& map) {
  Eigen::Vector2i low = voxel_index(map.keys.front()).head<2>();
  Eigen::Vector2i high = low;
  for (const VoxelKey key : map.keys) {
    low = low.cwiseMin(voxel_index(key).head<2>());
    high = high.cwiseMax(voxel_index(key).head<2>());
  }
  const Eigen::Vector2i size = high - low + Eigen::Vector2i::Ones();
  if (size.cast<std::int64_t>().prod() > kMostCells) {
    throw std::invalid_argument("a 3-D map is too wide for its resolution: use larger voxels");
  }
  return {low,
          {size.x(),
           size.y(),
           map.resolution,
           {low.x() * map.resolution, low.y() * map.resolution, 0.0}}};
}

/// Voxels by cell, ascending in z.
struct CellOrder {
  std::vector<std::uint32_t> first;  ///< Of each cell, into `voxels`; one more at the end.
  std::vector<std::uint32_t> voxels;
};

CellOrder order_by_cell(const VoxelMap& map, const CellBox& box) {
  CellOrder order;
  order.first.assign(box.frame.size() + 1, 0);
  for (const VoxelKey key : map.keys) ++order.first[box.cell_of(key) + 1];
  std::partial_sum(order.first.begin(), order.first.end(), order.first.begin());
  std::vector<std::uint32_t> next(order.first.begin(), order.first.end() - 1);
  order.voxels.resize(map.size());
  for (std::size_t i = 0; i < map.size(); ++i) {  // Keys ascend in z, so each cell's do, too.
    order.voxels[next[box.cell_of(map.keys[i])]++] = static_cast<std::uint32_t>(i);
  }
  return order;
}

/// A voxel's surface, if nothing is within `clearance` above it. `above`: height of the next. [m]
std::optional<VoxelTop> top_of(const VoxelMap& map, std::size_t voxel, double above,
                               double clearance) {
  const Eigen::Vector3d p = map.point(voxel);
  if (map.faces_up[voxel] == 0 || above - p.z() < clearance) return std::nullopt;
  const Eigen::Vector2d cell = voxel_index(map.keys[voxel]).head<2>().cast<double>();
  const Eigen::Vector2d centre = (cell.array() + 0.5) * map.resolution;
  return VoxelTop{Eigen::Vector3d(p.x() - centre.x(), p.y() - centre.y(), p.z()).cast<float>(),
                  static_cast<float>(above - p.z())};
}

}  // namespace

VoxelColumns find_tops(const VoxelMap& map, double clearance) {
  const CellBox box = box_of(map);
  const CellOrder order = order_by_cell(map, box);
  VoxelColumns columns{box.frame, {0}, {}};
  for (std::size_t cell = 0; cell < box.frame.size(); ++cell) {
    const std::uint32_t end = order.first[cell + 1];
    for (std::uint32_t i = order.first[cell]; i < end; ++i) {
      const double above = i + 1 < end ? map.point(order.voxels[i + 1]).z()
                                       : std::numeric_limits<double>::infinity();
      if (const auto top = top_of(map, order.voxels[i], above, clearance)) {
        columns.tops.push_back(*top);
      }
    }
    columns.first.push_back(static_cast<std::uint32_t>(columns.tops.size()));
  }
  return columns;
}

}  // namespace castaway::localization
