#include "tools/ros/clouds/layer_cloud.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/ros/clouds/cloud_field.hpp"

namespace castaway::testbed {
namespace {

constexpr float kInfinite = std::numeric_limits<float>::infinity();

LaserScan two_layers() {
  LaserScan scan;
  scan.stamp = std::chrono::milliseconds(100);
  scan.time_increment = std::chrono::milliseconds(10);
  scan.angle_increment = 0.5;
  scan.ranges = {1.0F, 2.0F, kInfinite};
  scan.lidar = "top";
  scan.layers = {{0.0, {1.0F, 2.0F, kInfinite}}, {1.0 / 3.0, {3.3F, -kInfinite, 0.1F}}};
  return scan;
}

TEST(LayerCloud, HasPointsInTheLidarsFrame) {
  const ros::PointCloud2 cloud = to_ros_cloud(two_layers(), "laser");
  EXPECT_EQ(cloud.header.frame_id, "laser");
  EXPECT_EQ(cloud.height, 2U);
  EXPECT_EQ(cloud.width, 3U);
  EXPECT_NO_THROW(validate(cloud));
  const auto at = [&](const char* name, std::size_t point) {
    return require_field(cloud, name).at(point);
  };
  EXPECT_NEAR(at("x", 1), 2.0 * std::cos(0.5), 1e-6);
  EXPECT_NEAR(at("y", 1), 2.0 * std::sin(0.5), 1e-6);
  EXPECT_NEAR(at("z", 3), 3.3 * std::sin(1.0 / 3.0), 1e-6);
  EXPECT_TRUE(std::isnan(at("x", 2)));
  EXPECT_NEAR(at("time", 5), 0.02, 1e-9);
  EXPECT_EQ(at("ring", 2), 0.0);
  EXPECT_EQ(at("ring", 3), 1.0);
}

TEST(LayerCloud, IsReadBackToTheBit) {
  const LaserScan scan = two_layers();
  EXPECT_TRUE(has_exact_layers(exact_layers(scan)));
  const auto layers = layers_of_cloud(to_ros_cloud(scan, "laser"), exact_layers(scan));
  ASSERT_EQ(layers.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(layers[i].elevation, scan.layers[i].elevation);
    EXPECT_EQ(layers[i].ranges, scan.layers[i].ranges);
  }
}

TEST(LayerCloud, MustAgreeWithItsChannelAndItsSize) {
  const LaserScan scan = two_layers();
  ros::PointCloud2 cloud = to_ros_cloud(scan, "laser");
  EXPECT_TRUE(contains(
      error_of([&] {
        (void)layers_of_cloud(cloud, {{"castaway.lidar", "a"}, {"castaway.elevations", "0.5"}});
      }),
      "2 rows, and its channel 1 elevations"));
  EXPECT_ANY_THROW((void)layers_of_cloud({}, {{"castaway.elevations", ""}}));
  cloud.data.pop_back();
  EXPECT_TRUE(contains(error_of([&] { (void)layers_of_cloud(cloud, exact_layers(scan)); }),
                       "3 x 2 points of 22 bytes in rows of 66 and holds 131 bytes"));
  cloud = to_ros_cloud(scan, "laser");
  cloud.fields[3].offset = 20;
  EXPECT_TRUE(contains(error_of([&] { validate(cloud); }), "field 'range' beyond its points"));
  cloud.fields[3].datatype = 9;
  EXPECT_TRUE(contains(error_of([&] { validate(cloud); }), "field 'range' of the unknown type 9"));
  cloud.fields.erase(cloud.fields.begin() + 3);
  EXPECT_TRUE(contains(error_of([&] { (void)require_field(cloud, "range"); }),
                       "no field 'range'; its fields are: x, y, z, time, ring"));
}

}  // namespace
}  // namespace castaway::testbed
