/// Small 3-D maps for tests.
#pragma once

#include <boost/random/uniform_real_distribution.hpp>

#include "localization/geometry/four_floats.hpp"
#include "localization/geometry/random.hpp"
#include "localization/space/map3d/voxel_builder.hpp"

namespace castaway::test {

/// [m] Edge of their voxels.
inline constexpr double kSmallVoxel = 0.1;

inline double draw(localization::Rng& rng, double low, double high) {
  return boost::random::uniform_real_distribution<double>(low, high)(rng);
}

/// Coordinates of four points. [m]
struct FourCoordinates {
  localization::FourFloats x{}, y{}, z{};
};

/// Drawn from 8 x 6 x 4 m about the origin.
inline FourCoordinates draw_four(localization::Rng& rng) {
  FourCoordinates four;
  for (int k = 0; k < 4; ++k) {
    four.x[k] = static_cast<float>(draw(rng, -4.0, 4.0));
    four.y[k] = static_cast<float>(draw(rng, -3.0, 3.0));
    four.z[k] = static_cast<float>(draw(rng, -2.0, 2.0));
  }
  return four;
}

/// Points drawn from 4 x 2 x 1 m about the origin.
inline localization::VoxelMap scattered(localization::Rng& rng, int count) {
  localization::VoxelBuilder builder(kSmallVoxel);
  for (int i = 0; i < count; ++i) {
    builder.add({draw(rng, -2.0, 2.0), draw(rng, -1.0, 1.0), draw(rng, -0.5, 0.5)});
  }
  return builder.build();
}

/// Points `origin + s * along_s + t * along_t` [m] for s, t in [0, 1], closely spaced.
inline void add_plane(const Eigen::Vector3d& origin, const Eigen::Vector3d& along_s,
                      const Eigen::Vector3d& along_t, localization::VoxelBuilder& builder) {
  constexpr int kSteps = 200;
  for (int s = 0; s < kSteps; ++s) {
    for (int t = 0; t < kSteps; ++t) {
      builder.add(origin + (s + 0.5) / kSteps * along_s + (t + 0.5) / kSteps * along_t);
    }
  }
}

}  // namespace castaway::test
