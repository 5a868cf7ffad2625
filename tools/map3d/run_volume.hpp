/// The 3-D map of a run's world for localizers.
#pragma once

#include <functional>
#include <memory>

#include "localization/map3d/volume.hpp"
#include "sim/world/world_spec.hpp"

namespace castaway::testbed {

/// Surveys a world when it is called, with voxels of this edge [m]. Throws as `survey_map3d` and
/// `localization::Volume`.
std::function<std::shared_ptr<const localization::Volume>(double voxel)> volume_of(
    const sim::WorldSpec& world);

}  // namespace castaway::testbed
