#include "localization/space/volume/voxel_distances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/localization/space/volume/voxel_maps.hpp"

namespace castaway::localization {
namespace {

using test::kSmallVoxel;

constexpr double kMax = 0.4;

double to_nearest_point(const VoxelMap& map, const Eigen::Vector3d& p) {
  double least = kMax;
  for (std::size_t i = 0; i < map.size(); ++i) least = std::min(least, (map.point(i) - p).norm());
  return least;
}

TEST(VoxelDistancesTest, AreThoseToTheNearestSurfacePoint) {
  Rng rng(7);
  const VoxelMap map = test::scattered(rng, 60);
  const VoxelDistances distances(map, kMax);
  for (int i = 0; i < 4000; ++i) {
    const Eigen::Vector3i voxel(static_cast<int>(test::draw(rng, -30.0, 30.0)),
                                static_cast<int>(test::draw(rng, -20.0, 20.0)),
                                static_cast<int>(test::draw(rng, -12.0, 12.0)));
    const Eigen::Vector3d centre = (voxel.cast<double>().array() + 0.5) * kSmallVoxel;
    const double expected = to_nearest_point(map, centre);
    EXPECT_NEAR(static_cast<double>(distances.at_centre(voxel)), expected, kMax / 255.0)
        << voxel.transpose();
    EXPECT_EQ(distances.at_point(centre.cast<float>()), distances.at_centre(voxel));
  }
}

TEST(VoxelDistancesTest, FarAwayTheyReadTheLargestDistance) {
  Rng rng(7);
  const VoxelDistances distances(test::scattered(rng, 60), kMax);
  const auto far = static_cast<float>(kMax);
  EXPECT_FLOAT_EQ(distances.at_point({0.0F, 0.0F, 2.0F}), far);
  EXPECT_FLOAT_EQ(distances.at_point({1e30F, -1e30F, 0.0F}), far);
  EXPECT_FLOAT_EQ(distances.at_point({std::numeric_limits<float>::quiet_NaN(), 0.0F, 0.0F}), far);
  const VoxelMap nothing{kSmallVoxel, {}, {}, {}};
  EXPECT_FLOAT_EQ(VoxelDistances(nothing, kMax).at_point({0.0F, 0.0F, 0.0F}), far);
}

TEST(VoxelDistancesTest, OfFourPointsAreThoseOfEach) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  Rng rng(9);
  const VoxelDistances distances(test::scattered(rng, 60), kMax);
  const FourFloats special{kNan, 1e30F, -1e30F, -0.0F};
  for (int i = 0; i < 2000; ++i) {
    auto [x, y, z] = test::draw_four(rng);
    if (i % 10 == 0) z = special;
    const FourFloats four = distances.at_points(x, y, z);
    for (int k = 0; k < 4; ++k) EXPECT_EQ(four[k], distances.at_point({x[k], y[k], z[k]}));
  }
}

TEST(VoxelDistancesTest, TakeMemoryNearSurfacesOnly) {
  VoxelBuilder builder(kSmallVoxel);
  builder.add({0.0, 0.0, 0.0});
  builder.add({60.0, 60.0, 10.0});
  EXPECT_LT(VoxelDistances(builder.build(), kMax).bytes(), 3'000'000U);  // Dense: 36 MB.
}

TEST(VoxelDistancesTest, WhatCannotBeStoredIsRefused) {
  Rng rng(7);
  EXPECT_THROW(VoxelDistances(test::scattered(rng, 3), 0.05), std::invalid_argument);
  EXPECT_THROW(VoxelDistances(test::scattered(rng, 3), 2.0), std::invalid_argument);
  VoxelBuilder builder(kSmallVoxel);
  builder.add({-9000.0, -9000.0, -9000.0});
  builder.add({9000.0, 9000.0, 9000.0});
  EXPECT_THROW(VoxelDistances(builder.build(), kMax), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::localization
