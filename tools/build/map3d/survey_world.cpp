#include "tools/build/map3d/survey_world.hpp"

#include "localization/space/map3d/voxel_builder.hpp"
#include "sim/map/surface_samples.hpp"

namespace castaway::testbed {
namespace {

constexpr double kFacesUp = 0.5;  // Least z of the unit normal of ground: 60 degrees.

}  // namespace

Map3d survey_world(const sim::WorldSpec& world, const Map3dOptions& options) {
  localization::VoxelBuilder builder(options.resolution);
  // Finer than voxels, so that the mean point of a voxel is that of the whole surface in it.
  sim::sample_surfaces(world, 0.5 * options.resolution,
                       [&](const Eigen::Vector3d& p_map, const Eigen::Vector3d& normal) {
                         builder.add(p_map, normal.z() > kFacesUp);
                       });
  Map3dOptions inside = options;
  if (!inside.start && world.inside) {
    inside.start = Eigen::Vector3d(world.inside->x(), world.inside->y(), 0.0);
  }
  return survey_map3d(builder.build(), inside);
}

}  // namespace castaway::testbed
