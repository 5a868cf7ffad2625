#include "tools/ros/clouds/ring_cloud.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "localization/geometry/se2.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tests/tools/support/vlp_cloud.hpp"

namespace castaway::testbed {
namespace {

using std::chrono::milliseconds;

/// A range that tells the direction.
double telling(double azimuth, double elevation) { return 10.0 + azimuth + elevation; }

TEST(RingCloud, OfASpinningLidarHasLayersOfBeams) {
  VlpCloud how;
  how.range = telling;
  const LaserScan scan = scan_of_cloud(vlp_cloud(how), milliseconds(5000));
  ASSERT_EQ(scan.layers.size(), 16U);
  EXPECT_EQ(scan.ranges.size(), 1800U);
  for (int ring = 0; ring < 16; ++ring) {
    const auto& layer = scan.layers[static_cast<std::size_t>(ring)];
    EXPECT_NEAR(layer.elevation, vlp_elevation(ring), 1e-5);
    for (std::size_t beam = 0; beam < layer.ranges.size(); ++beam) {
      const double azimuth = localization::wrap_angle(scan.beam_angle(beam));
      if (std::abs(azimuth) > 3.13) continue;  // The range jumps there.
      EXPECT_NEAR(layer.ranges[beam], telling(azimuth, layer.elevation), 0.002);
    }
  }
}

TEST(RingCloud, KnowsWhenEachBeamWasTaken) {
  const LaserScan scan = scan_of_cloud(vlp_cloud({}), milliseconds(5000));
  EXPECT_LT(scan.angle_increment, 0.0);  // It turns clockwise.
  EXPECT_NEAR(localization::seconds(scan.time_increment), 0.1 / 1800, 1e-8);
  // The first point of the cloud is the third beam.
  EXPECT_NEAR(scan.beam_angle(2), 2.0, 1e-5);
  EXPECT_NEAR(localization::seconds(scan.beam_stamp(2)), 5.0, 1e-6);
  EXPECT_NEAR(localization::seconds(scan.beam_stamp(1001)), 5.0 + 0.1 * 999 / 1800, 1e-5);
}

TEST(RingCloud, OfAnotherClockBeginsAtItsStamp) {
  VlpCloud how;
  how.first_time = 1000.0;
  const LaserScan scan = scan_of_cloud(vlp_cloud(how), milliseconds(5000));
  EXPECT_NEAR(localization::seconds(scan.beam_stamp(2)), 5.0, 1e-3);
  EXPECT_NEAR(localization::seconds(scan.time_increment), 0.1 / 1800, 1e-6);
  how.first_time = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(scan_of_cloud(vlp_cloud(how), {}).ranges.empty());
}

TEST(RingCloud, WithoutTimesIsTakenAtOnce) {
  VlpCloud how;
  how.times = false;
  const LaserScan scan = scan_of_cloud(vlp_cloud(how), milliseconds(5000));
  EXPECT_EQ(scan.stamp, milliseconds(5000));
  EXPECT_EQ(scan.time_increment, Stamp(0));
  EXPECT_EQ(scan.layers.size(), 16U);
}

TEST(RingCloud, OfASectorLeavesTheRestWithoutReturns) {
  VlpCloud how;
  how.range = [](double azimuth, double) { return std::abs(azimuth) < 1.0 ? 5.0 : 0.0; };
  const LaserScan scan = scan_of_cloud(vlp_cloud(how), {});
  const auto returns =
      std::ranges::count_if(scan.layers[3].ranges, [](float r) { return std::isfinite(r); });
  EXPECT_NEAR(static_cast<double>(returns) / static_cast<double>(scan.ranges.size()),
              1.0 / std::numbers::pi, 0.01);
}

TEST(RingCloud, ItsPlanarCutIsTheMostLevelRing) {
  const LaserScan scan = scan_of_cloud(vlp_cloud({}), {});
  EXPECT_NEAR(scan.ranges[100], 5.0 * std::cos(vlp_elevation(7)), 1e-5);
}

TEST(RingCloud, WithoutReturnsHasNoBeams) {
  VlpCloud how;
  how.range = [](double, double) { return 0.0; };
  EXPECT_TRUE(scan_of_cloud(vlp_cloud(how), {}).ranges.empty());
}

TEST(RingCloud, NeedsRings) {
  ros::PointCloud2 cloud = vlp_cloud({});
  cloud.fields[4].name = "label";
  EXPECT_TRUE(contains(error_of([&] { (void)scan_of_cloud(cloud, {}); }),
                       "no field 'ring'; its fields are: x, y, z, intensity, label, time"));
}

}  // namespace
}  // namespace castaway::testbed
