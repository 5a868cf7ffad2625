/// Rays one at a time, for tests.
#pragma once

#include <array>

#include "localization/space/volume/voxel_rays.hpp"

namespace castaway::test {

using localization::Encounter;
using localization::Ray;

/// What a ray meets.
template <typename Distances>
Encounter encounter(const Distances& distances, const Eigen::Vector3f& from,
                    const Eigen::Vector3f& to) {
  return localization::encounters(distances, std::array{Ray{from, to}}).at(0);
}

inline bool passes_through(const localization::VoxelDistances& distances,
                           const Eigen::Vector3f& from, const Eigen::Vector3f& to) {
  return !localization::passing_through(distances, std::array{Ray{from, to}}).empty();
}

}  // namespace castaway::test
