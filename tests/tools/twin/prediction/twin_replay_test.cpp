#include "tools/twin/prediction/twin_replay.hpp"

#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "tests/tools/support/recorded_frames.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tests/tools/twin/twin_logs.hpp"

namespace castaway::testbed {
namespace {

using std::chrono::milliseconds;

/// Ten scans from 10 s on, every 0.2 s; each has three beams.
RecordedPlace straight_place() {
  RecordedPlace place{"corridor", straight_log(10), {}};
  for (Frame& frame : place.frames) {
    if (auto* scan = std::get_if<ScanFrame>(&frame.data)) {
      scan->scan.ranges = {1.0F, 2.0F, 3.0F};
      scan->scan.angle_increment = 0.1;
    }
  }
  return place;
}

/// The alignment of its scans 2 to 5, whose aligned poses are 0.5 m beside the reference poses.
AlignedLog aligned_part(const RecordedPlace& place, bool by_truth) {
  AlignedLog log;
  log.by_truth = by_truth;
  log.T_path_base = localization::TransformBuffer({.hold = std::chrono::hours(1)});
  int index = 0;
  for (const Frame& frame : place.frames) {
    if (const auto* odometry = std::get_if<OdometryFrame>(&frame.data)) {
      log.T_path_base.add(frame.stamp, odometry->odometry.T_odom_base);
    } else if (const auto* scan = std::get_if<ScanFrame>(&frame.data)) {
      const int k = index++;
      log.stamps.push_back(scan->scan.stamp);
      if (k < 2 || k > 5) continue;
      log.scans.push_back({scan->scan, SE2{0.0, 0.5, 0.0} * scan->true_pose->T_map_base});
    }
  }
  log.T_odom_base = log.T_path_base;
  return log;
}

/// A twin's data: odometry every 0.1 s at 2 m/s, and `scans` scans with ranges 4, 5, 6.
Frames twin_frames(int scans) {
  Frames frames;
  for (int k = 0; k <= 10; ++k) {
    const Stamp stamp = milliseconds(100 * k);
    frames.push_back({stamp, OdometryFrame{{stamp, {0.2 * k, 0.0, 0.0}}, SE2{}}});
    if (k % 2 != 0 || k / 2 >= scans) continue;
    ScanFrame scan;
    scan.scan.stamp = stamp;
    scan.scan.ranges = {4.0F, 5.0F, 6.0F};
    frames.push_back({stamp, scan});
  }
  return frames;
}

/// The stamps of the scans of a twin are off by these errors.
Frames misstate(Frames twin, const std::vector<Stamp>& errors) {
  std::size_t next = 0;
  for (Frame& frame : twin) {
    if (auto* scan = std::get_if<ScanFrame>(&frame.data)) scan->scan.stamp += errors.at(next++);
  }
  return twin;
}

/// Where a twin's odometry, which drives at 2 m/s, is by time of the log. [m]
std::map<Stamp, double> shown_odometry(const std::vector<Stamp>& errors) {
  const RecordedPlace place = straight_place();
  const AlignedLog log = aligned_part(place, true);
  const Frames replay =
      replay_in_twin(played_part(place, log), log, misstate(twin_frames(4), errors));
  std::map<Stamp, double> shown;
  for (const Frame& frame : replay) {
    if (const auto* odometry = std::get_if<OdometryFrame>(&frame.data)) {
      shown[odometry->odometry.stamp] = odometry->odometry.T_odom_base.x;
    }
  }
  return shown;
}

template <typename Data>
std::vector<const Data*> all_of(const Frames& frames) {
  std::vector<const Data*> found;
  for (const Frame& frame : frames) {
    if (const auto* data = std::get_if<Data>(&frame.data)) found.push_back(data);
  }
  return found;
}

TEST(PlayedPart, IsFromTheFirstAlignedScanToTheLast) {
  const RecordedPlace place = straight_place();
  const RecordedPlace played = played_part(place, aligned_part(place, true));
  EXPECT_EQ(played.name, "corridor");
  const auto scans = all_of<ScanFrame>(played.frames);
  ASSERT_EQ(scans.size(), 4U);
  EXPECT_EQ(scans.front()->scan.stamp, milliseconds(10400));
  EXPECT_EQ(scans.back()->scan.stamp, milliseconds(11000));
  const auto odometry = all_of<OdometryFrame>(played.frames);
  ASSERT_EQ(odometry.size(), 11U);  // 0.2 s before and after, too
  EXPECT_EQ(odometry.front()->odometry.stamp, milliseconds(10200));
  EXPECT_EQ(odometry.back()->odometry.stamp, milliseconds(11200));
}

// Odometry may come seldom: the first scan needs the one before it.
TEST(PlayedPart, KeepsTheLastOdometryBeforeTheFirstScan) {
  RecordedPlace place = straight_place();
  std::erase_if(place.frames, [](const Frame& frame) {
    const auto* odometry = std::get_if<OdometryFrame>(&frame.data);
    const bool seldom = odometry != nullptr && odometry->odometry.stamp > milliseconds(10000) &&
                        odometry->odometry.stamp < milliseconds(11000);
    return seldom;
  });
  const RecordedPlace played = played_part(place, aligned_part(place, true));
  const auto odometry = all_of<OdometryFrame>(played.frames);
  ASSERT_FALSE(odometry.empty());
  EXPECT_EQ(odometry.front()->odometry.stamp, milliseconds(10000));
}

TEST(PlayedPart, KeepsReferencePosesWhereTheLogWasAlignedByThem) {
  const RecordedPlace place = straight_place();
  const RecordedPlace played = played_part(place, aligned_part(place, true));
  for (const ScanFrame* scan : all_of<ScanFrame>(played.frames)) {
    EXPECT_EQ(scan->true_pose->T_map_base.y, 0.0);
  }
}

TEST(PlayedPart, ElseHasTheAlignedPoses) {
  const RecordedPlace place = straight_place();
  const RecordedPlace played = played_part(place, aligned_part(place, false));
  const auto scans = all_of<ScanFrame>(played.frames);
  ASSERT_EQ(scans.size(), 4U);
  for (std::size_t k = 0; k < scans.size(); ++k) {
    const SE2 aligned{20.2 + 0.1 * static_cast<double>(k), 0.5, 0.0};
    EXPECT_LT(localization::distance(scans[k]->true_pose->T_map_base, aligned), 1e-9);
  }
  // Odometry is every 0.05 m; before the first scan and after the last it has their poses.
  const auto odometry = all_of<OdometryFrame>(played.frames);
  for (std::size_t k = 0; k < odometry.size(); ++k) {
    const double x = std::clamp(20.1 + 0.05 * static_cast<double>(k), 20.2, 20.5);
    EXPECT_LT(localization::distance(odometry[k]->true_pose->T_map_base, {x, 0.5, 0.0}), 1e-9) << k;
  }
}

TEST(PlayedPart, ComparesStampsOnTheClockOfOdometry) {
  const RecordedPlace place = straight_place();
  AlignedLog log = aligned_part(place, false);
  log.stamp_correction = milliseconds(30);
  for (AlignedScan& aligned : log.scans) aligned.scan.stamp += milliseconds(30);
  const RecordedPlace played = played_part(place, log);
  const auto scans = all_of<ScanFrame>(played.frames);
  ASSERT_EQ(scans.size(), 4U);
  EXPECT_EQ(scans.front()->scan.stamp, milliseconds(10400));  // as recorded
  EXPECT_LT(localization::distance(scans.front()->true_pose->T_map_base, {20.2, 0.5, 0.0}), 1e-9);
  const auto odometry = all_of<OdometryFrame>(played.frames);
  EXPECT_EQ(odometry.front()->odometry.stamp, milliseconds(10300));  // 10.23 to 11.23 s
  EXPECT_EQ(odometry.back()->odometry.stamp, milliseconds(11200));
}

TEST(PlayedPart, LeavesOutOtherLidars) {
  RecordedPlace place = straight_place();
  const AlignedLog log = aligned_part(place, true);
  Frames both;
  for (const Frame& frame : place.frames) {
    both.push_back(frame);
    if (!std::holds_alternative<ScanFrame>(frame.data)) continue;
    both.push_back(frame);
    std::get<ScanFrame>(both.back().data).scan.lidar = "rear";
  }
  place.frames = both;
  const RecordedPlace played = played_part(place, log);
  const auto scans = all_of<ScanFrame>(played.frames);
  EXPECT_EQ(scans.size(), 4U);
  for (const ScanFrame* scan : scans) EXPECT_EQ(scan->scan.lidar, "");
}

TEST(TwinReplay, HasTheLogsStampsAndPosesWithTheTwinsData) {
  const RecordedPlace place = straight_place();
  const AlignedLog log = aligned_part(place, true);
  const RecordedPlace played = played_part(place, log);
  const Frames replay = replay_in_twin(played, log, twin_frames(4));
  ASSERT_EQ(replay.size(), played.frames.size());
  for (std::size_t i = 0; i < replay.size(); ++i) {
    EXPECT_EQ(replay[i].stamp, played.frames[i].stamp);
    if (const auto* scan = std::get_if<ScanFrame>(&replay[i].data)) {
      const auto& in_log = std::get<ScanFrame>(played.frames[i].data);
      EXPECT_EQ(scan->scan.stamp, in_log.scan.stamp);
      EXPECT_EQ(scan->true_pose->T_map_base, in_log.true_pose->T_map_base);
      EXPECT_EQ(scan->scan.ranges, (std::vector<float>{4.0F, 5.0F, 6.0F}));
      EXPECT_EQ(scan->scan.angle_increment, in_log.scan.angle_increment);
    } else {
      const auto& odometry = std::get<OdometryFrame>(replay[i].data);
      const auto& in_log = std::get<OdometryFrame>(played.frames[i].data);
      EXPECT_EQ(odometry.odometry.stamp, in_log.odometry.stamp);
      EXPECT_EQ(odometry.true_pose->T_map_base, in_log.true_pose->T_map_base);
      // 2 m/s from the first scan, at 10.4 s, to the last, at 11 s.
      const double since =
          std::chrono::duration<double>(replay[i].stamp - milliseconds(10400)).count();
      EXPECT_NEAR(odometry.odometry.T_odom_base.x, 2.0 * std::clamp(since, 0.0, 0.6), 1e-9);
    }
  }
}

TEST(TwinReplay, TurnsRangesRoundForAClockwiseLidar) {
  RecordedPlace place = straight_place();
  for (Frame& frame : place.frames) {
    if (auto* scan = std::get_if<ScanFrame>(&frame.data)) scan->scan.angle_increment = -0.1;
  }
  const AlignedLog log = aligned_part(place, true);
  const Frames replay = replay_in_twin(played_part(place, log), log, twin_frames(4));
  for (const ScanFrame* scan : all_of<ScanFrame>(replay)) {
    EXPECT_EQ(scan->scan.ranges, (std::vector<float>{6.0F, 5.0F, 4.0F}));
  }
}

TEST(TwinReplay, MovesOdometryFromTheAxleToBase) {
  const AlignedLog log = turning_twin(0.25).log;
  RecordedPlace played{"turning", {}, {}};
  Frames twin;
  const auto add = [](Frames& frames, Stamp stamp, const SE2& pose) {
    frames.push_back({stamp, OdometryFrame{{stamp, pose}, std::nullopt}});
  };
  add(played.frames, std::chrono::seconds(5), {});
  add(played.frames, std::chrono::seconds(6), {});
  add(twin, Stamp{}, {});
  add(twin, std::chrono::seconds(1), {0.0, 0.0, 0.5 * std::numbers::pi});
  const Frames replay = replay_in_twin(played, log, twin);
  const auto odometry = all_of<OdometryFrame>(replay);
  ASSERT_EQ(odometry.size(), 2U);
  const SE2 first = odometry[0]->odometry.T_odom_base;
  const SE2 last = odometry[1]->odometry.T_odom_base;
  EXPECT_LT(localization::distance(first, {0.25, 0.0, 0.0}), 1e-4);
  EXPECT_LT(localization::distance(last, {0.0, 0.25, 0.0}), 1e-4);
  EXPECT_NEAR(last.yaw, 0.5 * std::numbers::pi, 1e-9);
}

TEST(TwinReplay, RefusesATwinWithOtherScans) {
  const RecordedPlace place = straight_place();
  const AlignedLog log = aligned_part(place, true);
  const RecordedPlace played = played_part(place, log);
  for (const int scans : {3, 5}) {
    const std::string error = error_of([&] { replay_in_twin(played, log, twin_frames(scans)); });
    EXPECT_TRUE(contains(error, "corridor: 4 scans, and " + std::to_string(scans)));
  }
}

// A scan of the twin that is stated 20 ms late has the odometry of 20 ms later: that is where the
// robot of the twin is by its odometry at that stamp.
TEST(TwinReplay, ShowsErrorsOfStampsAsOdometryThatIsLate) {
  const auto shown =
      shown_odometry({milliseconds(-30), milliseconds(20), milliseconds(-20), milliseconds(30)});
  // Scans from 10.4 s on, every 0.2 s, and odometry every 0.1 s at 2 m/s.
  EXPECT_NEAR(shown.at(milliseconds(10600)), 2.0 * (0.2 + 0.02), 1e-9);
  EXPECT_NEAR(shown.at(milliseconds(10800)), 2.0 * (0.4 - 0.02), 1e-9);
  // Between scans, errors change evenly.
  EXPECT_NEAR(shown.at(milliseconds(10500)), 2.0 * (0.1 - 0.005), 1e-9);
  EXPECT_NEAR(shown.at(milliseconds(10700)), 2.0 * 0.3, 1e-9);
  EXPECT_NEAR(shown.at(milliseconds(10900)), 2.0 * (0.5 + 0.005), 1e-9);
}

TEST(TwinReplay, DoesNotReachBeyondTheTwin) {
  const auto shown =
      shown_odometry({milliseconds(-60), milliseconds(0), milliseconds(0), milliseconds(60)});
  EXPECT_NEAR(shown.at(milliseconds(10400)), 0.0, 1e-9);
  EXPECT_NEAR(shown.at(milliseconds(11000)), 2.0 * 0.6, 1e-9);
  EXPECT_NEAR(shown.at(milliseconds(11100)), 2.0 * 0.6, 1e-9);
  EXPECT_NEAR(shown.at(milliseconds(10300)), 0.0, 1e-9);
}

// The replay has the log's own stamps, with their own offset.
TEST(TwinReplay, DoesNotCountAConstantErrorOfStamps) {
  const auto shown = shown_odometry(std::vector<Stamp>(4, milliseconds(40)));
  for (const auto& [stamp, x] : shown) {
    const double since = std::chrono::duration<double>(stamp - milliseconds(10400)).count();
    EXPECT_NEAR(x, 2.0 * std::clamp(since, 0.0, 0.6), 1e-9);
  }
}

}  // namespace
}  // namespace castaway::testbed
