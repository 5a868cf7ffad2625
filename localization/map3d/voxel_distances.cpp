#include "localization/map3d/voxel_distances.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "localization/map/cell_index.hpp"

namespace castaway::localization {
namespace {

constexpr std::int64_t kMostBlocks = std::int64_t{1} << 27U;  // Of the table, stored or not.
constexpr std::uint8_t kFar = 255;

float square_of(float value) { return value * value; }

/// Position of a voxel in its block of 8 x 8 x 8; the first block begins at voxel 0.
std::size_t place_in_block(const Eigen::Vector3i& voxel) {
  return static_cast<std::size_t>(((voxel.z() & 7) << 6) | ((voxel.y() & 7) << 3) |
                                  (voxel.x() & 7));
}

/// Squared distances of the centres of a block's voxels from points, in edges of a voxel.
using SquaredDistances = std::array<float, 512>;

constexpr int kRow = 8;

/// The voxels of a row, of a block, within `radius` of a position along it.
struct Reach {
  Reach(float position, float radius)
      : first(static_cast<int>(std::ceil(std::max(position - radius, 0.0F)))),
        last(static_cast<int>(std::floor(std::min(position + radius, kRow - 1.0F)))) {}

  int first;
  int last;
};

/// Lowers the distances from `p`; the centre of the first voxel is 0. Farther than `radius` nothing
/// is lower.
void lower(const Eigen::Vector3f& p, float radius, SquaredDistances& squares) {
  const Reach x_reach(p.x(), radius);
  const Reach y_reach(p.y(), radius);
  const Reach z_reach(p.z(), radius);
  if (x_reach.first > x_reach.last || y_reach.first > y_reach.last) return;
  std::array<float, kRow> along{};
  for (int x = 0; x < kRow; ++x) {
    along[static_cast<std::size_t>(x)] = square_of(static_cast<float>(x) - p.x());
  }
  for (int z = z_reach.first; z <= z_reach.last; ++z) {
    const float up = square_of(static_cast<float>(z) - p.z());
    for (int y = y_reach.first; y <= y_reach.last; ++y) {
      const float away = up + square_of(static_cast<float>(y) - p.y());
      if (away >= square_of(radius)) continue;
      float* row = &squares[static_cast<std::size_t>((z * kRow + y) * kRow)];
      for (std::size_t x = 0; x < kRow; ++x) row[x] = std::min(row[x], away + along[x]);
    }
  }
}

}  // namespace

VoxelDistances::VoxelDistances(const VoxelMap& map, double max_distance)
    : resolution_(map.resolution), max_distance_(max_distance) {
  validate(map);
  if (!(max_distance >= map.resolution && max_distance <= 16.0 * map.resolution)) {
    throw std::invalid_argument("distances of a 3-D map reach 1 to 16 voxels");
  }
  scale_ = static_cast<float>(max_distance / kFar);
  steps_ = tabulate([](double distance) { return distance; });
  // Interpolation reads one voxel beyond; the surface point lies anywhere in its voxel.
  const int reach = static_cast<int>(std::ceil(max_distance / resolution_)) + 1;
  if (map.size() == 0) return;
  lay_out(map, reach);
  spread(map);
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

/// Surface points sorted by blocks, in edges of a voxel from the corner of their block.
VoxelDistances::BlockPoints VoxelDistances::sort_by_block(const VoxelMap& map) const {
  BlockPoints sorted;
  sorted.first.assign(blocks_.size() + 1, 0);
  const auto block_of = [&](std::size_t i) {
    return static_cast<std::size_t>(
        table_[table_index((voxel_index(map.keys[i]) - first_) / kEdge)]);
  };
  for (std::size_t i = 0; i < map.size(); ++i) ++sorted.first[block_of(i) + 1];
  std::partial_sum(sorted.first.begin(), sorted.first.end(), sorted.first.begin());
  sorted.points.resize(map.size());
  std::vector<std::uint32_t> next = sorted.first;
  for (std::size_t i = 0; i < map.size(); ++i) {
    const Eigen::Vector3i local = voxel_index(map.keys[i]) - first_;
    const Eigen::Vector3i corner = first_ + local / kEdge * kEdge;
    sorted.points[next[block_of(i)]++] =
        (map.point(i) / resolution_ - corner.cast<double>()).cast<float>();
  }
  return sorted;
}

/// The distances of each block are those to the points in it and in the blocks around it.
void VoxelDistances::spread(const VoxelMap& map) {
  const BlockPoints points = sort_by_block(map);
  for (int z = 0; z < size_.z(); ++z) {
    for (int y = 0; y < size_.y(); ++y) {
      for (int x = 0; x < size_.x(); ++x) fill({x, y, z}, points);
    }
  }
}

void VoxelDistances::fill(const Eigen::Vector3i& block, const BlockPoints& points) {
  const std::int32_t own = table_[table_index(block)];
  if (own < 0) return;
  const auto radius = static_cast<float>(max_distance_ / resolution_);
  SquaredDistances squares;
  squares.fill(square_of(radius));
  for_each_around(block, static_cast<int>(radius) / kEdge + 1, [&](const Eigen::Vector3i& other) {
    const std::int32_t from = table_[table_index(other)];
    if (from < 0) return;
    const Eigen::Vector3f shift = (kEdge * (other - block)).cast<float>().array() - 0.5F;
    for (const Eigen::Vector3f& p : points.of(static_cast<std::size_t>(from))) {
      lower(p + shift, radius, squares);
    }
  });
  const float units = static_cast<float>(resolution_) / scale_;
  std::transform(squares.begin(), squares.end(), blocks_[static_cast<std::size_t>(own)].begin(),
                 [units](float square) {
                   return static_cast<std::uint8_t>(units * std::sqrt(square) + 0.5F);
                 });
}

/// Calls `f` with the blocks at most `around` away, on the table.
template <typename Function>
void VoxelDistances::for_each_around(const Eigen::Vector3i& block, int around,
                                     const Function& f) const {
  const Eigen::Vector3i low = (block.array() - around).max(0);
  const Eigen::Vector3i high = (block.array() + around).min(size_.array() - 1);
  for (int z = low.z(); z <= high.z(); ++z) {
    for (int y = low.y(); y <= high.y(); ++y) {
      for (int x = low.x(); x <= high.x(); ++x) f(Eigen::Vector3i(x, y, z));
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

/// The block of a voxel, counted from `first_`; null where there is none.
const VoxelDistances::Block* VoxelDistances::block_around(const Eigen::Vector3i& local) const {
  // Voxels before the first one become large.
  const Eigen::Vector3i block = (local.cast<unsigned>() / unsigned{kEdge}).cast<int>();
  if ((block.array() >= size_.array()).any()) return nullptr;
  const std::int32_t index = table_[table_index(block)];
  return index < 0 ? nullptr : &blocks_[static_cast<std::size_t>(index)];
}

std::uint8_t VoxelDistances::byte_at(const Eigen::Vector3i& voxel) const {
  const Eigen::Vector3i local = voxel - first_;
  const Block* block = block_around(local);
  return block == nullptr ? kFar : (*block)[place_in_block(local)];
}

/// Bytes of a voxel and those after it along x, y and z: x varies fastest.
std::array<std::uint8_t, 8> VoxelDistances::corners_at(const Eigen::Vector3i& voxel) const {
  std::array<std::uint8_t, 8> bytes{};
  const Eigen::Vector3i local = voxel - first_;
  const bool one_block = (local.x() & 7) != 7 && (local.y() & 7) != 7 && (local.z() & 7) != 7;
  const Block* block = one_block ? block_around(local) : nullptr;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const std::size_t x = i & 1U;
    const std::size_t y = (i >> 1U) & 1U;
    const std::size_t z = i >> 2U;
    if (block != nullptr) {
      bytes[i] = (*block)[place_in_block(local) + (z << 6U) + (y << 3U) + x];
    } else if (one_block) {
      bytes[i] = kFar;
    } else {
      bytes[i] = byte_at(
          voxel + Eigen::Vector3i(static_cast<int>(x), static_cast<int>(y), static_cast<int>(z)));
    }
  }
  return bytes;
}

float VoxelDistances::at_point(const Eigen::Vector3f& p_map) const {
  const Eigen::Vector3f lattice = p_map / static_cast<float>(resolution_);
  return at_centre({cell_index(lattice.x()), cell_index(lattice.y()), cell_index(lattice.z())});
}

float VoxelDistances::interpolate(const Eigen::Vector3f& p_map,
                                  const std::array<float, 256>& values) const {
  const Eigen::Vector3f lattice = p_map.array() / static_cast<float>(resolution_) - 0.5F;
  const Eigen::Vector3i low(cell_index(lattice.x()), cell_index(lattice.y()),
                            cell_index(lattice.z()));
  const Eigen::Vector3f t = (lattice - low.cast<float>()).array().max(0.0F).min(1.0F);
  const std::array<std::uint8_t, 8> bytes = corners_at(low);
  const auto along_x = [&](std::size_t y, std::size_t z) {
    const float left = values[bytes[2 * y + 4 * z]];
    return left + t.x() * (values[bytes[2 * y + 4 * z + 1]] - left);
  };
  const float near_below = along_x(0, 0);
  const float near_above = along_x(0, 1);
  const float below = near_below + t.y() * (along_x(1, 0) - near_below);
  const float above = near_above + t.y() * (along_x(1, 1) - near_above);
  return below + t.z() * (above - below);
}

}  // namespace castaway::localization
