/// The 3-D map of a run's world for localizers.
#pragma once

#include <functional>
#include <memory>

#include "localization/volume/volume.hpp"
#include "sim/world/world_spec.hpp"
#include "tools/formats/volume/map3d_file.hpp"

namespace castaway::testbed {

/// Surveys a world when it is called, with voxels of this edge [m]. `known`: a map of that world,
/// taken instead if its voxels are as large. Throws as `survey_world` and
/// `localization::Volume`.
std::function<std::shared_ptr<const localization::Volume>(double voxel)> volume_of(
    const sim::WorldSpec& world, std::shared_ptr<const Map3d> known = nullptr);

}  // namespace castaway::testbed
