#include "tools/play/replay/splice_target.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/tools/support/recorded_frames.hpp"
#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

/// Scans 0.1 m apart on the x axis from 20 m on; each has a beam that is as long as `range(k)`.
template <typename Range>
Frames log_with(int scans, Range range) {
  Frames frames = straight_log(scans);
  int k = 0;
  for (Frame& frame : frames) {
    if (auto* scan = std::get_if<ScanFrame>(&frame.data)) {
      scan->scan.ranges = {static_cast<float>(range(k++))};
    }
  }
  return frames;
}

Frames without_truth(Frames frames) {
  for (Frame& frame : frames) {
    if (auto* scan = std::get_if<ScanFrame>(&frame.data)) scan->true_pose.reset();
  }
  return frames;
}

TEST(SpliceTarget, IsTheNearestScan) {
  EXPECT_EQ(nearest_scan(straight_log(30), {21.24, 0.3, 0.0}), 12U);
  EXPECT_TRUE(contains(error_of([] {
                         nearest_scan(straight_log(30), {21.0, 2.5, 0.0});
                       }),
                       "never within 2 m of (21.00, 2.50) m"));
  EXPECT_THROW(nearest_scan(without_truth(straight_log(3)), {20.0, 0.0, 0.0}), std::runtime_error);
}

TEST(SpliceTarget, HeedsTheHeading) {
  Frames frames = straight_log(30);
  std::get<ScanFrame>(frames[3 * 20 + 1].data).true_pose = SE2{21.5, 0.0, 3.0};
  EXPECT_EQ(nearest_scan(frames, {21.5, 0.0, 3.0}), 20U);
  EXPECT_EQ(nearest_scan(frames, {21.5, 0.0, 0.0}), 15U);
}

TEST(SpliceTarget, IsOnTheFloorThatIsChosen) {
  Frames frames = straight_log(30);
  for (const std::size_t scan : {12U, 25U}) {
    std::get<ScanFrame>(frames[3 * scan + 1].data).true_pose->T_footprint_base =
        Eigen::Translation3d(0.0, 0.0, 3.0) * Eigen::Isometry3d::Identity();
  }
  const SE2 place{21.24, 0.3, 0.0};
  EXPECT_EQ(nearest_scan(frames, place, [](double z) { return z > 2.0; }), 12U);
  EXPECT_EQ(nearest_scan(frames, place, [](double z) { return z < 2.0; }), 13U);
  EXPECT_THROW(nearest_scan(frames, place, [](double z) { return z > 5.0; }), std::runtime_error);
  EXPECT_EQ(far_scan(frames, 12, 2.9), 27U);  // So far away by its height only.
}

TEST(SpliceTarget, IsFarAwayInTheLogAndInTheBuilding) {
  EXPECT_EQ(far_scan(straight_log(40), 5, 1.0), 25U);
  EXPECT_EQ(far_scan(straight_log(40), 30, 1.0), 10U);
  EXPECT_EQ(far_scan(straight_log(40), 5, 2.55), 31U);  // The first one after the half that is far.
  EXPECT_EQ(far_scan(without_truth(straight_log(40)), 5, 100.0), 25U);
  EXPECT_THROW(far_scan(straight_log(40), 5, 9.0), std::runtime_error);
}

TEST(SpliceTarget, LooksAlike) {
  const Frames frames = log_with(40, [](int k) { return k == 33 ? 5.1 : k == 5 ? 5.0 : 6.0; });
  EXPECT_EQ(look_alike_scan(frames, 5, 1.0), 33U);
  EXPECT_THROW(look_alike_scan(frames, 5, 9.0), std::runtime_error);
  EXPECT_THROW(look_alike_scan(without_truth(frames), 5, 1.0), std::runtime_error);
}

}  // namespace
}  // namespace castaway::testbed
