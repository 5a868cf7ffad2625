#include "localization/sensor/scan_points.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

using std::numbers::pi;

/// Two beams, forward and to the left, of 2 m and 3 m.
LaserScan two_beams() {
  LaserScan scan;
  scan.stamp = Stamp(0);
  scan.angle_increment = pi / 2;
  scan.range_min = 0.1;
  scan.range_max = 10.0;
  scan.ranges = {2.0F, 3.0F};
  return scan;
}

TransformBuffer still() {
  TransformBuffer buffer;
  buffer.add(Stamp(0), {5.0, 6.0, 1.0});
  return buffer;
}

void expect_point(const ScanPoints& points, std::size_t i, double x, double y) {
  EXPECT_NEAR(points.x.at(i), x, 1e-6);
  EXPECT_NEAR(points.y.at(i), y, 1e-6);
}

TEST(ProjectScan, PutsBeamsIntoBase) {
  const auto points = project_scan(two_beams(), still(), Stamp(0), {});
  ASSERT_TRUE(points);
  ASSERT_EQ(points->size(), 2U);
  expect_point(*points, 0, 2.0, 0.0);
  expect_point(*points, 1, 0.0, 3.0);
  EXPECT_FLOAT_EQ(points->range[1], 3.0F);
}

TEST(ProjectScan, HonoursAnOffCentreYawedMount) {
  LaserScan scan = two_beams();
  scan.T_base_laser.translation() = Eigen::Vector3d(0.2, -0.1, 0.5);
  scan.T_base_laser.linear() =
      Eigen::AngleAxisd(pi / 2, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const auto points = project_scan(scan, still(), Stamp(0), {});
  expect_point(*points, 0, 0.2, 1.9);
  expect_point(*points, 1, -2.8, -0.1);
  EXPECT_FLOAT_EQ(points->origin_x[0], 0.2F);
  EXPECT_FLOAT_EQ(points->origin_y[0], -0.1F);
}

TEST(ProjectScan, HonoursAnUpsideDownMount) {
  LaserScan scan = two_beams();
  scan.T_base_laser.linear() = Eigen::AngleAxisd(pi, Eigen::Vector3d::UnitX()).toRotationMatrix();
  const auto points = project_scan(scan, still(), Stamp(0), {});
  expect_point(*points, 0, 2.0, 0.0);
  expect_point(*points, 1, 0.0, -3.0);
}

TEST(ProjectScan, ShortensTheBeamsOfATiltedLidarInThePlane) {
  LaserScan scan = two_beams();
  scan.T_base_laser.linear() =
      Eigen::AngleAxisd(pi / 3, Eigen::Vector3d::UnitY()).toRotationMatrix();
  const auto points = project_scan(scan, still(), Stamp(0), {});
  expect_point(*points, 0, 1.0, 0.0);
  EXPECT_FLOAT_EQ(points->range[0], 1.0F);
}

TEST(ProjectScan, LeavesOutWhatIsNoReturn) {
  LaserScan scan = two_beams();
  constexpr float kInf = std::numeric_limits<float>::infinity();
  scan.ranges = {kInf, -kInf, std::nanf(""), 0.05F, 10.5F, 4.0F};
  scan.angle_increment = 0.1;
  const auto points = project_scan(scan, still(), Stamp(0), {});
  ASSERT_EQ(points->size(), 1U);
  expect_point(*points, 0, 4.0 * std::cos(0.5), 4.0 * std::sin(0.5));
  EXPECT_DOUBLE_EQ(points->valid_share, 1.0 / 6.0);
}

TEST(ProjectScan, SpreadsASelectionEvenly) {
  LaserScan scan = two_beams();
  scan.angle_increment = 0.01;
  scan.ranges.assign(100, 1.0F);
  const auto points = project_scan(scan, still(), Stamp(0), {.max_beams = 10});
  ASSERT_EQ(points->size(), 10U);
  for (std::size_t k = 0; k < 10; ++k) EXPECT_NEAR(points->y[k], std::sin(0.1 * double(k)), 1e-6);
}

TEST(ProjectScan, UndoesTheMotionDuringTheSweep) {
  // Base moves 1 m forward and rotates by 90 deg between the two beams; both hit the point (2, 3)
  // in odom.
  TransformBuffer buffer;
  buffer.add(Stamp(0), {0.0, 3.0, 0.0});
  buffer.add(Stamp(100), {1.0, 3.0, pi / 2});
  LaserScan scan = two_beams();
  scan.time_increment = Stamp(100);
  scan.angle_increment = -pi / 2;
  scan.ranges = {2.0F, 1.0F};
  const auto points = project_scan(scan, buffer, Stamp(100), {});
  ASSERT_TRUE(points);
  expect_point(*points, 0, 0.0, -1.0);
  expect_point(*points, 1, 0.0, -1.0);
  EXPECT_NEAR(points->origin_y[0], 1.0,
              1e-6);  // pose of base at the first beam, relative to the last pose
}

TEST(ProjectScan, GivesNothingWithoutOdometry) {
  LaserScan scan = two_beams();
  EXPECT_FALSE(project_scan(scan, TransformBuffer(), Stamp(0), {}));
  scan.stamp = Stamp(-1);
  EXPECT_FALSE(project_scan(scan, still(), Stamp(0), {}));
}

TEST(EvenIndices, SpreadOverAllItems) {
  using Indices = std::vector<std::size_t>;
  EXPECT_EQ(even_indices(10, 4), (Indices{0, 2, 5, 7}));
  EXPECT_EQ(even_indices(3, 4), (Indices{0, 1, 2}));
  EXPECT_EQ(even_indices(0, 4), Indices{});
}

TEST(Thinned, TakesPointsEvenOverTheScan) {
  ScanPoints points;
  for (int i = 0; i < 10; ++i) {
    const auto v = static_cast<float>(i);
    points.x.push_back(v);
    points.y.push_back(-v);
    points.z.push_back(0.1F);
    points.origin_x.push_back(0.0F);
    points.origin_y.push_back(0.0F);
    points.origin_z.push_back(0.3F);
    points.range.push_back(v);
  }
  EXPECT_EQ(thin(points, 4).x, (std::vector<float>{0.0F, 2.0F, 5.0F, 7.0F}));
  EXPECT_EQ(thin(points, 4).y, (std::vector<float>{0.0F, -2.0F, -5.0F, -7.0F}));
  EXPECT_EQ(thin(points, 10).x, points.x);
}

TEST(Farthest, KeepsTheFarShareInItsOrder) {
  ScanPoints points;
  for (const float r : {4.0F, 1.0F, 3.0F, 2.0F, 5.0F}) {
    points.x.push_back(r);
    points.y.push_back(-r);
    points.z.push_back(0.1F);
    points.origin_x.push_back(0.1F);
    points.origin_y.push_back(0.2F);
    points.origin_z.push_back(0.3F);
    points.range.push_back(r);
  }
  const ScanPoints far = farthest_points(points, 0.5);
  EXPECT_EQ(far.range, (std::vector<float>{4.0F, 3.0F, 5.0F}));
  EXPECT_EQ(far.x, far.range);
  EXPECT_EQ(far.y, (std::vector<float>{-4.0F, -3.0F, -5.0F}));
  EXPECT_EQ(far.origin_x, std::vector<float>(3, 0.1F));
  EXPECT_EQ(farthest_points(points, 1.0).range, points.range);
  EXPECT_EQ(farthest_points(points, 0.0).range, std::vector<float>{5.0F});
  EXPECT_TRUE(farthest_points({}, 0.5).empty());
}

}  // namespace
}  // namespace castaway::localization
