#include "tools/play/replay/spliced_kidnap.hpp"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/tools/support/recorded_frames.hpp"
#include "tests/tools/support/recorded_office.hpp"

namespace castaway::testbed {
namespace {

LaserScan scan_of(std::vector<float> ranges) {
  LaserScan scan;
  scan.ranges = std::move(ranges);
  return scan;
}

SE2 truth_at(const Frames& frames, std::size_t scan) {
  return std::get<ScanFrame>(frames[2 * scan + 1].data).true_pose->T_map_base;
}

bool is_another_place(const SE2& a, const SE2& b, const SpliceConfig& config) {
  return distance(a, b) >= config.min_distance_m || yaw_distance(a, b) >= config.min_turn_rad;
}

TEST(RangeDifference, IsTheMeanOfCappedDifferences) {
  const LaserScan one = scan_of({1.0F, 2.0F, 3.0F, std::numeric_limits<float>::infinity()});
  EXPECT_EQ(range_difference(one, one, 0.0), 0.0);
  EXPECT_NEAR(range_difference(one, scan_of({1.5F, 2.0F, 9.0F, 4.0F}), 0.0), 2.5 / 4.0, 1e-6);
  EXPECT_NEAR(range_difference(one, scan_of({1.5F, 2.0F, 9.0F, 4.0F}), 3.5), 1.5 / 4.0, 1e-6);
  EXPECT_EQ(range_difference(one, scan_of({1.0F}), 0.0), 1.0);
}

TEST(SplicedKidnap, LeadsFromHalfALogAwayByDefault) {
  const Frames frames = recorded_office(120).frames;
  const Splice at = choose_splice(frames, 10, {.lead = 20});
  EXPECT_EQ(at.to, 10U);
  EXPECT_EQ(at.from_first, 70U);
  EXPECT_EQ(at.from, 90U);
}

TEST(SplicedKidnap, LeadsFromTheNearestOtherPlace) {
  const Frames frames = recorded_office(120).frames;
  const SpliceConfig config{.kind = SpliceKind::kNear, .lead = 5};
  const Splice at = choose_splice(frames, 50, config);
  const SE2 to = truth_at(frames, 50);
  const double chosen = distance(truth_at(frames, at.from), to);
  EXPECT_EQ(at.from_first + 5, at.from);
  EXPECT_TRUE(is_another_place(truth_at(frames, at.from), to, config));
  for (std::size_t i = 5; i < 120; ++i) {
    if (is_another_place(truth_at(frames, i), to, config)) {
      EXPECT_LE(chosen, distance(truth_at(frames, i), to) + 1e-12) << i;
    }
  }
}

TEST(SplicedKidnap, AFloorAboveIsAnotherPlace) {
  const SpliceConfig config{.kind = SpliceKind::kNear, .lead = 2, .min_distance_m = 2.0};
  const auto at_height = [](double z) {
    Frames frames = straight_log(12);  // 1.1 m long.
    for (Frame& frame : frames) {
      auto* odometry = std::get_if<OdometryFrame>(&frame.data);
      if (odometry == nullptr) continue;
      odometry->true_pose->T_footprint_base = Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, z));
    }
    return frames;
  };
  Frames frames = at_height(0.0);
  EXPECT_THROW(choose_splice(frames, 6, config), std::runtime_error);
  for (const Frame& frame : at_height(3.0)) frames.push_back(frame);
  EXPECT_EQ(choose_splice(frames, 6, config).from, 18U);
}

TEST(SplicedKidnap, LeadsFromTheMostSimilarScanOfAnotherPlace) {
  const Frames frames = recorded_office(120).frames;
  const SpliceConfig config{.kind = SpliceKind::kLookAlike, .lead = 5};
  const Splice at = choose_splice(frames, 50, config);
  const auto scan = [&](std::size_t i) { return std::get<ScanFrame>(frames[2 * i + 1].data).scan; };
  const double chosen = range_difference(scan(at.from), scan(50), 0.0);
  EXPECT_TRUE(is_another_place(truth_at(frames, at.from), truth_at(frames, 50), config));
  for (std::size_t i = 5; i < 120; ++i) {
    if (is_another_place(truth_at(frames, i), truth_at(frames, 50), config)) {
      EXPECT_LE(chosen, range_difference(scan(i), scan(50), 0.0)) << i;
    }
  }
}

TEST(SplicedKidnap, RefusesALogWithoutAnotherPlace) {
  const Frames frames = recorded_office(5).frames;
  EXPECT_THROW(choose_splice(frames, 1, {.kind = SpliceKind::kNear, .lead = 1}),
               std::runtime_error);
}

TEST(SplicedKidnap, IsNamed) {
  EXPECT_EQ(parse_splice_kind("look-alike"), SpliceKind::kLookAlike);
  EXPECT_THROW(parse_splice_kind("lookalike"), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::testbed
