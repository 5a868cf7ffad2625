#include "localization/sensor/distance_filter.hpp"

#include <gtest/gtest.h>

#include "tests/support/grid_world.hpp"
#include "tests/support/scan_points.hpp"

namespace castaway::localization {
namespace {

class DistanceFilterTest : public testing::Test {
 protected:
  /// The first `count` beams end at this share of their range.
  ScanPoints shortened(std::size_t count, float share) const {
    ScanPoints points = all_;
    for (std::size_t i = 0; i < count; ++i) {
      points.x[i] = points.origin_x[i] + share * (points.x[i] - points.origin_x[i]);
      points.y[i] = points.origin_y[i] + share * (points.y[i] - points.origin_y[i]);
      points.range[i] *= share;
    }
    return points;
  }

  OccupancyGrid grid_ = test::office();
  DistanceField distances_{grid_, 5.0};
  WallClearance walls_{distances_};
  DistanceFilter filter_{{}, &walls_};
  SE2 pose_{3.0, 3.0, 0.4};
  ScanPoints all_ = test::points_from(grid_, pose_);
};

TEST_F(DistanceFilterTest, KeepsAScanThatFits) {
  EXPECT_EQ(filter_.expected(all_, pose_).x, all_.x);
}

TEST_F(DistanceFilterTest, LeavesOutBeamsThatEndBeforeWalls) {
  const std::size_t blocked = all_.size() / 3;
  const ScanPoints kept = filter_.expected(shortened(blocked, 0.4F), pose_);
  EXPECT_EQ(kept.x, std::vector<float>(all_.x.begin() + static_cast<std::ptrdiff_t>(blocked),
                                       all_.x.end()));
}

TEST_F(DistanceFilterTest, KeepsTheScanIfFewBeamsWouldRemain) {
  const ScanPoints crowded = shortened(all_.size() - 10, 0.4F);
  EXPECT_EQ(filter_.expected(crowded, pose_).x, crowded.x);
}

TEST_F(DistanceFilterTest, TakesAnEmptyScan) { EXPECT_TRUE(filter_.expected({}, pose_).empty()); }

}  // namespace
}  // namespace castaway::localization
