/// A small building for tests of 3-D maps.
#pragma once

#include "localization/space/map3d/voxel_builder.hpp"
#include "tools/build/map3d/survey_map3d.hpp"

namespace castaway::testbed {

/// A floor of 8 m x 8 m with another one of 8 m x 5 m above it, at 2 m, and a ramp beside.
inline Map3d two_floors() {
  localization::VoxelBuilder builder(0.1);
  for (double x = 0.025; x < 16.0; x += 0.05) {
    for (double y = 0.025; y < 8.0; y += 0.05) {
      builder.add({x, y, 0.0}, true);
      if (x < 8.0 && y < 5.0) builder.add({x, y, 2.0}, true);
      if (x >= 8.0 && x < 14.67 && y > 1.0 && y < 4.0) builder.add({x, y, 0.3 * (14.67 - x)}, true);
    }
  }
  Map3dOptions options;
  options.ground.max_slope = 0.5;
  return survey_map3d(builder.build(), options);
}

}  // namespace castaway::testbed
