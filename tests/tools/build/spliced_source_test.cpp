#include "tools/build/recorded/spliced_source.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/tools/support/recorded_frames.hpp"
#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

SplicedSource source_of(int scans, SplicedPart part = {}) {
  return {std::make_shared<const Frames>(straight_log(scans)), std::move(part)};
}

/// Plays up to the next scan.
void play_scan(SplicedSource& source) {
  while (auto frame = source.next()) {
    if (std::holds_alternative<ScanFrame>(frame->data)) return;
  }
}

/// Each frame as its kind and its stamp [ms].
std::vector<std::string> listed(const Frames& frames) {
  std::vector<std::string> list;
  for (const Frame& frame : frames) {
    list.push_back(std::to_string(frame.data.index()) + " " +
                   std::to_string(frame.stamp.count() / 1'000'000));
  }
  return list;
}

TEST(SplicedSource, PlaysTheLogAsItIs) {
  SplicedSource source = source_of(5);
  EXPECT_EQ(listed(all_frames(source)), listed(straight_log(5)));
  EXPECT_EQ(source.played(), 5U);
  EXPECT_EQ(source.last_scan(), 4U);
  EXPECT_FALSE(source.next());
}

TEST(SplicedSource, PlaysAPart) {
  SplicedSource source = source_of(9, {3, 2, {}});
  const Frames part = all_frames(source);
  EXPECT_EQ(part.size(), 5U);
  EXPECT_EQ(listed(part).front(), "0 10600");
  EXPECT_DOUBLE_EQ(source.start_pose()->x, 20.3);
}

TEST(SplicedSource, MovesImuReadingsInTimeAndKnowsHeights) {
  Frames log = straight_log(6);
  for (Frame& frame : log) {
    auto* odometry = std::get_if<OdometryFrame>(&frame.data);
    if (odometry == nullptr) continue;
    odometry->true_pose->T_footprint_base = Eigen::Isometry3d::Identity();
    odometry->true_pose->T_footprint_base->translation().z() = odometry->true_pose->T_map_base.x;
  }
  Frames with_imu;
  for (const Frame& frame : log) {
    with_imu.push_back(frame);
    if (std::holds_alternative<OdometryFrame>(frame.data)) {
      ImuFrame imu;
      imu.imu.stamp = frame.stamp;
      with_imu.push_back({frame.stamp, imu});
    }
  }
  SplicedSource source(std::make_shared<const Frames>(with_imu), {0, {}, {{2, 5}}});
  EXPECT_EQ(source.start_height(), source.start_pose()->x);
  for (const Frame& frame : all_frames(source)) {
    if (const auto* imu = std::get_if<ImuFrame>(&frame.data)) {
      EXPECT_EQ(imu->imu.stamp, frame.stamp);
    } else if (const auto* event = std::get_if<RunEvent>(&frame.data)) {
      EXPECT_EQ(event->as<KidnapEvent>()->heights,
                Eigen::Vector2d(event->T_map_from->x, event->T_map_to->x));
    }
  }
}

TEST(SplicedSource, JumpsSeveralTimes) {
  SplicedSource source = source_of(20, {0, {}, {{2, 10}, {4, 1}}});
  const Frames frames = all_frames(source);
  std::vector<double> truths;
  int kidnaps = 0;
  for (const Frame& frame : frames) {
    if (const auto* scan = std::get_if<ScanFrame>(&frame.data)) {
      truths.push_back(scan->true_pose->T_map_base.x);
    }
    kidnaps += std::holds_alternative<RunEvent>(frame.data) ? 1 : 0;
  }
  EXPECT_EQ(kidnaps, 2);
  ASSERT_EQ(truths.size(), 4U + 19U);
  EXPECT_DOUBLE_EQ(truths[1], 20.1);
  EXPECT_DOUBLE_EQ(truths[2], 21.0);
  EXPECT_DOUBLE_EQ(truths[4], 20.1);
}

TEST(SplicedSource, OdometryRunsOnAcrossAllJumps) {
  SplicedSource source = source_of(20, {0, {}, {{2, 10}, {4, 1}}});
  double x = 0.0;
  for (const Frame& frame : all_frames(source)) {
    const auto* odometry = std::get_if<OdometryFrame>(&frame.data);
    if (odometry == nullptr) continue;
    const double step = odometry->odometry.T_odom_base.x - x;
    EXPECT_TRUE(step > -1e-12 && step < 0.0501) << step;
    EXPECT_EQ(odometry->odometry.stamp, frame.stamp);
    x = odometry->odometry.T_odom_base.x;
  }
  EXPECT_NEAR(x, 0.05 * 2 + 0.05 * 2 + 0.05 * 37 + 0.05 * 0, 0.11);
}

TEST(SplicedSource, AJumpByHandIsOneThatWasAskedForBefore) {
  SplicedSource by_hand = source_of(20);
  for (int i = 0; i < 3; ++i) play_scan(by_hand);
  EXPECT_EQ(by_hand.jump(12).after_scans, 3U);  // At once, after a scan.
  play_scan(by_hand);
  (void)by_hand.next();                        // An odometry reading.
  EXPECT_EQ(by_hand.jump(5).after_scans, 5U);  // After the next scan.
  EXPECT_EQ(by_hand.jump(2).after_scans, 5U);  // In place of that.
  const Frames rest = all_frames(by_hand);
  SplicedSource asked = source_of(20, {0, {}, by_hand.jumps()});
  const Frames whole = all_frames(asked);
  EXPECT_EQ(by_hand.jumps().size(), 2U);
  ASSERT_GT(whole.size(), rest.size());
  const Frames tail(whole.end() - static_cast<std::ptrdiff_t>(rest.size()), whole.end());
  EXPECT_EQ(listed(rest), listed(tail));
  EXPECT_EQ(by_hand.played(), asked.played());
}

TEST(SplicedSource, CarriesTheTruthOnByOdometry) {
  Frames frames = straight_log(6);
  for (Frame& frame : frames) {  // As in CARMEN logs: only scans have a true pose.
    auto* odometry = std::get_if<OdometryFrame>(&frame.data);
    if (odometry != nullptr && frame.stamp % std::chrono::milliseconds(200) != Stamp{}) {
      odometry->true_pose.reset();
    }
  }
  SplicedSource source(std::make_shared<const Frames>(frames), {0, {}, {{2, 4}}});
  EXPECT_FALSE(source.true_pose());
  play_scan(source);
  (void)source.next();
  EXPECT_NEAR(source.true_pose()->x, 20.05, 1e-9);
  play_scan(source);
  (void)source.next();
  EXPECT_FALSE(source.true_pose());  // A jump.
  (void)source.next();
  EXPECT_NEAR(source.true_pose()->x, 20.4, 1e-9);
}

TEST(SplicedSource, RefusesScansThatTheLogDoesNotHave) {
  EXPECT_THROW(source_of(5, {5, {}, {}}), std::out_of_range);
  EXPECT_THROW(source_of(5, {0, {}, {{2, 5}}}), std::out_of_range);
  EXPECT_THROW(source_of(5, {0, {}, {{6, 1}}}), std::out_of_range);
  EXPECT_THROW(source_of(5, {0, {}, {{2, 4}, {4, 0}}}), std::out_of_range);
  EXPECT_THROW(source_of(5, {0, {}, {{2, 1}, {2, 1}}}), std::invalid_argument);
  EXPECT_THROW(source_of(5, {0, {}, {{0, 1}}}), std::invalid_argument);
  EXPECT_THROW(source_of(5).jump(5), std::out_of_range);
}

/// As in bags, where odometry and scans have clocks of their own.
TEST(SplicedSource, TakesTheLastOdometryBeforeTheScan) {
  Frames frames = straight_log(6);
  std::erase_if(frames, [&, i = 0](const Frame&) mutable { return i++ % 6 == 3; });
  SplicedSource source(std::make_shared<const Frames>(frames), {0, {}, {{1, 3}}});
  const Frames played = all_frames(source);
  ASSERT_TRUE(std::holds_alternative<RunEvent>(played[2].data));
  EXPECT_TRUE(std::holds_alternative<OdometryFrame>(played[3].data));
  EXPECT_TRUE(std::holds_alternative<ScanFrame>(played[4].data));
}

}  // namespace
}  // namespace castaway::testbed
