#include "tools/build/recorded/recorded_source.hpp"

#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/tools/support/recorded_frames.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/build/recorded/spliced_source.hpp"

namespace castaway::testbed {
namespace {

using std::chrono::milliseconds;

const OdometryFrame* odometry_in(const Frame& frame) {
  return std::get_if<OdometryFrame>(&frame.data);
}

const ScanFrame* scan_in(const Frame& frame) { return std::get_if<ScanFrame>(&frame.data); }

std::size_t event_position(const Frames& frames) {
  const auto event = std::find_if(frames.begin(), frames.end(), [](const Frame& frame) {
    return std::holds_alternative<RunEvent>(frame.data);
  });
  return static_cast<std::size_t>(event - frames.begin());
}

TEST(ScanPositions, AreOfOdometryWhateverComesBetween) {
  Frames frames;
  for (const Frame& frame : straight_log(3)) {
    if (scan_in(frame) != nullptr) frames.push_back({frame.stamp, ImuFrame{}});
    frames.push_back(frame);
  }
  EXPECT_EQ(scan_positions(frames), (std::vector<std::size_t>{0, 4, 8}));
}

TEST(Stretch, IsTheLogFromAScanOnForATime) {
  const Frames frames = straight_log(10);
  EXPECT_EQ(scan_positions(frames), (std::vector<std::size_t>{0, 3, 6, 9, 12, 15, 18, 21, 24, 27}));
  const Frames part = stretch(frames, 4, milliseconds(400));
  ASSERT_EQ(part.size(), 8U);  // scans 4, 5 and 6 with their odometry, and two odometry readings
                               // between
  EXPECT_EQ(part.front().stamp, std::chrono::seconds(10) + milliseconds(800));
  ASSERT_NE(odometry_in(part.front()), nullptr);
  EXPECT_DOUBLE_EQ(odometry_in(part.front())->odometry.T_odom_base.x, 0.4);
  EXPECT_EQ(part.back().stamp, std::chrono::seconds(10) + milliseconds(1200));
  EXPECT_NE(scan_in(part.back()), nullptr);
}

TEST(Stretch, EndsWithTheLog) {
  EXPECT_EQ(stretch(straight_log(10), 9, std::chrono::seconds(60)).size(), 3U);
  EXPECT_EQ(stretch(straight_log(10), 0, Stamp::max()).size(), 30U);
}

TEST(Stretch, NeedsItsScan) {
  const std::string error =
      error_of([] { stretch(straight_log(10), 10, std::chrono::seconds(1)); });
  EXPECT_TRUE(contains(error, "no scan 10: the log has 10"));
  EXPECT_THROW(stretch(Frames{}, 0, std::chrono::seconds(1)), std::out_of_range);
}

TEST(Splice, TellsOfTheJumpBetweenItsTwoStretches) {
  const Frames part = splice(straight_log(50), {5, 8, 30, std::chrono::seconds(60)});
  const std::size_t at = event_position(part);
  ASSERT_EQ(at, 3U * 3 + 2);  // scans 5, 6 and 7 with their odometry, then scan 8
  ASSERT_NE(scan_in(part[at - 1]), nullptr);
  const auto& event = std::get<RunEvent>(part[at].data);
  EXPECT_TRUE(event.is<KidnapEvent>());
  EXPECT_EQ(event.stamp, part[at].stamp);
  EXPECT_EQ(event.stamp, part[at - 1].stamp + milliseconds(200));
  EXPECT_DOUBLE_EQ(event.T_map_from->x, 20.8);
  EXPECT_DOUBLE_EQ(event.T_map_to->x, 23.0);
  ASSERT_NE(scan_in(part[at + 2]), nullptr);
  EXPECT_DOUBLE_EQ(scan_in(part[at - 1])->true_pose->T_map_base.x, 20.8);
  EXPECT_DOUBLE_EQ(scan_in(part[at + 2])->true_pose->T_map_base.x, 23.0);
}

TEST(Splice, OdometryRunsOnAcrossTheJump) {
  const Frames part = splice(straight_log(50), {5, 8, 30, std::chrono::seconds(60)});
  const std::size_t at = event_position(part);
  EXPECT_NEAR(odometry_in(part[at - 2])->odometry.T_odom_base.x, 0.8, 1e-12);
  EXPECT_NEAR(odometry_in(part[at + 1])->odometry.T_odom_base.x, 0.8, 1e-12);
  EXPECT_NEAR(odometry_in(part[at + 3])->odometry.T_odom_base.x, 0.85, 1e-12);
}

TEST(Splice, TurnsTheOdometryThatFollows) {
  Frames frames = straight_log(4);
  auto& before = std::get<OdometryFrame>(frames[3].data).odometry;  // of scan 1
  before.T_odom_base.yaw = 0.5 * 3.14159265358979;
  const Frames part = splice(frames, {1, 1, 2, std::chrono::seconds(60)});
  const auto& after = odometry_in(part[event_position(part) + 3])->odometry;
  EXPECT_NEAR(after.T_odom_base.x, 0.1, 1e-12);  // 5 cm forward, now along y
  EXPECT_NEAR(after.T_odom_base.y, 0.05, 1e-12);
}

TEST(Splice, TimeGoesOnByItsOldSteps) {
  for (const std::size_t to : {30U, 2U}) {  // forwards and backwards in the log
    const Frames part = splice(straight_log(50), {5, 8, to, std::chrono::seconds(1)});
    std::vector<Stamp> scans;
    for (std::size_t i = 0; i < part.size(); ++i) {
      EXPECT_GE(part[i].stamp, part[i == 0 ? 0 : i - 1].stamp);
      if (const auto* odometry = odometry_in(part[i])) {
        EXPECT_EQ(odometry->odometry.stamp, part[i].stamp);
      }
      if (scan_in(part[i]) == nullptr) continue;
      EXPECT_EQ(scan_in(part[i])->scan.stamp, part[i].stamp);
      scans.push_back(part[i].stamp);
    }
    ASSERT_EQ(scans.size(), 4U + 6U);  // after the jump: 0 to 1 s
    for (std::size_t i = 1; i < scans.size(); ++i) {
      EXPECT_EQ(scans[i] - scans[i - 1], milliseconds(200)) << i;
    }
  }
}

TEST(Splice, FromTheLastScanLeavesATenthOfASecond) {
  const Frames part = splice(straight_log(5), {3, 4, 0, std::chrono::seconds(60)});
  const std::size_t at = event_position(part);
  EXPECT_EQ(part[at].stamp - part[at - 1].stamp, milliseconds(100));
}

TEST(Splice, RefusesWhatIsNotThere) {
  const Frames frames = straight_log(10);
  EXPECT_THROW(splice(frames, {10, 10, 0, std::chrono::seconds(1)}), std::out_of_range);
  EXPECT_THROW(splice(frames, {0, 10, 0, std::chrono::seconds(1)}), std::out_of_range);
  EXPECT_THROW(splice(frames, {0, 5, 10, std::chrono::seconds(1)}), std::out_of_range);
  EXPECT_THROW(splice(frames, {6, 5, 0, std::chrono::seconds(1)}), std::invalid_argument);
}

TEST(RecordedSource, PlaysItsFramesOnce) {
  RecordedSource source(straight_log(2));
  EXPECT_EQ(source.duration(), milliseconds(300));
  EXPECT_DOUBLE_EQ(source.start_pose()->x, 20.0);
  EXPECT_TRUE(source.cpu_by_stage().empty());
  int frames = 0;
  while (source.next()) ++frames;
  EXPECT_EQ(frames, 6);
  EXPECT_FALSE(source.next());
}

TEST(RecordedSource, StartsAtTheFirstTruth) {
  Frames frames = straight_log(2);
  std::get<OdometryFrame>(frames[0].data).true_pose.reset();
  EXPECT_DOUBLE_EQ(RecordedSource(frames).start_pose()->x, 20.05);
  EXPECT_FALSE(RecordedSource(Frames{}).start_pose());
  EXPECT_EQ(RecordedSource(Frames{}).duration(), Stamp::zero());
}

}  // namespace
}  // namespace castaway::testbed
