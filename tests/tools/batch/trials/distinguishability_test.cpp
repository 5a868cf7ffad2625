#include "tools/batch/trials/distinguishability.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/scan_points.hpp"
#include "tests/support/string_map.hpp"

namespace castaway::testbed {
namespace {

using localization::from_seconds;
using localization::SE2;

/// Rooms of 4 x 5 m, 4 x 5 m and 8 x 5 m between walls of 1 m. From 2 m behind the wall on the
/// left, a beam to the right ends after 2.25 m: within a wall in the twins, on free floor in the
/// third room.
class DistinguishabilityTest : public ::testing::Test {
 protected:
  static std::vector<std::string> rooms() {
    std::vector<std::string> rows(14, "##........##........##................##");
    for (const std::size_t wall : {0, 1, 12, 13}) rows[wall] = std::string(rows[0].size(), '#');
    return rows;
  }

  /// Takes a scan of one beam after `t` [s], `way` [m] above the target of the kidnap.
  static void take(double t, double way, const SE2& T_map_to, Distinguishability& places) {
    places.take(from_seconds(t), test::forward_beams({2.25F}),
                {T_map_to.x, T_map_to.y + way, T_map_to.yaw});
  }

  const SE2 room_{3.0, 2.0, 0.0};
  const SE2 twin_{8.0, 2.0, 0.0};
  const SE2 other_{13.0, 2.0, 0.0};
  localization::OccupancyGrid map_ = test::string_map(rooms(), 0.5);
  localization::DistanceField distances_{map_, 5.0};
  /// Scans of one beam count in full.
  static localization::EvidenceConfig full() {
    localization::EvidenceConfig config;
    config.endpoint = {0.12, 0.08, 12.0};  // The other place is at the minimum.
    config.per_beam = config.endpoint.independent_beams;
    config.right_pose = 0.0;
    return config;
  }
  localization::EvidenceModel evidence_{full(), map_, distances_};
};

TEST_F(DistinguishabilityTest, AreTwinsNever) {
  Distinguishability places(evidence_, room_, twin_);
  for (int i = 0; i < 100; ++i) take(i, 1.2 * (i % 2), twin_, places);
  EXPECT_EQ(places.sum(), 0.0);
  EXPECT_FALSE(places.since());
}

TEST_F(DistinguishabilityTest, FollowsATwinThatIsALittleOff) {
  // Without the kidnap, the beam would end 0.1 m before the wall's face; a localizer moves there.
  Distinguishability places(evidence_, {room_.x - 0.1, room_.y, room_.yaw}, twin_);
  for (int i = 0; i < 100; ++i) take(i, 1.2 * (i % 2), twin_, places);
  EXPECT_LT(places.sum(), 2.0);
  EXPECT_FALSE(places.since());
}

TEST_F(DistinguishabilityTest, AreDifferentPlacesAtOnce) {
  Distinguishability places(evidence_, other_, twin_);
  take(4.0, 1.2, twin_, places);
  EXPECT_NEAR(places.sum(), 25.0, 1e-9);  // the least evidence of a scan, at the pose in `other_`
  EXPECT_EQ(places.since(), from_seconds(4.0));
}

TEST_F(DistinguishabilityTest, CountsTheNewShareOfEachScan) {
  Distinguishability places(evidence_, other_, twin_);
  take(1.0, 0.3, twin_, places);  // a quarter of 1.2 m
  EXPECT_NEAR(places.sum(), 6.25, 1e-9);
  take(2.0, 0.6, twin_, places);
  EXPECT_FALSE(places.since());
  take(3.0, 0.9, twin_, places);
  EXPECT_NEAR(places.sum(), 18.75, 1e-9);
  EXPECT_EQ(places.since(), from_seconds(3.0));
}

TEST_F(DistinguishabilityTest, CountsALittleAtRest) {
  Distinguishability places(evidence_, other_, twin_);
  for (int i = 0; i < 3; ++i) take(i, 0.0, twin_, places);
  EXPECT_NEAR(places.sum(), 3 * 0.15 * 25.0, 1e-9);
  EXPECT_FALSE(places.since());
}

TEST_F(DistinguishabilityTest, CountsScansAtTheRateOfCorrections) {
  Distinguishability places(evidence_, other_, twin_);
  for (int i = 0; i < 8; ++i) take(0.025 * i, 0.0, twin_, places);  // 40 Hz; used: 0 s and 0.1 s
  EXPECT_NEAR(places.sum(), 2 * 0.15 * 25.0, 1e-9);
}

TEST_F(DistinguishabilityTest, PassesOverScansWithoutBeams) {
  Distinguishability places(evidence_, other_, twin_);
  places.take(from_seconds(1.0), {}, {8.0, 2.6, 0.0});
  take(2.0, 1.2, twin_, places);
  EXPECT_NEAR(places.sum(), 25.0, 1e-9);  // new by the motion since the kidnap
}

TEST_F(DistinguishabilityTest, StaysWhateverFollows) {
  Distinguishability places(evidence_, other_, twin_);
  take(1.0, 1.2, twin_, places);
  // 6.25 m to the right of the twin is the middle of the third room; of the third room, its wall.
  for (int i = 2; i < 5; ++i) {
    places.take(from_seconds(i), test::forward_beams({6.25F}), {8.0, 2.0 + 1.2 * (i % 2), 0.0});
  }
  EXPECT_NEAR(places.sum(), 25.0 - 3 * 25.0, 1e-9);
  EXPECT_EQ(places.since(), from_seconds(1.0));
}

TEST_F(DistinguishabilityTest, MovesThePlaceWithoutTheKidnapAlong) {
  const double left = 0.5 * std::numbers::pi;
  Distinguishability places(evidence_, room_, {13.0, 3.0, left});
  // 1.2 m straight ahead: without the kidnap to (4.2, 2), 1.05 m before the middle of a wall's
  // cell.
  places.take(from_seconds(1.0), test::forward_beams({1.05F}), {13.0, 4.2, left});
  EXPECT_NEAR(places.sum(), -25.0, 0.1);  // Refinement gains a little at the true pose.
  EXPECT_FALSE(places.since());
}

}  // namespace
}  // namespace castaway::testbed
