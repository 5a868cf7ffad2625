#include "localization/hypotheses/place_search.hpp"

#include <gtest/gtest.h>

#include "tests/support/grid_world.hpp"
#include "tests/support/scan_points.hpp"

namespace castaway::localization {
namespace {

class PlaceSearchTest : public testing::Test {
 protected:
  CreateContext context() const {
    return {create_, merge_, posterior_, noise_, endpoint_, evidence_};
  }

  OccupancyGrid grid_ = test::office();
  DistanceField distances_{grid_, 5.0};
  CascadeMatcher matcher_{{}, grid_, distances_};
  CreateConfig create_;
  MergeConfig merge_;
  PosteriorConfig posterior_;
  OdometryNoiseConfig noise_;
  EndpointModel endpoint_{{}, distances_};
  EvidenceModel evidence_{{}, grid_, distances_};
  SE2 truth_{3.0, 3.0, 0.4};
  ScanPoints points_ = test::points_from(grid_, truth_);
};

TEST_F(PlaceSearchTest, FindsTheScanInOneGo) {
  PlaceSearch search(matcher_, 1 << 30);
  const auto places = search.step(context(), points_, {});
  ASSERT_TRUE(places && !places->empty());
  EXPECT_LT(distance(places->front().T_map_base, truth_), 0.05);
  EXPECT_FALSE(search.is_pending());
}

TEST_F(PlaceSearchTest, GoesOnOverScansAndCarriesAlongWhatItFinds) {
  PlaceSearch search(matcher_, 200);
  EXPECT_FALSE(search.step(context(), points_, {}));
  EXPECT_TRUE(search.is_pending());
  const SE2 u{0.5, 0.2, 0.3};
  const ScanPoints later = test::points_from(grid_, truth_ * u);
  std::optional<std::vector<WeighedPlace>> places;
  for (int i = 0; i < 10000 && !places; ++i) places = search.step(context(), later, u);
  ASSERT_TRUE(places && !places->empty());
  EXPECT_LT(distance(places->front().T_map_base, truth_ * u), 0.05);
}

TEST_F(PlaceSearchTest, LooksDeeperOnceWhereNothingFits) {
  create_.deep_below = 1.0;  // nothing fits so well
  PlaceSearch search(matcher_, 1 << 30);
  ASSERT_TRUE(search.step(context(), points_, {}));
  EXPECT_TRUE(search.is_pending());
  ASSERT_TRUE(search.step(context(), points_, {}));
  EXPECT_FALSE(search.is_pending());
}

TEST_F(PlaceSearchTest, ForgetsWhatGoesOn) {
  PlaceSearch search(matcher_, 200);
  search.step(context(), points_, {});
  search.cancel();
  EXPECT_FALSE(search.is_pending());
  create_.deep_below = 1.0;
  PlaceSearch deep(matcher_, 1 << 30);
  deep.step(context(), points_, {});
  deep.cancel();
  EXPECT_FALSE(deep.is_pending());
}

}  // namespace
}  // namespace castaway::localization
