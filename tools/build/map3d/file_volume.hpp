/// The 3-D map of a file for localizers.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "localization/space/volume/volume.hpp"
#include "tools/base/formats/volume/map3d_file.hpp"

namespace castaway::testbed {

/// Prepares the map of a file when it is called; localizers with equal voxels share one. `known` is
/// that map; a cloud is read again for voxels [m] of another edge, while other files keep their
/// own. `wheels`: of the robot that drove. Calls throw std::runtime_error naming the file.
std::function<std::shared_ptr<const localization::Volume>(double voxel)> volume_of(
    const std::filesystem::path& file, std::shared_ptr<const Map3d> known,
    const localization::WheelStance& wheels = {});

}  // namespace castaway::testbed
