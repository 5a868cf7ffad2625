#include "tools/ros/clouds/flat_cloud.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "tools/ros/clouds/cloud_field.hpp"
#include "tools/ros/ros_conversion.hpp"

namespace castaway::testbed {
namespace {

constexpr float kNoReturn = std::numeric_limits<float>::infinity();

std::vector<double> column(const ros::PointCloud2& cloud, const std::string& name) {
  const CloudField field = require_field(cloud, name);
  std::vector<double> values;
  for (std::size_t i = 0; i < cloud.width; ++i) values.push_back(field.at(i));
  return values;
}

TEST(FlatCloud, HasTheReturnsOfAScanInTheLidarsFrame) {
  LaserScan scan;
  scan.stamp = std::chrono::milliseconds(1500);
  scan.angle_min = -std::numbers::pi / 2.0;
  scan.angle_increment = std::numbers::pi / 2.0;
  scan.ranges = {1.0F, kNoReturn, 2.5F, std::nanf(""), -kNoReturn};
  const ros::PointCloud2 cloud = returns_cloud(scan, {7.0F, 8.0F, 9.0F}, "laser");
  EXPECT_NO_THROW(validate(cloud));
  EXPECT_EQ(cloud.header.frame_id, "laser");
  EXPECT_EQ(cloud.header.stamp.sec, 2);  // Time 0 of a run is 1 s.
  EXPECT_EQ(cloud.header.stamp.nanosec, 500'000'000U);
  ASSERT_EQ(cloud.width, 2U);
  EXPECT_NEAR(column(cloud, "x")[0], 0.0, 1e-7);
  EXPECT_NEAR(column(cloud, "y")[0], -1.0, 1e-7);
  EXPECT_NEAR(column(cloud, "x")[1], 0.0, 1e-6);
  EXPECT_NEAR(column(cloud, "y")[1], 2.5, 1e-6);
  EXPECT_EQ(column(cloud, "z"), (std::vector<double>{0.0, 0.0}));
  EXPECT_EQ(column(cloud, "intensity"), (std::vector<double>{7.0, 9.0}));
  EXPECT_EQ(column(returns_cloud(scan, {}, "laser"), "intensity"), (std::vector<double>{0.0, 0.0}));
}

/// Viewers, Rerun's among them, take x, y and z of 32 bits each.
TEST(FlatCloud, HasFloatsInTheUsualOrderWithoutGaps) {
  const ros::PointCloud2 cloud = particles_cloud(ros_header({}, "map"), {});
  EXPECT_NO_THROW(validate(cloud));
  EXPECT_EQ(cloud.width, 0U);
  EXPECT_EQ(cloud.point_step, 16U);
  EXPECT_TRUE(cloud.is_dense);
  EXPECT_FALSE(cloud.is_bigendian);
  ASSERT_EQ(cloud.fields.size(), 4U);
  for (std::uint32_t i = 0; i < 4; ++i) {
    EXPECT_EQ(cloud.fields[i].offset, 4 * i);
    EXPECT_EQ(cloud.fields[i].datatype, 7);
    EXPECT_EQ(cloud.fields[i].count, 1U);
  }
}

TEST(FlatCloud, HasTheParticlesOfAllPopulations) {
  localization::PopulationView low{1, {}, 0.5, 0.25, false, {{1.0, 2.0, 0.1}}};
  localization::PopulationView high{2, {}, 0.5, 0.75, true, {{-1.0, -2.0, 0.1}, {3.0, 4.0, 0.2}}};
  high.footing.emplace();
  high.footing->z = 3.5;
  const ros::PointCloud2 cloud = particles_cloud(ros_header({}, "map"), {low, high}, true);
  EXPECT_EQ(column(cloud, "x"), (std::vector<double>{1.0, -1.0, 3.0}));
  EXPECT_EQ(column(cloud, "y"), (std::vector<double>{2.0, -2.0, 4.0}));
  EXPECT_EQ(column(cloud, "z"), (std::vector<double>{0.0, 3.5, 3.5}));
  EXPECT_EQ(column(cloud, "intensity"), (std::vector<double>{0.25, 0.75, 0.75}));
  EXPECT_EQ(column(particles_cloud(ros_header({}, "map"), {high}), "z"),
            (std::vector<double>{0.0, 0.0}));
}

}  // namespace
}  // namespace castaway::testbed
