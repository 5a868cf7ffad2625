#include "tools/build/scan_truth.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

constexpr double kPi = std::numbers::pi;

/// A lidar with two layers of two beams, forward and to the left.
sim::LidarConfig two_layers() {
  sim::LidarConfig lidar;
  lidar.name = "top";
  lidar.frame = "top_link";
  lidar.beams = 2;
  lidar.angle_min = 0.0;
  lidar.angle_increment = kPi / 2;
  lidar.elevations = {-kPi / 6, kPi / 3};
  lidar.T_base_laser = Eigen::Translation3d(0.0, 0.0, 1.0);
  return lidar;
}

sim::LidarReading reading() {
  sim::LidarReading result;
  result.layers = 2;
  result.ranges = {2.0F, std::numeric_limits<float>::infinity(), 4.0F, 1.0F};
  result.hit_object = {7, -1, 8, 9};
  result.intensities = {0.1F, 0.0F, 0.2F, 0.3F};
  return result;
}

TEST(PlanarScan, IsTheMostLevelLayerLaidDown) {
  const LaserScan scan = laser_scan(reading(), two_layers());
  ASSERT_EQ(scan.ranges.size(), 2U);
  EXPECT_FLOAT_EQ(scan.ranges[0], static_cast<float>(2.0 * std::cos(kPi / 6)));
  EXPECT_EQ(scan.ranges[1], std::numeric_limits<float>::infinity());
  EXPECT_EQ(scan.lidar, "top");
}

TEST(PlanarScan, ComesWithAllLayersAsMeasured) {
  const LaserScan scan = laser_scan(reading(), two_layers());
  ASSERT_EQ(scan.layers.size(), 2U);
  EXPECT_EQ(scan.layers[0].elevation, two_layers().elevations[0]);
  const std::vector<float> lower{2.0F, std::numeric_limits<float>::infinity()};
  EXPECT_EQ(scan.layers[0].ranges, lower);
  EXPECT_EQ(scan.layers[1].ranges, (std::vector<float>{4.0F, 1.0F}));
  sim::LidarConfig planar = two_layers();
  planar.elevations = {0.0};
  EXPECT_TRUE(laser_scan(reading(), planar).layers.empty());
}

TEST(PlanarScan, OrTheLayerThatIsChosen) {
  sim::LidarConfig lidar = two_layers();
  lidar.planar_layer = 1;
  EXPECT_FLOAT_EQ(laser_scan(reading(), lidar).ranges[0], 2.0F);
}

TEST(PlanarScan, TellsTheMountThatIsBelieved) {
  sim::LidarReading wrong = reading();
  wrong.mount_error = sim::Pose2{0.5, 0.0, kPi / 2};
  const LaserScan scan = laser_scan(wrong, two_layers());
  EXPECT_NEAR(scan.T_base_laser.translation().x(), 0.5, 1e-12);
  EXPECT_NEAR(scan.T_base_laser.translation().z(), 1.0, 1e-12);
  EXPECT_NEAR(scan.T_base_laser.linear()(1, 0), 1.0, 1e-12);
}

TEST(ScanTruth, BelongsToThatLayer) {
  const ScanTruth truth = scan_truth(reading(), two_layers(), false);
  EXPECT_EQ(truth.frame, "top_link");
  EXPECT_EQ(truth.labels, (std::vector<int>{7, -1}));
  EXPECT_EQ(truth.intensities, (std::vector<float>{0.1F, 0.0F}));
  EXPECT_TRUE(truth.cloud.empty());
}

TEST(HitLegendOfAWorld, TellsWhatIsWhereTheMapHasIt) {
  sim::WorldSpec world;
  const auto add = [&world](const char* name, bool in_map, bool movable, bool glass) {
    sim::WorldObject object;
    object.name = name;
    object.in_map = in_map;
    object.movable = movable;
    object.surface.glass = glass;
    world.objects.push_back(object);
  };
  add("wall", true, false, false);
  add("box", false, false, false);
  add("chair", false, true, false);
  add("door/leaf", false, false, false);
  add("pane", true, false, true);
  world.doors.push_back({});
  world.doors.back().name = "door";
  const HitLegend legend = hit_legend(world);
  EXPECT_EQ(legend.class_of(0), BeamClass::kStatic);
  EXPECT_EQ(legend.class_of(1), BeamClass::kUnmapped);
  EXPECT_EQ(legend.class_of(2), BeamClass::kMoved);
  EXPECT_EQ(legend.class_of(3), BeamClass::kDoor);
  EXPECT_EQ(legend.class_of(4), BeamClass::kGlass);
  EXPECT_EQ(legend.class_of(sim::kHitPerson + 2), BeamClass::kPerson);
  EXPECT_EQ(legend.id_of(sim::kHitPerson + 2), 2);
  EXPECT_EQ(legend.class_of(sim::kHitNothing), BeamClass::kNone);
  EXPECT_EQ(legend.class_of(sim::kHitFloor), BeamClass::kFloor);
  EXPECT_EQ(legend.class_of(sim::kHitDust), BeamClass::kDust);
  EXPECT_EQ(legend.class_of(sim::kHitCover), BeamClass::kCover);
}

TEST(ScanTruth, ACloudHoldsTheReturnsOfAllLayersInBase) {
  const auto cloud = scan_truth(reading(), two_layers(), true).cloud;
  ASSERT_EQ(cloud.size(), 3U);
  EXPECT_NEAR(cloud[0].p_base.z(), 1.0 - 2.0 * 0.5, 1e-6);
  EXPECT_NEAR(cloud[0].p_base.x(), 2.0 * std::cos(kPi / 6), 1e-6);
  EXPECT_NEAR(cloud[2].p_base.y(), 0.5, 1e-6);
  EXPECT_EQ(cloud[2].label, 9);
  EXPECT_FLOAT_EQ(cloud[2].intensity, 0.3F);
}

}  // namespace
}  // namespace castaway::testbed
