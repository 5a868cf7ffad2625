#include "tools/build/scan_truth.hpp"

#include <algorithm>
#include <cmath>

#include "sim/casting/surfaces.hpp"

namespace castaway::testbed {
namespace {

/// Extracts the values of a layer.
template <typename T>
std::vector<T> layer_of(const std::vector<T>& values, std::size_t layer, std::size_t beams) {
  if (values.empty()) return {};
  const auto begin = values.begin() + static_cast<std::ptrdiff_t>(layer * beams);
  return {begin, begin + static_cast<std::ptrdiff_t>(beams)};
}

std::vector<CloudPoint> cloud_of(const sim::LidarReading& reading, const sim::LidarConfig& lidar) {
  std::vector<CloudPoint> cloud;
  for (std::size_t i = 0; i < reading.ranges.size(); ++i) {
    const double range = reading.ranges[i];
    if (!std::isfinite(range)) continue;
    const float intensity = reading.intensities.empty() ? 0.0F : reading.intensities[i];
    cloud.push_back(
        {sim::beam_point(lidar, i, range).cast<float>(), intensity, reading.hit_object[i]});
  }
  return cloud;
}

BeamClass class_of(const sim::WorldSpec& world, const sim::WorldObject& object) {
  if (object.surface.glass) return BeamClass::kGlass;
  if (object.in_map) return BeamClass::kStatic;
  const bool leaf = std::any_of(world.doors.begin(), world.doors.end(), [&](const auto& door) {
    return object.name == door.name + "/leaf";
  });
  if (leaf) return BeamClass::kDoor;
  return object.movable ? BeamClass::kMoved : BeamClass::kUnmapped;
}

}  // namespace

HitLegend hit_legend(const sim::WorldSpec& world) {
  HitLegend legend;
  legend.first_person = sim::kHitPerson;
  for (std::size_t i = 0; i < world.objects.size(); ++i) {
    const sim::WorldObject& object = world.objects[i];
    legend.entries[static_cast<int>(i)] = {class_of(world, object), object.name};
  }
  legend.entries[sim::kHitFloor] = {BeamClass::kFloor, "floor"};
  legend.entries[sim::kHitDust] = {BeamClass::kDust, "dust"};
  legend.entries[sim::kHitCover] = {BeamClass::kCover, "cover"};
  return legend;
}

std::vector<localization::ScanLayer> layers_of(const sim::LidarReading& reading,
                                               const sim::LidarConfig& lidar) {
  if (lidar.elevations.size() < 2) return {};
  std::vector<localization::ScanLayer> layers;
  for (std::size_t i = 0; i < lidar.elevations.size(); ++i) {
    layers.push_back(
        {lidar.elevations[i], layer_of(reading.ranges, i, static_cast<std::size_t>(lidar.beams))});
  }
  return layers;
}

LaserScan laser_scan(const sim::LidarReading& reading, const sim::LidarConfig& lidar) {
  LaserScan scan;
  scan.stamp = reading.stamp;
  scan.time_increment = reading.time_increment;
  scan.angle_min = lidar.angle_min;
  scan.angle_increment = lidar.angle_increment;
  scan.range_min = lidar.range_min;
  scan.range_max = lidar.range_max;
  const auto layer = static_cast<std::size_t>(sim::level_layer(lidar));
  scan.ranges = layer_of(reading.ranges, layer, static_cast<std::size_t>(lidar.beams));
  const double elevation = lidar.elevations[layer];
  if (elevation != 0.0) {
    for (float& range : scan.ranges) range *= static_cast<float>(std::cos(elevation));
  }
  scan.T_base_laser = lidar.T_base_laser;
  if (reading.mount_error) {
    scan.T_base_laser = sim::to_isometry(*reading.mount_error) * lidar.T_base_laser;
  }
  scan.lidar = lidar.name;
  scan.layers = layers_of(reading, lidar);
  return scan;
}

ScanTruth scan_truth(const sim::LidarReading& reading, const sim::LidarConfig& lidar, bool cloud) {
  const auto layer = static_cast<std::size_t>(sim::level_layer(lidar));
  const auto beams = static_cast<std::size_t>(lidar.beams);
  ScanTruth truth;
  truth.frame = lidar.frame;
  truth.intensities = layer_of(reading.intensities, layer, beams);
  truth.labels = layer_of(reading.hit_object, layer, beams);
  if (cloud) truth.cloud = cloud_of(reading, lidar);
  return truth;
}

std::vector<LidarFacts> lidars_of(const std::vector<sim::LidarConfig>& lidars) {
  std::vector<LidarFacts> facts;
  for (const sim::LidarConfig& lidar : lidars) {
    sim::LidarReading reading;
    reading.ranges.resize(static_cast<std::size_t>(lidar.beams) * lidar.elevations.size());
    facts.push_back(lidar_facts(laser_scan(reading, lidar)));
    facts.back().frame = lidar.frame;
  }
  return facts;
}

}  // namespace castaway::testbed
