#include "localization/map3d/survey_ground.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>

#include <Eigen/Dense>

#include "localization/map3d/levels.hpp"

namespace castaway::localization {
namespace {

constexpr int kNeighbours = 6;  // Of eight, that a drivable surface needs.
constexpr std::int64_t kMostCells = std::int64_t{1} << 28U;

/// A voxel with room above.
struct Top {
  Eigen::Vector3f p;       ///< [m] From the cell's centre; z in map.
  float clearance = 0.0F;  ///< [m]
};

/// Tops by cell, ascending in z.
struct Columns {
  GridFrame frame;
  std::vector<std::uint32_t> first;
  std::vector<Top> tops;

  [[nodiscard]] std::span<const Top> at(const Eigen::Vector2i& cell) const {
    if (!frame.contains(cell)) return {};
    const std::size_t i = frame.index(cell);
    return std::span(tops).subspan(first[i], first[i + 1] - first[i]);
  }
};

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
std::optional<Top> top_of(const VoxelMap& map, std::size_t voxel, double above, double clearance) {
  const Eigen::Vector3d p = map.point(voxel);
  if (above - p.z() < clearance) return std::nullopt;
  const Eigen::Vector2d cell = voxel_index(map.keys[voxel]).head<2>().cast<double>();
  const Eigen::Vector2d centre = (cell.array() + 0.5) * map.resolution;
  return Top{Eigen::Vector3d(p.x() - centre.x(), p.y() - centre.y(), p.z()).cast<float>(),
             static_cast<float>(above - p.z())};
}

Columns find_tops(const VoxelMap& map, double clearance) {
  const CellBox box = box_of(map);
  const CellOrder order = order_by_cell(map, box);
  Columns columns{box.frame, {0}, {}};
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

/// The top of a cell that continues one at the height `z`; null if none is within `window`. [m]
const Top* continue_at(std::span<const Top> tops, float z, float window) {
  const Top* nearest = nullptr;
  for (const Top& top : tops) {
    if (std::abs(top.p.z() - z) > window) continue;
    if (nearest == nullptr || std::abs(top.p.z() - z) < std::abs(nearest->p.z() - z)) {
      nearest = &top;
    }
  }
  return nearest;
}

/// The plane through a top and those around it, by least squares.
GroundSurface fit_surface(const Columns& columns, const Eigen::Vector2i& cell, const Top& top,
                          const GroundConfig& config) {
  const auto edge = static_cast<float>(columns.frame.resolution);
  const float window = edge * (1.5F * static_cast<float>(config.max_slope) + 0.5F);
  Eigen::Matrix3d normal = Eigen::Vector3d(1e-9, 1e-9, 0.0).asDiagonal();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  int neighbours = -1;  // Without itself.
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      const Top* other = continue_at(columns.at(cell + Eigen::Vector2i(x, y)), top.p.z(), window);
      if (other == nullptr) continue;
      ++neighbours;
      const Eigen::Vector3d row(static_cast<double>(other->p.x()) + x * columns.frame.resolution,
                                static_cast<double>(other->p.y()) + y * columns.frame.resolution,
                                1.0);
      normal += row * row.transpose();
      right += row * static_cast<double>(other->p.z() - top.p.z());
    }
  }
  const Eigen::Vector3d plane = normal.ldlt().solve(right);
  const bool gentle = plane.head<2>().norm() <= config.max_slope;
  return {top.p.z() + static_cast<float>(plane.z()),
          static_cast<float>(plane.x()),
          static_cast<float>(plane.y()),
          top.clearance,
          0,
          gentle && neighbours >= kNeighbours};
}

}  // namespace

void validate(const GroundConfig& config) {
  const bool fine = config.clearance > 0.0 && config.max_slope > 0.0 && config.max_slope <= 1.7 &&
                    config.level_slope >= 0.0 && config.level_area > 0.0 &&
                    config.level_height > 0.0;
  if (!fine) throw std::invalid_argument("settings of the survey of the ground are out of range");
}

ElevationMap survey_ground(const VoxelMap& map, const GroundConfig& config) {
  validate(map);
  validate(config);
  if (map.size() == 0) throw std::invalid_argument("a 3-D map without surfaces has no ground");
  const Columns columns = find_tops(map, config.clearance);
  ElevationMap ground;
  ground.frame = columns.frame;
  ground.first = columns.first;
  ground.surfaces.reserve(columns.tops.size());
  for (int y = 0; y < columns.frame.height; ++y) {
    for (int x = 0; x < columns.frame.width; ++x) {
      for (const Top& top : columns.at({x, y})) {
        ground.surfaces.push_back(fit_surface(columns, {x, y}, top, config));
      }
    }
  }
  label_levels(ground, {config.level_slope, config.level_area, config.level_height});
  return ground;
}

}  // namespace castaway::localization
