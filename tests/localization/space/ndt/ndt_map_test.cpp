#include "localization/space/ndt/ndt_map.hpp"

#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/localization/space/volume/voxel_maps.hpp"
#include "tests/support/string_map.hpp"

namespace castaway::localization {
namespace {

/// Distance from a point to the nearest mean that is offered there; far away if none is.
float nearest_mean(const NdtMap& map, const Eigen::Vector3f& p) {
  float least = 1e9F;
  map.for_each_near(
      p, [&](const NormalDistribution& d) { least = std::min(least, (d.mean - p).norm()); });
  return least;
}

TEST(NdtMap, HoldsTheCentresOfOccupiedCellsInMap) {
  OccupancyGrid grid = test::string_map({"....", ".#..", "...."}, 0.1);
  grid.frame.T_map_grid = {5.0, -2.0, 0.0};
  const NdtMap map(grid, {});
  ASSERT_EQ(map.distributions().size(), 1U);
  EXPECT_TRUE(map.is_planar());
  EXPECT_TRUE(map.distributions()[0].mean.isApprox(Eigen::Vector3f(5.15F, -1.85F, 0.0F), 1e-5F));
}

/// The oracle looks at all distributions.
TEST(NdtMap, OffersAllDistributionsWithinHalfACell) {
  Rng rng(7);
  const NdtConfig config{0.4, 1.0};
  const NdtMap map(test::scattered(rng, 400), config);
  EXPECT_FALSE(map.is_planar());
  int within = 0;
  for (int i = 0; i < 3000; ++i) {
    const Eigen::Vector3f p =
        Eigen::Vector3d(test::draw(rng, -2.5, 2.5), test::draw(rng, -1.5, 1.5),
                        test::draw(rng, -1.0, 1.0))
            .cast<float>();
    float least = 1e9F;
    for (const NormalDistribution& d : map.distributions()) {
      least = std::min(least, (d.mean - p).norm());
    }
    if (least > 0.199F) continue;
    ++within;
    EXPECT_EQ(nearest_mean(map, p), least);
  }
  EXPECT_GT(within, 300);
}

TEST(NdtMap, OffersNothingFarAway) {
  Rng rng(7);
  const NdtMap map(test::scattered(rng, 50), {});
  for (const float far : {20.0F, -20.0F, 1e20F, -1e20F}) {
    EXPECT_EQ(nearest_mean(map, {far, 0.0F, 0.0F}), 1e9F) << far;
  }
}

TEST(NdtMap, AMapWithoutSurfacesHasNoDistributions) {
  const NdtMap map(test::string_map({"..", ".."}, 0.1), {});
  EXPECT_TRUE(map.distributions().empty());
  EXPECT_EQ(nearest_mean(map, {0.0F, 0.0F, 0.0F}), 1e9F);
}

TEST(NdtMap, RefusesSettingsOutOfRange) {
  EXPECT_THROW(validate(NdtConfig{0.0, 2.0}), std::invalid_argument);
  EXPECT_THROW(validate(NdtConfig{0.5, 0.5}), std::invalid_argument);
  EXPECT_NO_THROW(validate(NdtConfig{}));
}

}  // namespace
}  // namespace castaway::localization
