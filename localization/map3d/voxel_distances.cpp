#include "localization/map3d/voxel_distances.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "localization/map/cell_index.hpp"

namespace castaway::localization {
namespace {

constexpr std::int64_t kMostBlocks = std::int64_t{1} << 27U;  // Of the table, stored or not.
constexpr std::uint8_t kFar = 255;

double square_of(double value) { return value * value; }

/// Position of a voxel in its block of 8 x 8 x 8; the first block begins at voxel 0.
std::size_t place_in_block(const Eigen::Vector3i& voxel) {
  return static_cast<std::size_t>(((voxel.z() & 7) << 6) | ((voxel.y() & 7) << 3) |
                                  (voxel.x() & 7));
}

}  // namespace

VoxelDistances::VoxelDistances(const VoxelMap& map, double max_distance)
    : resolution_(map.resolution), max_distance_(max_distance) {
  validate(map);
  if (!(max_distance >= map.resolution && max_distance <= 16.0 * map.resolution)) {
    throw std::invalid_argument("distances of a 3-D map reach 1 to 16 voxels");
  }
  scale_ = static_cast<float>(max_distance / kFar);
  // Interpolation reads one voxel beyond; the surface point lies anywhere in its voxel.
  const int reach = static_cast<int>(std::ceil(max_distance / resolution_)) + 1;
  if (map.size() == 0) return;
  lay_out(map, reach);
  spread(map, reach);
}

/// Reserves the blocks within `reach` voxels of a surface.
void VoxelDistances::lay_out(const VoxelMap& map, int reach) {
  Eigen::Vector3i low = voxel_index(map.keys.front());
  Eigen::Vector3i high = low;
  for (const VoxelKey key : map.keys) {
    low = low.cwiseMin(voxel_index(key));
    high = high.cwiseMax(voxel_index(key));
  }
  first_ = low.array() - reach;
  size_ = (high - first_).array() + reach;
  size_ = size_ / kEdge + Eigen::Vector3i::Ones();
  if (size_.cast<std::int64_t>().prod() > kMostBlocks) {
    throw std::invalid_argument("a 3-D map is too large for its resolution: use larger voxels");
  }
  table_.assign(static_cast<std::size_t>(size_.cast<std::int64_t>().prod()), -1);
  for (const VoxelKey key : map.keys) {
    const Eigen::Vector3i voxel = voxel_index(key) - first_;
    const Eigen::Vector3i from = (voxel.array() - reach) / kEdge;
    const Eigen::Vector3i to = (voxel.array() + reach) / kEdge;
    for (int z = from.z(); z <= to.z(); ++z) {
      for (int y = from.y(); y <= to.y(); ++y) {
        for (int x = from.x(); x <= to.x(); ++x) table_[table_index({x, y, z})] = 0;
      }
    }
  }
  std::int32_t count = 0;
  for (std::int32_t& block : table_) {
    if (block == 0) block = count++;
  }
  blocks_.resize(static_cast<std::size_t>(count));
  for (Block& block : blocks_) block.fill(kFar);
}

/// Every surface point lowers the distances around it.
void VoxelDistances::spread(const VoxelMap& map, int reach) {
  for (std::size_t i = 0; i < map.size(); ++i) {
    spread(voxel_index(map.keys[i]), map.point(i) / resolution_, reach);
  }
}

/// `point`: in edges of a voxel. Rows of voxels are cut to the ball around it.
void VoxelDistances::spread(const Eigen::Vector3i& voxel, const Eigen::Vector3d& point, int reach) {
  const Eigen::Vector3d to_centre = voxel.cast<double>().array() + 0.5 - point.array();
  const double radius = max_distance_ / resolution_;
  const double units = resolution_ / static_cast<double>(scale_);
  for (int z = -reach; z <= reach; ++z) {
    for (int y = -reach; y <= reach; ++y) {
      const double away = square_of(to_centre.z() + z) + square_of(to_centre.y() + y);
      const double left = square_of(radius) - away;
      if (left <= 0.0) continue;
      const double half = std::sqrt(left);
      const int last = static_cast<int>(std::floor(half - to_centre.x()));
      for (int x = static_cast<int>(std::ceil(-half - to_centre.x())); x <= last; ++x) {
        const double distance = std::sqrt(away + square_of(to_centre.x() + x));
        lower(voxel + Eigen::Vector3i(x, y, z), static_cast<std::uint8_t>(units * distance + 0.5));
      }
    }
  }
}

std::size_t VoxelDistances::table_index(const Eigen::Vector3i& block) const {
  const auto width = static_cast<std::size_t>(size_.x());
  const auto height = static_cast<std::size_t>(size_.y());
  return (static_cast<std::size_t>(block.z()) * height + static_cast<std::size_t>(block.y())) *
             width +
         static_cast<std::size_t>(block.x());
}

void VoxelDistances::lower(const Eigen::Vector3i& voxel, std::uint8_t distance) {
  const Eigen::Vector3i local = voxel - first_;
  const auto block = static_cast<std::size_t>(table_[table_index(local / kEdge)]);
  std::uint8_t& stored = blocks_[block][place_in_block(local)];
  stored = std::min(stored, distance);
}

std::uint8_t VoxelDistances::byte_at(const Eigen::Vector3i& voxel) const {
  const Eigen::Vector3i local = voxel - first_;
  if (local.minCoeff() < 0 || ((local / kEdge).array() >= size_.array()).any()) return kFar;
  const std::int32_t block = table_[table_index(local / kEdge)];
  return block < 0 ? kFar : blocks_[static_cast<std::size_t>(block)][place_in_block(local)];
}

float VoxelDistances::at(const Eigen::Vector3f& p_map) const {
  const Eigen::Vector3f lattice = p_map.array() / static_cast<float>(resolution_) - 0.5F;
  const Eigen::Vector3i low(cell_index(lattice.x()), cell_index(lattice.y()),
                            cell_index(lattice.z()));
  const Eigen::Vector3f t = (lattice - low.cast<float>()).array().max(0.0F).min(1.0F);
  float sum = 0.0F;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3i step(corner & 1, (corner >> 1) & 1, corner >> 2);
    const Eigen::Vector3f weight = (step.array() == 1).select(t.array(), 1.0F - t.array());
    sum += weight.prod() * static_cast<float>(byte_at(low + step));
  }
  return scale_ * sum;
}

}  // namespace castaway::localization
