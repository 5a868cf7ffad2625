// Over 400 lines: all tests take logs from the same makers.
#include "tools/twin/alignment/aligned_log.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include <gtest/gtest.h>
#include <boost/random/normal_distribution.hpp>

#include "tests/tools/support/recorded_office.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tests/tools/twin/room_log.hpp"

namespace castaway::testbed {
namespace {

using std::chrono::milliseconds;

constexpr float kNothingSeen = std::numeric_limits<float>::infinity();
constexpr double kWithin = 0.01;  // [m] Distances of aligned poses from exact ones, at most.

/// The scans of a log with their frames.
std::vector<ScanFrame*> scans_in(Frames& frames) {
  std::vector<ScanFrame*> scans;
  for (Frame& frame : frames) {
    if (auto* scan = std::get_if<ScanFrame>(&frame.data)) scans.push_back(scan);
  }
  return scans;
}

/// True poses of a log by stamp.
std::map<Stamp, SE2> true_poses(Frames frames) {
  std::map<Stamp, SE2> poses;
  for (const ScanFrame* scan : scans_in(frames))
    poses[scan->scan.stamp] = scan->true_pose->T_map_base;
  return poses;
}

void expect_aligned(const AlignedLog& log, const std::map<Stamp, SE2>& truth, double within) {
  for (const AlignedScan& aligned : log.scans) {
    const SE2& T_map_base = truth.at(aligned.scan.stamp);
    EXPECT_LT(localization::distance(aligned.T_map_base, T_map_base), within);
    EXPECT_LT(localization::yaw_distance(aligned.T_map_base, T_map_base), within);
  }
}

/// Inserts a kidnap before a scan and its odometry.
void insert_kidnap(Frames& frames, std::size_t scan) {
  const auto at = frames.begin() + static_cast<std::ptrdiff_t>(scan_positions(frames).at(scan));
  RunEvent kidnap;
  kidnap.stamp = at->stamp;
  kidnap.what = KidnapEvent{};
  frames.insert(at, {kidnap.stamp, kidnap});
}

/// Beams of the office end where its wall cells begin.
ScanCorrection at_borders(Stamp shift = {}) {
  ScanCorrection correction;
  correction.stamp = shift;
  correction.walls = WallOffsets(test::office().frame, 0.0);
  return correction;
}

void blind(ScanFrame& frame) { frame.scan.ranges.assign(frame.scan.ranges.size(), kNothingSeen); }

TEST(AlignedLog, HasTheScansAndTheOdometryOfTheLog) {
  const RecordedPlace place = recorded_office(60);
  const AlignedLog log = align_log(place, AlignBy::kTruth, at_borders());
  EXPECT_EQ(log.name, "office");
  EXPECT_EQ(log.grid.cells, test::office().cells);
  EXPECT_NEAR(log.odometry_period_s, 0.2, 1e-9);
  EXPECT_TRUE(log.by_truth);
  EXPECT_EQ(log.left_out, 0U);
  ASSERT_EQ(log.scans.size(), 60U);
  for (std::size_t k = 0; k < 60; ++k) {
    EXPECT_EQ(log.scans[k].scan.stamp, k * milliseconds(200));
    EXPECT_FALSE(log.scans[k].breaks);
  }
  const auto& odometry = std::get<OdometryFrame>(place.frames[0].data).odometry;
  EXPECT_EQ(*log.T_odom_base.at(odometry.stamp), odometry.T_odom_base);  // none is dropped
  expect_aligned(log, true_poses(place.frames), kWithin);
}

TEST(AlignedLog, PullsPosesBackOntoTheWalls) {
  const RecordedPlace office = recorded_office(50);
  const auto truth = true_poses(office.frames);
  for (const SE2& off :
       {SE2{0.03, 0.0, 0.0}, SE2{-0.02, -0.02, 0.0}, SE2{0.0, 0.03, 0.01}, SE2{0.0, 0.0, -0.02}}) {
    RecordedPlace place = office;
    for (ScanFrame* scan : scans_in(place.frames)) {
      scan->true_pose = scan->true_pose->T_map_base * off;
    }
    expect_aligned(align_log(place, AlignBy::kAuto, at_borders()), truth, kWithin);
  }
}

// Where only one of two opposite walls is seen, its end points pull the pose half a cell.
TEST(AlignedLog, WithoutTheSurfacesOfWallsPutsThemAtTheCentresOfCells) {
  const RecordedPlace place = recorded_office(60);
  const auto truth = true_poses(place.frames);
  const AlignedLog log = align_log(place, AlignBy::kTruth);
  expect_aligned(log, truth, 0.025 * std::numbers::sqrt2 + 0.005);
  const auto far = std::count_if(log.scans.begin(), log.scans.end(), [&](const auto& aligned) {
    return localization::distance(aligned.T_map_base, truth.at(aligned.scan.stamp)) > kWithin;
  });
  EXPECT_GT(far, 20);
}

TEST(AlignedLog, WithTheSurfacesOfWallsIsRightWhereOneOfTwoOppositeWallsIsSeen) {
  RecordedPlace place = recorded_office(50);
  const auto truth = true_poses(place.frames);
  for (ScanFrame* frame : scans_in(place.frames)) {
    const SE2 T_map_base = frame->true_pose->T_map_base;
    frame->scan = room_scan(test::office(), T_map_base, frame->scan.stamp);
    for (std::size_t i = 0; i < frame->scan.ranges.size(); ++i) {
      const double to_corner =
          T_map_base.yaw + frame->scan.beam_angle(i) - 1.25 * std::numbers::pi;  // left, below
      if (std::cos(to_corner) < 0.6) frame->scan.ranges[i] = kNothingSeen;
    }
  }
  expect_aligned(align_log(place, AlignBy::kTruth, at_borders()), truth, kWithin);
}

TEST(AlignedLog, PassesOverReadingsOfAnImu) {
  RecordedPlace place = recorded_office(60);
  const std::size_t scans = align_log(place, AlignBy::kTruth).scans.size();
  place.frames.insert(place.frames.begin() + 5, Frame{place.frames[5].stamp, ImuFrame{}});
  EXPECT_EQ(align_log(place, AlignBy::kTruth).scans.size(), scans);
}

TEST(AlignedLog, NeedsFiftyScans) {
  EXPECT_NO_THROW(align_log(recorded_office(50), AlignBy::kTruth));
  const std::string error = error_of([] { align_log(recorded_office(49), AlignBy::kTruth); });
  EXPECT_TRUE(contains(error, "office: 49 scans can be aligned with the map"));
  EXPECT_TRUE(contains(error, "at least 50 are needed"));
  RecordedPlace empty = recorded_office(1);
  empty.frames.clear();
  EXPECT_TRUE(contains(error_of([&] { align_log(empty, AlignBy::kAuto); }), "office: 0 scans"));
}

TEST(AlignedLog, WantsReferencePosesOfMostScansIfAskedTo) {
  RecordedPlace place = recorded_office(60);
  const std::vector<ScanFrame*> scans = scans_in(place.frames);
  for (std::size_t k = 0; k < 29; ++k) scans[k]->true_pose.reset();
  EXPECT_NO_THROW(align_log(place, AlignBy::kTruth));
  scans[29]->true_pose.reset();
  const std::string error = error_of([&] { align_log(place, AlignBy::kTruth); });
  EXPECT_TRUE(contains(error, "office: most of its scans have no reference pose"));
  EXPECT_TRUE(contains(error, "--align"));
}

TEST(AlignedLog, TracksBackwardsWhereTheBeginningHasNoPose) {
  RecordedPlace place = recorded_office(65);
  const auto truth = true_poses(place.frames);
  const std::vector<ScanFrame*> scans = scans_in(place.frames);
  for (std::size_t k = 0; k < 20; ++k) scans[k]->true_pose.reset();
  // A gap of 1 s, in which the robot moves by more than the alignment reaches.
  const auto in_gap = [](const Frame& frame) {
    return std::holds_alternative<ScanFrame>(frame.data) && frame.stamp > milliseconds(3000) &&
           frame.stamp < milliseconds(4000);
  };
  std::erase_if(place.frames, in_gap);
  const AlignedLog log = align_log(place, AlignBy::kTruth, at_borders());
  EXPECT_EQ(log.scans.size(), 61U);
  EXPECT_EQ(log.left_out, 0U);
  expect_aligned(log, truth, kWithin);
}

TEST(AlignedLog, DoesNotTrackBackwardsThroughAKidnap) {
  RecordedPlace place = recorded_office(80);
  const std::vector<ScanFrame*> scans = scans_in(place.frames);
  for (std::size_t k = 0; k < 20; ++k) scans[k]->true_pose.reset();
  insert_kidnap(place.frames, 15);
  const AlignedLog log = align_log(place, AlignBy::kTruth);
  EXPECT_EQ(log.left_out, 15U);
  ASSERT_EQ(log.scans.size(), 65U);
  EXPECT_EQ(log.scans.front().scan.stamp, 15 * milliseconds(200));
}

TEST(AlignedLog, BreaksAtAKidnap) {
  RecordedPlace place = recorded_office(60);
  insert_kidnap(place.frames, 30);
  const AlignedLog log = align_log(place, AlignBy::kTruth);
  ASSERT_EQ(log.scans.size(), 60U);
  for (std::size_t k = 0; k < 60; ++k) EXPECT_EQ(log.scans[k].breaks, k == 30) << k;
}

TEST(AlignedLog, BreaksAtTheFirstScanAfterAKidnapThatHasAPose) {
  RecordedPlace place = recorded_office(60);
  blind(*scans_in(place.frames)[30]);
  insert_kidnap(place.frames, 30);
  const AlignedLog log = align_log(place, AlignBy::kTruth);
  EXPECT_EQ(log.left_out, 1U);
  ASSERT_EQ(log.scans.size(), 59U);
  EXPECT_EQ(log.scans[30].scan.stamp, 31 * milliseconds(200));
  for (std::size_t k = 0; k < 59; ++k) EXPECT_EQ(log.scans[k].breaks, k == 30) << k;
}

TEST(AlignedLog, ShiftsTheStampsOfScansOnly) {
  const RecordedPlace place = recorded_office(60);
  const AlignedLog late = align_log(place, AlignBy::kTruth, at_borders(milliseconds(50)));
  ASSERT_EQ(late.scans.size(), 60U);
  EXPECT_EQ(late.scans[0].scan.stamp, milliseconds(50));
  EXPECT_TRUE(late.T_odom_base.at(Stamp{}));
  const AlignedLog early = align_log(place, AlignBy::kTruth, at_borders(milliseconds(-50)));
  EXPECT_EQ(early.left_out, 1U);  // the first is now before odometry
  ASSERT_EQ(early.scans.size(), 59U);
  EXPECT_EQ(early.scans[0].scan.stamp, milliseconds(150));
}

TEST(AlignedLog, CorrectsThePathByTheErrorsOfOdometry) {
  const RecordedPlace place = recorded_office(60);
  const OdometryErrors errors{0.1, -0.2, 0.05};
  ScanCorrection correction;
  correction.drive.odometry = errors;
  const AlignedLog log = align_log(place, AlignBy::kTruth, correction);
  const auto motion = [](const localization::TransformBuffer& buffer, int scan) {
    const Stamp stamp = scan * milliseconds(200);
    return buffer.at(stamp)->inverse() * *buffer.at(stamp + milliseconds(200));
  };
  for (const int scan : {0, 30, 58}) {
    const SE2 measured = motion(log.T_odom_base, scan);
    const SE2 corrected = motion(log.T_path_base, scan);
    EXPECT_NEAR(measured.x, 0.1, 1e-3);
    EXPECT_NEAR(measured.yaw, 0.1 / 1.5, 1e-9);
    EXPECT_NEAR(corrected.x, 0.11, 1e-3);
    EXPECT_NEAR(corrected.yaw, 0.8 * 0.1 / 1.5 + 0.05 * 0.1, 1e-5);
  }
  const AlignedLog plain = align_log(place, AlignBy::kTruth);
  EXPECT_LT(localization::distance(motion(plain.T_path_base, 7), motion(plain.T_odom_base, 7)),
            1e-12);
}

TEST(AlignedLog, CorrectsThePathByThePoseOfTheDrive) {
  const RecordedPlace place = recorded_office(60);
  ScanCorrection correction;
  correction.drive.T_base_drive = {-0.4, 0.1, 0.3};
  const AlignedLog log = align_log(place, AlignBy::kTruth, correction);
  const SE2 T_base_drive = correction.drive.T_base_drive;
  for (const int scan : {0, 30, 58}) {
    const Stamp stamp = scan * milliseconds(200);
    const auto motion = [&](const localization::TransformBuffer& buffer) {
      return buffer.at(stamp)->inverse() * *buffer.at(stamp + milliseconds(200));
    };
    const SE2 expected = T_base_drive * motion(log.T_odom_base) * T_base_drive.inverse();
    EXPECT_LT(localization::distance(motion(log.T_path_base), expected), 1e-9);
    EXPECT_LT(localization::yaw_distance(motion(log.T_path_base), expected), 1e-9);
  }
}

/// Reference poses of the office's log that are off by `off`, seen from the robot.
RecordedPlace misplaced_office(int scans, const SE2& off) {
  RecordedPlace place = recorded_office(scans);
  for (ScanFrame* scan : scans_in(place.frames)) {
    scan->true_pose = scan->true_pose->T_map_base * off;
  }
  return place;
}

TEST(AlignedLog, MovesBackByItsMeanTranslation) {
  AlignedLog log;
  log.T_start_base = {0.03, -0.02, 0.01};
  log.scans.push_back({{}, {1.0, 2.0, 0.5 * std::numbers::pi}});
  move_back(log);
  EXPECT_NEAR(log.scans[0].T_map_base.x, 0.98, 1e-12);
  EXPECT_NEAR(log.scans[0].T_map_base.y, 1.97, 1e-12);
  EXPECT_EQ(log.T_start_base.x, 0.0);
  EXPECT_EQ(log.T_start_base.yaw, 0.01);
}

TEST(AlignedLog, KnowsHowFarItMovedTheReferencePoses) {
  for (const SE2& off : {SE2{0.03, -0.02, 0.01}, SE2{-0.02, 0.03, -0.015}, SE2{}}) {
    const AlignedLog log = align_log(misplaced_office(60, off), AlignBy::kTruth, at_borders());
    const SE2 back = off.inverse();
    EXPECT_NEAR(log.T_start_base.x, back.x, 0.003);
    EXPECT_NEAR(log.T_start_base.y, back.y, 0.003);
    EXPECT_NEAR(log.T_start_base.yaw, back.yaw, 0.003);
  }
}

TEST(AlignedLog, BeginsAtReferencePosesThatAreCorrected) {
  const SE2 off{0.25, -0.2, 0.12};  // farther than an alignment reaches
  const auto truth = true_poses(recorded_office(60).frames);
  const RecordedPlace place = misplaced_office(60, off);
  ScanCorrection correction = at_borders();
  correction.T_reference_base = off.inverse();
  const AlignedLog log = align_log(place, AlignBy::kTruth, correction);
  ASSERT_EQ(log.scans.size(), 60U);
  expect_aligned(log, truth, kWithin);
  EXPECT_LT(log.T_start_base.translation().norm(), 0.003);
  EXPECT_NEAR(log.T_start_base.yaw, 0.0, 0.003);
}

// Poses that are tracked backwards are aligned already.
TEST(AlignedLog, DoesNotCorrectPosesThatItTracksBackwards) {
  const SE2 off{0.25, -0.2, 0.12};
  const auto truth = true_poses(recorded_office(65).frames);
  RecordedPlace place = misplaced_office(65, off);
  const std::vector<ScanFrame*> scans = scans_in(place.frames);
  for (std::size_t k = 0; k < 20; ++k) scans[k]->true_pose.reset();
  ScanCorrection correction = at_borders();
  correction.T_reference_base = off.inverse();
  const AlignedLog log = align_log(place, AlignBy::kTruth, correction);
  ASSERT_EQ(log.scans.size(), 65U);
  expect_aligned(log, truth, kWithin);
  EXPECT_LT(log.T_start_base.translation().norm(), 0.003);
}

TEST(AlignedLog, TakesTheFirstLidarOnly) {
  RecordedPlace place = recorded_office(60);
  const auto truth = true_poses(place.frames);
  Frames both;
  for (const Frame& frame : place.frames) {
    both.push_back(frame);
    const auto* scan = std::get_if<ScanFrame>(&frame.data);
    if (scan == nullptr) continue;
    ScanFrame other = *scan;
    other.scan.lidar = "rear";
    other.scan.ranges.assign(other.scan.ranges.size(), 1.0F);
    both.push_back({frame.stamp, other});
  }
  place.frames = both;
  const AlignedLog log = align_log(place, AlignBy::kTruth, at_borders());
  ASSERT_EQ(log.scans.size(), 60U);
  EXPECT_EQ(log.scans[1].scan.lidar, "");
  expect_aligned(log, truth, kWithin);
}

TEST(AlignedLog, WithoutReferencePosesIsLocalized) {
  RecordedPlace place = recorded_office(70);
  const auto truth = true_poses(place.frames);
  for (ScanFrame* scan : scans_in(place.frames)) scan->true_pose.reset();
  const AlignedLog log = align_log(place, AlignBy::kAuto, at_borders());
  EXPECT_FALSE(log.by_truth);
  EXPECT_EQ(log.scans.size() + log.left_out, 70U);
  EXPECT_EQ(log.left_out, 0U);  // those before it found itself are tracked backwards
  expect_aligned(log, truth, kWithin);
}

TEST(AlignedLog, IsLocalizedDespiteReferencePosesIfAskedTo) {
  RecordedPlace place = recorded_office(70);
  const auto truth = true_poses(place.frames);
  for (ScanFrame* scan : scans_in(place.frames)) scan->true_pose = SE2{3.0, 3.0, 3.0};
  const AlignedLog log = align_log(place, AlignBy::kMhAmcl, at_borders(milliseconds(20)));
  EXPECT_FALSE(log.by_truth);
  EXPECT_EQ(log.scans.size(), 70U);
  std::map<Stamp, SE2> shifted;
  for (const auto& [stamp, T_map_base] : truth) shifted[stamp + milliseconds(20)] = T_map_base;
  expect_aligned(log, shifted, kWithin);
}

TEST(AlignedLog, KnowsTheStampsOfScansThatAreLeftOut) {
  RecordedPlace place = recorded_office(60);
  blind(*scans_in(place.frames)[30]);
  Frames both;
  for (const Frame& frame : place.frames) {
    both.push_back(frame);
    if (const auto* scan = std::get_if<ScanFrame>(&frame.data)) {
      ScanFrame other = *scan;
      other.scan.lidar = "rear";
      other.scan.stamp += milliseconds(1);
      both.push_back({frame.stamp, other});
    }
  }
  place.frames = both;
  const AlignedLog log = align_log(place, AlignBy::kTruth, at_borders(milliseconds(50)));
  EXPECT_EQ(log.stamp_correction, milliseconds(50));
  EXPECT_EQ(log.left_out, 1U);
  ASSERT_EQ(log.stamps.size(), 60U);
  for (std::size_t k = 0; k < 60; ++k) EXPECT_EQ(log.stamps[k], milliseconds(200 * k + 50));
}

TEST(ParseAlign, KnowsThreeWays) {
  EXPECT_EQ(parse_align("auto"), AlignBy::kAuto);
  EXPECT_EQ(parse_align("truth"), AlignBy::kTruth);
  EXPECT_EQ(parse_align("mh_amcl"), AlignBy::kMhAmcl);
  EXPECT_EQ(error_of([] { parse_align("amcl"); }),
            "no alignment 'amcl'; there are auto, truth, mh_amcl");
  EXPECT_THROW(parse_align(""), std::invalid_argument);
}

TEST(AlignedLog, OfNoisyScansIsAsPreciseAsTheirMean) {
  RecordedPlace place = recorded_office(100);
  const auto truth = true_poses(place.frames);
  localization::Rng rng = localization::substream(1, "alignment");
  boost::random::normal_distribution<double> normal;
  for (ScanFrame* scan : scans_in(place.frames)) {
    const double dx = 0.02 * normal(rng);
    const double dy = 0.02 * normal(rng);
    scan->true_pose = scan->true_pose->T_map_base * SE2{dx, dy, 0.01 * normal(rng)};
    for (float& r : scan->scan.ranges) r += static_cast<float>(0.02 * normal(rng));
  }
  const AlignedLog log = align_log(place, AlignBy::kTruth, at_borders());
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const AlignedScan& aligned : log.scans) {
    const SE2 error = truth.at(aligned.scan.stamp).inverse() * aligned.T_map_base;
    mean += error.translation() / 100.0;
    EXPECT_LT(error.translation().norm(), 0.02);
  }
  EXPECT_LT(mean.norm(), 0.005);  // a tenth of a cell
}

}  // namespace
}  // namespace castaway::testbed
