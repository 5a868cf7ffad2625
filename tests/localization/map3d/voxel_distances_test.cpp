#include "localization/map3d/voxel_distances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>
#include <boost/random/uniform_real_distribution.hpp>

#include "localization/geometry/random.hpp"
#include "localization/map3d/voxel_builder.hpp"

namespace castaway::localization {
namespace {

constexpr double kVoxel = 0.1;
constexpr double kMax = 0.4;

double uniform(Rng& rng, double low, double high) {
  return boost::random::uniform_real_distribution<double>(low, high)(rng);
}

VoxelMap scattered(Rng& rng, int count) {
  VoxelBuilder builder(kVoxel);
  for (int i = 0; i < count; ++i) {
    builder.add({uniform(rng, -2.0, 2.0), uniform(rng, -1.0, 1.0), uniform(rng, -0.5, 0.5)});
  }
  return builder.build();
}

/// The level z = 0.03 over 2 m x 2 m.
VoxelMap plane() {
  VoxelBuilder builder(kVoxel);
  for (int x = -100; x < 100; ++x) {
    for (int y = -100; y < 100; ++y) builder.add({0.01 * x + 0.005, 0.01 * y + 0.005, 0.03});
  }
  return builder.build();
}

double nearest(const VoxelMap& map, const Eigen::Vector3d& p) {
  double least = kMax;
  for (std::size_t i = 0; i < map.size(); ++i) least = std::min(least, (map.point(i) - p).norm());
  return least;
}

TEST(VoxelDistancesTest, AreThoseToTheNearestSurfacePoint) {
  Rng rng(7);
  const VoxelMap map = scattered(rng, 60);
  const VoxelDistances distances(map, kMax);
  for (int i = 0; i < 4000; ++i) {
    const Eigen::Vector3i voxel(static_cast<int>(uniform(rng, -30.0, 30.0)),
                                static_cast<int>(uniform(rng, -20.0, 20.0)),
                                static_cast<int>(uniform(rng, -12.0, 12.0)));
    const Eigen::Vector3d centre = (voxel.cast<double>().array() + 0.5) * kVoxel;
    const double expected = nearest(map, centre);
    EXPECT_NEAR(static_cast<double>(distances.at_centre(voxel)), expected, kMax / 255.0)
        << voxel.transpose();
  }
}

TEST(VoxelDistancesTest, AreInterpolatedBetweenCentres) {
  const VoxelDistances distances(plane(), kMax);
  for (const float z : {0.13F, 0.18F, 0.25F, 0.32F, -0.1F, -0.2F}) {
    EXPECT_NEAR(static_cast<double>(distances.at({0.123F, -0.456F, z})),
                std::abs(static_cast<double>(z) - 0.03), 0.006)
        << z;
  }
}

TEST(VoxelDistancesTest, AtASurfaceTheyReadLessThanHalfAVoxel) {
  const VoxelDistances distances(plane(), kMax);
  for (float x = -0.5F; x < 0.5F; x += 0.013F) {
    EXPECT_LT(distances.at({x, 0.3F * x, 0.03F}), 0.05F) << x;
  }
}

TEST(VoxelDistancesTest, FarAwayTheyReadTheLargestDistance) {
  const VoxelDistances distances(plane(), kMax);
  const auto far = static_cast<float>(kMax);
  EXPECT_FLOAT_EQ(distances.at({0.0F, 0.0F, 2.0F}), far);
  EXPECT_FLOAT_EQ(distances.at({1e30F, -1e30F, 0.0F}), far);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(distances.at({nan, 0.0F, 0.0F}) < far);
  EXPECT_FLOAT_EQ(VoxelDistances(VoxelMap{kVoxel, {}, {}, {}}, kMax).at({0.0F, 0.0F, 0.0F}), far);
}

TEST(VoxelDistancesTest, TakeMemoryNearSurfacesOnly) {
  VoxelBuilder builder(kVoxel);
  builder.add({0.0, 0.0, 0.0});
  builder.add({60.0, 60.0, 10.0});
  EXPECT_LT(VoxelDistances(builder.build(), kMax).bytes(), 700'000U);  // Dense: 36 MB.
}

TEST(VoxelDistancesTest, WhatCannotBeStoredIsRefused) {
  EXPECT_THROW(VoxelDistances(plane(), 0.05), std::invalid_argument);
  EXPECT_THROW(VoxelDistances(plane(), 2.0), std::invalid_argument);
  VoxelBuilder builder(kVoxel);
  builder.add({-9000.0, -9000.0, -9000.0});
  builder.add({9000.0, 9000.0, 9000.0});
  EXPECT_THROW(VoxelDistances(builder.build(), kMax), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::localization
