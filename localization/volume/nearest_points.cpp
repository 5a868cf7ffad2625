#include "localization/volume/nearest_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace castaway::localization {
namespace {

constexpr int kRow = VoxelBlocks::kEdge;

float square_of(float value) { return value * value; }

/// Squared distance of a coordinate from the centres of a row's voxels, the first at 0.
float square_to_row(float position) {
  return square_of(std::max({-position, position - (kRow - 1.0F), 0.0F}));
}

/// Takes a point that is nearer; the centre of the block's first voxel is 0. `worst`: none of the
/// squares is larger.
void take(const Eigen::Vector3f& p, std::uint32_t index, float worst, NearestPoints& nearest) {
  const float x_to_row = square_to_row(p.x());
  if (x_to_row + square_to_row(p.y()) + square_to_row(p.z()) >= worst) return;
  std::array<float, kRow> along{};
  for (std::size_t x = 0; x < kRow; ++x) along[x] = square_of(static_cast<float>(x) - p.x());
  for (int z = 0; z < kRow; ++z) {
    const float up = square_of(static_cast<float>(z) - p.z());
    for (int y = 0; y < kRow; ++y) {
      const float away = up + square_of(static_cast<float>(y) - p.y());
      if (away + x_to_row >= worst) continue;
      const auto row = static_cast<std::size_t>((z * kRow + y) * kRow);
      for (std::size_t x = 0; x < kRow; ++x) {
        const bool nearer = away + along[x] < nearest.squares[row + x];
        nearest.squares[row + x] = nearer ? away + along[x] : nearest.squares[row + x];
        nearest.points[row + x] = nearer ? index : nearest.points[row + x];
      }
    }
  }
}

/// Least square of the distance from the voxels' centres of a block to the points of another one.
float square_between(const Eigen::Vector3i& blocks) {
  constexpr float kPastCentre = VoxelBlocks::kEdge - 0.5F;  // From one block's last to the next.
  const Eigen::Vector3f gap =
      (VoxelBlocks::kEdge * blocks.cwiseAbs()).cast<float>().array() - kPastCentre;
  return gap.cwiseMax(0.0F).squaredNorm();
}

}  // namespace

Eigen::Vector3f corner_in_block(std::uint32_t voxel) {
  return {static_cast<float>(voxel & 3U), static_cast<float>((voxel >> 2U) & 3U),
          static_cast<float>(voxel >> 4U)};
}

Eigen::Vector3f point_in_voxel(const VoxelMap& map, std::size_t i) {
  const auto& offset = map.offsets[i];
  return Eigen::Vector3f(offset[0] + 0.5F, offset[1] + 0.5F, offset[2] + 0.5F) / 256.0F;
}

SurfacePoints::SurfacePoints(const VoxelMap& map, const VoxelBlocks& blocks)
    : blocks_(blocks), first_(blocks.size() + 1, 0), points_(map.size()) {
  const auto block_of = [&](std::size_t i) {
    return std::size_t{blocks.find(voxel_index(map.keys[i]))->block};
  };
  for (std::size_t i = 0; i < map.size(); ++i) ++first_[block_of(i) + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  std::vector<std::uint32_t> next = first_;
  for (std::size_t i = 0; i < map.size(); ++i) {
    const std::uint32_t place = blocks.find(voxel_index(map.keys[i]))->voxel;
    const Eigen::Vector3f p = corner_in_block(place) + point_in_voxel(map, i);
    points_[next[block_of(i)]++] = {p, static_cast<std::uint32_t>(i)};
  }
}

NearestPoints SurfacePoints::nearest(const Eigen::Vector3i& block, float radius) const {
  NearestPoints nearest;
  nearest.squares.fill(square_of(radius));
  nearest.points.fill(0);
  float worst = square_of(radius);
  const auto take_points = [&](const Eigen::Vector3i& other, std::uint32_t number) {
    if (square_between(other - block) >= worst) return;
    const Eigen::Vector3f shift =
        (VoxelBlocks::kEdge * (other - block)).cast<float>().array() - 0.5F;
    for (std::uint32_t i = first_[number]; i < first_[number + 1]; ++i) {
      take(points_[i].p + shift, points_[i].index, worst, nearest);
    }
    worst = *std::max_element(nearest.squares.begin(), nearest.squares.end());
  };
  blocks_.for_each_around(block, 0, take_points);  // The nearest first, so that few others count.
  const int around = static_cast<int>(std::ceil(radius)) / VoxelBlocks::kEdge + 1;
  blocks_.for_each_around(block, around, [&](const Eigen::Vector3i& other, std::uint32_t number) {
    if (other != block) take_points(other, number);
  });
  return nearest;
}

}  // namespace castaway::localization
