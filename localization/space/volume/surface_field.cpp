#include "localization/space/volume/surface_field.hpp"

#include "localization/space/volume/nearest_points.hpp"
#include "localization/space/volume/voxel_distances.hpp"

namespace castaway::localization {
namespace {

constexpr float kUnits = 127.0F;

/// The centre of the first voxel of a block, from a surface point; in edges of a voxel.
Eigen::Vector3f corner_from(const VoxelMap& map, std::size_t i, const Eigen::Vector3i& corner) {
  const Eigen::Vector3f between = (corner - voxel_index(map.keys[i])).cast<float>();
  return (between - point_in_voxel(map, i)).array() + 0.5F;
}

std::int8_t to_units(float component) {
  return static_cast<std::int8_t>(std::lround(kUnits * component));
}

}  // namespace

SurfaceField::Cell SurfaceField::cell_at(const SurfacePatch& patch, const Eigen::Vector3f& p,
                                         float reach) {
  constexpr float kOnPatch = 1e-3F;
  const Eigen::Vector3f way = way_from(patch, p);
  const float distance = way.norm();
  if (!(distance < reach)) return {};
  const bool on_plane = distance < kOnPatch && patch.shape == PatchShape::kPlane;
  const Eigen::Vector3f n = on_plane ? patch.axis : way / std::max(distance, kOnPatch);
  return {static_cast<std::int8_t>(std::lround(kUnits * distance / reach)), to_units(n.x()),
          to_units(n.y()), to_units(n.z())};
}

SurfaceField::SurfaceField(const VoxelMap& map, double max_distance)
    : resolution_(static_cast<float>(map.resolution)),
      per_m_(static_cast<float>(1.0 / map.resolution)),
      reach_(static_cast<float>(max_distance / map.resolution)),
      unit_(reach_ / kUnits),
      steps_(255.0F / reach_) {
  validate_reach(map, max_distance);
  blocks_ = VoxelBlocks(map, static_cast<int>(std::ceil(reach_)));
  cells_.resize((blocks_.size() + 1) * VoxelBlocks::kVoxels);
  const SurfacePoints points(map, blocks_, reach_);
  const std::vector<SurfacePatch> patches = surface_patches(map);
  blocks_.for_each([&](const Eigen::Vector3i& block, std::uint32_t number) {
    const NearestPoints nearest = points.nearest(block);
    for (std::uint32_t voxel = 0; voxel < VoxelBlocks::kVoxels; ++voxel) {
      if (!(nearest.squares[voxel] < reach_ * reach_)) continue;
      const std::uint32_t i = nearest.points[voxel];
      const Eigen::Vector3f from =
          corner_from(map, i, blocks_.corner(block)) + corner_in_block(voxel);
      cells_[number * VoxelBlocks::kVoxels + voxel] = cell_at(patches[i], from, reach_);
    }
  });
}

}  // namespace castaway::localization
