#include "localization/space/volume/voxel_distances.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "localization/space/volume/nearest_points.hpp"

namespace castaway::localization {
namespace {

constexpr std::uint8_t kBeyond = 255;

}  // namespace

void validate_reach(const VoxelMap& map, double max_distance) {
  validate(map);
  if (!(max_distance >= map.resolution && max_distance <= 16.0 * map.resolution)) {
    throw std::invalid_argument("distances of a 3-D map reach 1 to 16 voxels");
  }
}

VoxelDistances::VoxelDistances(const VoxelMap& map, double max_distance)
    : resolution_(map.resolution),
      rough_(is_rough(map)),
      scale_(static_cast<float>(max_distance / kBeyond)) {
  validate_reach(map, max_distance);
  const double radius = max_distance / resolution_;
  blocks_ = VoxelBlocks(map, static_cast<int>(std::ceil(radius)));
  distances_.assign((blocks_.size() + 1) * VoxelBlocks::kVoxels, kBeyond);
  const SurfacePoints points(map, blocks_, static_cast<float>(radius));
  const float units = static_cast<float>(resolution_) / scale_;
  blocks_.for_each([&](const Eigen::Vector3i& block, std::uint32_t number) {
    const NearestPoints nearest = points.nearest(block);
    std::transform(nearest.squares.begin(), nearest.squares.end(),
                   distances_.begin() + static_cast<std::ptrdiff_t>(number * VoxelBlocks::kVoxels),
                   [units](float square) {
                     return static_cast<std::uint8_t>(units * std::sqrt(square) + 0.5F);
                   });
  });
}

float VoxelDistances::at_centre(const Eigen::Vector3i& voxel) const {
  const auto place = blocks_.find(voxel);
  const std::uint8_t units =
      place ? distances_[place->block * VoxelBlocks::kVoxels + place->voxel] : kBeyond;
  return scale_ * static_cast<float>(units);
}

}  // namespace castaway::localization
