#include "localization/space/volume/nearest_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

#include "localization/geometry/four_floats.hpp"

namespace castaway::localization {
namespace {

constexpr int kRow = VoxelBlocks::kEdge;

float square_of(float value) { return value * value; }

/// Squared distance of a coordinate from the centres of a row's voxels, the first at 0.
float square_to_row(float position) {
  return square_of(std::max({-position, position - (kRow - 1.0F), 0.0F}));
}

/// Nearest points so far. Of points that are equally near, the one with the lowest rank is taken.
struct RankedPoints {
  std::array<FourFloats, kRow * kRow> squares;  ///< Of rows of voxels along x.
  std::array<FourInts, kRow * kRow> ranks;

  [[nodiscard]] float worst() const {
    FourFloats most = squares[0];
    for (const FourFloats& row : squares) most = row > most ? row : most;
    return std::max({most[0], most[1], most[2], most[3]});
  }
};

/// Takes a point where it is nearer; the centre of the block's first voxel is 0. `worst`: none of
/// the squares is larger.
void take(const Eigen::Vector3f& p, int rank, float worst, RankedPoints& nearest) {
  const float x_to_row = square_to_row(p.x());
  if (x_to_row + square_to_row(p.y()) + square_to_row(p.z()) > worst) return;
  const FourFloats x = FourFloats{0.0F, 1.0F, 2.0F, 3.0F} - p.x();
  const FourFloats along = x * x;
  for (int z = 0; z < kRow; ++z) {
    const float up = square_of(static_cast<float>(z) - p.z());
    for (int y = 0; y < kRow; ++y) {
      const float away = up + square_of(static_cast<float>(y) - p.y());
      if (away + x_to_row > worst) continue;
      const auto row = static_cast<std::size_t>(z * kRow + y);
      const FourFloats square = away + along;
      FourFloats& least = nearest.squares[row];
      FourInts& first = nearest.ranks[row];
      const FourInts nearer = (square < least) | ((square == least) & (rank < first));
      least = nearer ? square : least;
      first = nearer ? rank : first;
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

SurfacePoints::SurfacePoints(const VoxelMap& map, const VoxelBlocks& blocks, float radius)
    : blocks_(blocks),
      radius_(radius),
      neighbours_(neighbours_within(radius)),
      first_(blocks.size() + 1, 0),
      points_(map.size()) {
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

std::vector<SurfacePoints::Neighbour> SurfacePoints::neighbours_within(float radius) {
  const int around = static_cast<int>(std::ceil(radius)) / VoxelBlocks::kEdge + 1;
  std::vector<Neighbour> neighbours;
  for (int z = -around; z <= around; ++z) {
    for (int y = -around; y <= around; ++y) {
      for (int x = -around; x <= around; ++x) {
        const Eigen::Vector3i offset(x, y, z);
        const float square = offset.isZero() ? -1.0F : square_between(offset);
        if (square < square_of(radius)) neighbours.push_back({offset, square});
      }
    }
  }
  std::ranges::stable_sort(neighbours, {}, &Neighbour::square);
  return neighbours;
}

NearestPoints SurfacePoints::nearest(const Eigen::Vector3i& block) const {
  constexpr int kFirst =
      std::numeric_limits<int>::min();  // Ranks of the block itself are negative.
  RankedPoints ranked;
  ranked.squares.fill(FourFloats{} + square_of(radius_));
  ranked.ranks.fill(FourInts{} + kFirst);
  float worst = square_of(radius_);
  for (const auto& [offset, square] : neighbours_) {
    if (square > worst) break;
    const Eigen::Vector3f shift = (VoxelBlocks::kEdge * offset).cast<float>().array() - 0.5F;
    const int rank = offset.isZero() ? kFirst : 0;
    blocks_.for_each_around(block + offset, 0, [&](const Eigen::Vector3i&, std::uint32_t number) {
      for (std::uint32_t i = first_[number]; i < first_[number + 1]; ++i) {
        take(points_[i].p + shift, rank + static_cast<int>(i), worst, ranked);
      }
      worst = ranked.worst();
    });
  }
  NearestPoints nearest{};
  for (std::size_t voxel = 0; voxel < VoxelBlocks::kVoxels; ++voxel) {
    const std::size_t row = voxel / kRow;
    nearest.squares[voxel] = ranked.squares[row][voxel % kRow];
    const auto i = static_cast<std::size_t>(ranked.ranks[row][voxel % kRow] & ~kFirst);
    nearest.points[voxel] = i < points_.size() ? points_[i].index : 0;
  }
  return nearest;
}

}  // namespace castaway::localization
