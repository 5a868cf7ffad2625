/// What a localizer on a 3-D map says: poses in map with their heights, in place of the atlas.
#pragma once

#include <optional>

#include "localization/localizer.hpp"
#include "localization/space/volume/volume.hpp"

namespace castaway::localization {

/// A start in map as one in the atlas. Where no drivable ground is under it, the nearest counts.
PoseWithCovariance in_atlas(const Volume& volume, const PoseWithCovariance& start);

/// Replaces poses in the atlas by those in map.
void to_map(const Volume& volume, std::optional<Estimate>& estimate);
void to_map(const Volume& volume, Diagnostics& diagnostics);

}  // namespace castaway::localization
