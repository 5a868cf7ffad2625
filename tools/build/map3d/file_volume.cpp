#include "tools/build/map3d/file_volume.hpp"

#include <map>
#include <stdexcept>
#include <utility>

#include "tools/build/map3d/map3d_files.hpp"

namespace castaway::testbed {
namespace {

using localization::Volume;
using localization::VolumeConfig;

std::shared_ptr<const Volume> prepare(const std::filesystem::path& file, const Map3d& map,
                                      const VolumeConfig& config) {
  try {
    return std::make_shared<const Volume>(map.voxels, map.ground, config);
  } catch (const std::invalid_argument& error) {  // Of the map, which knows no file.
    throw std::runtime_error(file.string() + ": " + error.what());
  }
}

}  // namespace

std::function<std::shared_ptr<const Volume>(double voxel)> volume_of(
    const std::filesystem::path& file, std::shared_ptr<const Map3d> known,
    const localization::WheelStance& wheels) {
  using Volumes = std::map<double, std::shared_ptr<const Volume>>;
  return [file, known = std::move(known), config = VolumeConfig{.wheels = wheels},
          volumes = Volumes()](double voxel) mutable {
    const bool as_known = !is_cloud(file) || known->voxels.resolution == voxel;
    auto& volume = volumes[as_known ? known->voxels.resolution : voxel];
    if (volume) return volume;
    Map3dOptions options;
    options.resolution = voxel;
    volume = prepare(file, as_known ? *known : read_map3d_file(file, options), config);
    return volume;
  };
}

}  // namespace castaway::testbed
