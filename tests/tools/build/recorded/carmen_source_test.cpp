#include "tools/build/recorded/carmen_source.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

std::string odom(double x, double t) {
  return "ODOM " + std::to_string(x) + " 0 0 0 0 0 0 h " + std::to_string(t) + "\n";
}

/// A scan of `beams` beams of 5 m, with robot and lidar at (x, 0, 0).
std::string flaser(double x, double t, int beams = 4) {
  std::string line = "FLASER " + std::to_string(beams);
  for (int i = 0; i < beams; ++i) line += " 5";
  const std::string pose = " " + std::to_string(x) + " 0 0";
  return line + pose + pose + " 0 h " + std::to_string(t) + "\n";
}

std::string truepos(double x) { return "TRUEPOS " + std::to_string(x) + " 2 0.5 0 0 0 0 h 0\n"; }

/// Plays a log and lists its frames as "o1.5 s1.5 ...": kind and stamp, with '*' if the truth is
/// known.
std::string played(const std::string& log, const CarmenSourceConfig& config = {}) {
  const TemporaryFolder folder;
  CarmenSource source(folder.put("a.log", log), config);
  std::string text;
  while (const auto frame = source.next()) {
    const auto* scan = std::get_if<ScanFrame>(&frame->data);
    const auto* odometry = std::get_if<OdometryFrame>(&frame->data);
    const bool known =
        scan != nullptr ? scan->true_pose.has_value() : odometry->true_pose.has_value();
    text += (scan != nullptr ? "s" : "o") +
            std::to_string(std::lround(10.0 * localization::seconds(frame->stamp))) +
            (known ? "* " : " ");
  }
  return text;
}

LaserScan first_scan(const std::string& log) {
  const TemporaryFolder folder;
  CarmenSource source(folder.put("a.log", log));
  while (const auto frame = source.next()) {
    if (const auto* scan = std::get_if<ScanFrame>(&frame->data)) return scan->scan;
  }
  return {};
}

const std::string kLog = odom(0.0, 100.0) + flaser(0.1, 100.1) + truepos(1.0) + odom(0.2, 100.2) +
                         flaser(0.3, 100.3) + odom(0.4, 100.4) + flaser(0.5, 100.5) + truepos(2.0) +
                         odom(0.6, 100.6);

TEST(CarmenSource, PlaysFromTheFirstScanOn) {
  EXPECT_EQ(played(kLog), "o1* s1* o2 o3 s3 o4 o5* s5* o6 ");
}

TEST(CarmenSource, PlaysAPart) {
  EXPECT_EQ(played(kLog, {.from_scan = 1}), "o3 s3 o4 o5* s5* o6 ");
  EXPECT_EQ(played(kLog, {.scans = 1}), "o1* s1* ");
  EXPECT_EQ(played(kLog, {.scans = 2}), "o1* s1* o2 o3 s3 ");
}

TEST(CarmenSource, OfScansNotSelectedPlaysTheOdometry) {
  using Scans = CarmenSourceConfig::Scans;
  EXPECT_EQ(played(kLog, {.selection = Scans::kEven}), "o1* s1* o2 o3 o4 o5* s5* o6 ");
  EXPECT_EQ(played(kLog, {.selection = Scans::kOdd}), "o3 s3 o4 o5* o6 ");
}

TEST(CarmenSource, EndsWithItsLastScanInALogOfScansAlone) {
  const std::string log = flaser(0.0, 1.0) + flaser(0.1, 1.1) + flaser(0.2, 1.2) + flaser(0.3, 1.3);
  EXPECT_EQ(played(log, {.scans = 2}), "o0 s0 o1 s1 ");
}

TEST(CarmenSource, NeedsAScan) {
  EXPECT_TRUE(contains(error_of([] { played(odom(0.0, 1.0)); }), "a.log: no FLASER"));
  EXPECT_TRUE(contains(error_of([] { played(kLog, {.from_scan = 3}); }), "from scan 3"));
}

TEST(CarmenSource, KnowsItsStartItsLengthAndItsRepairs) {
  const TemporaryFolder folder;
  const std::string late = odom(0.7, 100.2);  // runs backwards by 0.4 s
  CarmenSource source(folder.put("a.log", kLog + late));
  EXPECT_EQ(source.start_pose(), (SE2{1.0, 2.0, 0.5}));
  EXPECT_NEAR(localization::seconds(source.duration()), 0.5, 1e-9);
  EXPECT_EQ(source.repaired_stamps(), 1);
  EXPECT_EQ(played(odom(0.0, 100.0) + flaser(0.0, 100.2) + late + odom(0.8, 100.1)),
            "o2 s2 o2 o2 ");
}

TEST(CarmenFrames, AnglesOfAFlaserAreThoseItsCountOfBeamsFits) {
  const auto expect_angles = [](const std::string& params, int beams, double min, double step) {
    const LaserScan scan = first_scan(params + flaser(0.0, 1.0, beams));
    EXPECT_NEAR(scan.angle_min, min * kDegree, 1e-12) << params << beams;
    EXPECT_NEAR(scan.angle_increment, step * kDegree, 1e-12) << params << beams;
  };
  const std::string half = "PARAM laser_front_laser_resolution 0.5 h 0\n";
  const std::string one = "PARAM laser_front_laser_resolution 1.0 h 0\n";
  const std::string wide = "PARAM laser_front_laser_fov 270 h 0\n";
  expect_angles("", 181, -90.0, 1.0);
  expect_angles("", 180, -90.0, 180.0 / 179.0);
  expect_angles(one, 180, -90.0, 1.0);
  expect_angles(one, 361, -90.0, 0.5);
  expect_angles(half, 361, -90.0, 0.5);
  expect_angles(wide + half, 541, -135.0, 0.5);
}

TEST(CarmenFrames, RangesBecomeRep117) {
  const LaserScan scan =
      first_scan("PARAM robot_front_laser_max 20 h 0\nFLASER 4 19.9 20 0 81 0 0 0 0 0 0 1 h 1\n");
  EXPECT_EQ(scan.range_max, 20.0);
  EXPECT_EQ(scan.ranges[0], 19.9F);
  EXPECT_TRUE(std::isinf(scan.ranges[1]) && scan.ranges[1] > 0.0F);
  EXPECT_TRUE(std::isnan(scan.ranges[2]));
  EXPECT_TRUE(std::isinf(scan.ranges[3]));
  EXPECT_EQ(first_scan(flaser(0.0, 1.0)).range_max, 80.0);
}

TEST(CarmenFrames, ADeviceKnowsItsOwnAngles) {
  const std::string line = "ROBOTLASER1 0 -2.0 4.0 0.5 30.0 0.01 0 2 1.0 30.0 0 1 2 0 ";
  const LaserScan scan = first_scan(line + "1 2 0 0 0 0 0 0 9.5 h 1.5\n");
  EXPECT_EQ(scan.angle_min, -2.0);
  EXPECT_EQ(scan.angle_increment, 0.5);
  EXPECT_EQ(scan.range_max, 30.0);
  EXPECT_TRUE(std::isinf(scan.ranges[1]));
}

TEST(CarmenFrames, MountIsThatOfTheLineOrElseTheParam) {
  const std::string param = "PARAM robot_frontlaser_offset 0.25 h 0\n";
  const std::string turned = "FLASER 1 5 1.0 2.3 1.67 1.0 2.0 1.57079632679489662 0 h 1\n";
  const Eigen::Isometry3d of_line = first_scan(param + turned).T_base_laser;
  EXPECT_NEAR(of_line.translation().x(), 0.3, 1e-9);
  EXPECT_NEAR(of_line.translation().y(), 0.0, 1e-9);
  EXPECT_NEAR(of_line.rotation()(1, 0), std::sin(1.67 - 0.5 * std::numbers::pi), 1e-9);
  EXPECT_EQ(first_scan(param + flaser(0.4, 1.0)).T_base_laser.translation(),
            Eigen::Vector3d(0.25, 0.0, 0.0));
}

}  // namespace
}  // namespace castaway::testbed
