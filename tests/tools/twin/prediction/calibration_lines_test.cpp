#include "tools/twin/prediction/calibration_lines.hpp"

#include <gtest/gtest.h>

#include "tests/tools/twin/prediction/told_twin.hpp"

namespace castaway::testbed {
namespace {

/// A line as text.
std::string text_of(const CalibrationLine& line) {
  const std::string value = line.value.substr(0, line.value.find_last_not_of(' ') + 1);
  return line.name + ": " + value + (line.interval.empty() ? "" : ", " + line.interval);
}

using Texts = std::vector<std::string>;

Texts texts_of(const CalibrationGroup& group) {
  Texts texts;
  for (const CalibrationLine& line : group.lines) texts.push_back(text_of(line));
  return texts;
}

TEST(CalibrationLines, OfOdometryAreInPercentAndDegrees) {
  const auto groups = calibration_groups(told_twin());
  ASSERT_EQ(groups.size(), 3U);
  EXPECT_EQ(groups[0].heading, "Odometry, over 124 m");
  EXPECT_EQ(texts_of(groups[0]),
            (Texts{"distance, true over measured: 2 % more, 1.9 to 2.1",
                   "turn, true over measured: -3 % more, -3.1 to -2.9",
                   "curvature: 0.5 deg/m, 0.4427 to 0.5573",
                   "random walk along: 0.04 m/sqrt(m), 0.039 to 0.041",
                   "walk of the yaw by travel: 1.25 deg/sqrt(m), 1.249 to 1.251",
                   "walk of the yaw by turn: 0.75 deg/sqrt(rad), 0.749 to 0.751",
                   "slips of each wheel: 0.02 /m, 0.019 to 0.021",
                   "drive ahead of stated base: 115 mm, 114 to 116",
                   "drive left of stated base: -42 mm, -43 to -41",
                   "drive turned against base: -1.5 deg, -1.75 to -1.25",
                   "reversing: counted as driving ahead"}));
}

TEST(CalibrationLines, SayThatReversingIsCounted) {
  Twin twin = told_twin();
  twin.fitted.fit.odometry->unsigned_distance = false;
  EXPECT_EQ(text_of(calibration_groups(twin)[0].lines.back()), "reversing: counted");
}

TEST(CalibrationLines, OfTheLidarAreInMillimetresMillisecondsAndPercent) {
  const auto groups = calibration_groups(told_twin());
  EXPECT_EQ(groups[1].heading, "Lidar, 10.00 scans a second");
  EXPECT_EQ(
      texts_of(groups[1]),
      (Texts{"clock ahead of odometry: -34 ms, -35 to -33", "error of the stamps: 16 ms, 15 to 17",
             "jitter of the periods: 2.5 ms", "noise at range 0: 12 mm, 11 to 13",
             "noise per metre: 4 mm/m, 3 to 5", "range behind the map's walls: -21 mm, -22 to -20",
             "resolution: 10 mm", "lost on walls: 1.5 % of beams, 1.4 to 1.6",
             "opening of a beam: 0.4 deg, 0.399 to 0.401", "mixed steps, up to: 0.75 m",
             "dust: 0.004 /m, 0.003 to 0.005", "offsets of beams: 6 mm, 5 to 7",
             "nothing is seen beyond: 17.5 m, 17 to 18"}));
}

TEST(CalibrationLines, OfTheBuildingCountObjectsAndPeople) {
  const auto groups = calibration_groups(told_twin());
  EXPECT_EQ(groups[2].heading, "Building against map, 43 m^2");
  EXPECT_EQ(texts_of(groups[2]),
            (Texts{"beams on what moves: 3 %, 2.9 to 3.1", "beams on new objects: 2 %, 1.9 to 2.1",
                   "beams through walls: 1 %, 0.9 to 1.1", "objects: 2 new; parts of walls gone: 1",
                   "people: 4 walking, 3 to 5"}));
}

TEST(CalibrationLines, SayWhatCouldNotBeFitted) {
  Twin twin;
  twin.fitted = standing_twin();
  const auto groups = calibration_groups(twin);
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(texts_of(groups[0]), (Texts{"errors: not fitted: the robot drove less than 100 m"}));
  EXPECT_EQ(
      texts_of(groups[1]),
      (Texts{"clock: not fitted: odometry comes too seldom or turns too evenly",
             "jitter of the periods: 0 ms", "noise: not fitted: too few beams on straight walls",
             "losses: not fitted: too few beams on straight walls",
             "mixed pixels: not fitted: too few depth steps",
             "dust: not fitted: too few beams on straight walls",
             "offsets of beams: not fitted: too few straight surfaces"}));
}

TEST(AlignmentSentence, SaysHowTheScansWereAligned) {
  AlignedLog log = standing_twin().log;
  log.left_out = 7;
  log.on_walls = 0.876;
  EXPECT_EQ(alignment_sentence(log),
            "101 scans aligned by mh_amcl, 7 left out; 88 % of the end points on walls");
  log.by_truth = true;
  EXPECT_EQ(alignment_sentence(log),
            "101 scans aligned by reference poses, 7 left out; 88 % of the end points on walls");
}

}  // namespace
}  // namespace castaway::testbed
