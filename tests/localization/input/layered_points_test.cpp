#include "localization/input/layered_points.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "localization/sensor/scan_agreement.hpp"

namespace castaway::localization {
namespace {

using std::numbers::pi;

constexpr double kMount = 0.5;    // [m] Height of the lidar.
constexpr double kRadius = 6.0;   // [m] Of a round room.
constexpr double kCeiling = 2.5;  // [m]

/// Range of a beam at an elevation in the middle of a round room with a floor and a ceiling.
double range_at(double elevation) {
  double range = kRadius / std::cos(elevation);
  if (elevation < 0.0) range = std::min(range, kMount / std::sin(-elevation));
  if (elevation > 0.0) range = std::min(range, (kCeiling - kMount) / std::sin(elevation));
  return range;
}

/// 16 layers from -15 to 15 degrees, listed from above.
LaserScan scan_in_room(std::size_t beams) {
  LaserScan scan;
  scan.angle_min = -pi;
  scan.angle_increment = 2.0 * pi / static_cast<double>(beams);
  scan.range_min = 0.3;
  scan.range_max = 50.0;
  scan.T_base_laser.translation().z() = kMount;
  for (int layer = 0; layer < 16; ++layer) {
    const double elevation = (15.0 - 2.0 * layer) * pi / 180.0;
    scan.layers.push_back(
        {elevation, std::vector<float>(beams, static_cast<float>(range_at(elevation)))});
  }
  scan.ranges = scan.layers[7].ranges;
  return scan;
}

TransformBuffer at_rest() {
  TransformBuffer buffer;
  buffer.add(Stamp(0), {1.0, 2.0, 0.3});
  return buffer;
}

int count_of(const ScanPoints& points, BeamKind kind) {
  int count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) count += points.kind(i) == kind ? 1 : 0;
  return count;
}

TEST(ProjectLayers, SortsBeamsByWhatTheyEndOn) {
  const auto points = project_layers(scan_in_room(1800), at_rest(), Stamp(0), {90, 40.0, 80, 20});
  ASSERT_TRUE(points);
  EXPECT_EQ(count_of(*points, BeamKind::kLevel), 90);
  EXPECT_EQ(count_of(*points, BeamKind::kTilted), 80);
  EXPECT_EQ(count_of(*points, BeamKind::kFlat), 20);
  for (std::size_t i = 0; i < points->size(); ++i) {
    const float radius = std::hypot(points->x[i], points->y[i]);
    if (points->kind(i) == BeamKind::kFlat) {
      const bool flat = std::abs(points->z[i]) < 1e-4F || std::abs(points->z[i] - 2.5F) < 1e-4F;
      EXPECT_TRUE(flat) << points->z[i];
    } else {
      EXPECT_NEAR(radius, 6.0F, points->z[i] < 0.001F ? 0.4F : 1e-4F);  // Or at the wall's foot.
    }
  }
}

TEST(ProjectLayers, TiltedBeamsComeFromAllLayersAndDirections) {
  const auto points = project_layers(scan_in_room(1800), at_rest(), Stamp(0), {});
  std::vector<int> by_height(40, 0);
  std::vector<int> by_direction(8, 0);
  for (std::size_t i = 0; i < points->size(); ++i) {
    if (points->kind(i) != BeamKind::kTilted) continue;
    ++by_height[static_cast<std::size_t>(points->z[i] / 0.1F)];
    const double turn = std::atan2(points->y[i], points->x[i]) / (2.0 * pi) + 0.5;
    ++by_direction[static_cast<std::size_t>(turn * 7.999)];
  }
  int heights = 0;
  for (const int count : by_height) heights += count > 0 ? 1 : 0;
  EXPECT_GE(heights, 9);
  for (const int count : by_direction) EXPECT_GE(count, 5);
}

TEST(ProjectLayers, WithoutReturnsThereAreNoPoints) {
  LaserScan scan = scan_in_room(100);
  for (ScanLayer& layer : scan.layers) {
    layer.ranges.assign(100, std::numeric_limits<float>::infinity());
  }
  const auto points = project_layers(scan, at_rest(), Stamp(0), {});
  ASSERT_TRUE(points);
  EXPECT_TRUE(points->empty());
  EXPECT_EQ(points->valid_share, 0.0);
}

TEST(ProjectLayers, NeedsTheMotionDuringTheScan) {
  LaserScan scan = scan_in_room(100);
  scan.time_increment = std::chrono::milliseconds(50);
  EXPECT_FALSE(project_layers(scan, at_rest(), Stamp(0), {}));
  scan.time_increment = Stamp(1000);
  EXPECT_TRUE(project_layers(scan, at_rest(), Stamp(0), {}));
  EXPECT_FALSE(project_layers(scan, TransformBuffer(), Stamp(0), {}));
}

TEST(ProjectLayers, ScansAreComparedByTheirLevelBeams) {
  const auto points = project_layers(scan_in_room(1800), at_rest(), Stamp(0), {});
  ScanPoints level = *points;
  for (std::size_t i = 0; i < level.size(); ++i) {
    if (level.kind(i) != BeamKind::kLevel) level.x[i] += 3.0F;
  }
  const auto agreement = scan_agreement({}, *points, level, SE2{});
  ASSERT_TRUE(agreement);
  EXPECT_EQ(*agreement, 1.0);
}

}  // namespace
}  // namespace castaway::localization
