/// Logs of a robot that stands or turns, and their twins, for tests.
#pragma once

#include <numbers>
#include <string>

#include "tests/tools/twin/room_log.hpp"
#include "tools/scenario/scenario_file.hpp"
#include "tools/scenario/sections/lidar_yaml.hpp"
#include "tools/twin/twin_text.hpp"

namespace castaway::testbed {

inline constexpr double kTwinDegree = std::numbers::pi / 180.0;

inline Figure figure_of(double value, double half = 1e-3) {
  return {value, {value - half, value + half}};
}

/// 0.1 s between scans of 181 beams to the front, by a lidar that is mounted ahead and turned.
inline AlignedScan front_scan(int index) {
  AlignedScan aligned;
  LaserScan& scan = aligned.scan;
  scan.stamp = std::chrono::milliseconds(5000 + 100 * index);
  scan.angle_min = -90.0 * kTwinDegree;
  scan.angle_increment = kTwinDegree;
  scan.range_min = 0.15;
  scan.range_max = 25.0;
  scan.ranges.assign(181, 2.0F);
  scan.T_base_laser = localization::to_se3({0.12, -0.03, 0.2});
  scan.T_base_laser.translation().z() = 0.45;
  return aligned;
}

/// A log of a robot that stands for 10 s, without models.
inline FittedLog standing_twin() {
  FittedLog fitted;
  fitted.log = standing_log(room_grid());
  for (int k = 0; k <= 100; ++k) {
    fitted.log.scans.push_back(front_scan(k));
    fitted.log.scans.back().T_map_base = {1.0, 2.0, 0.5};
    fitted.log.stamps.push_back(fitted.log.scans.back().scan.stamp);
  }
  fitted.fit.stamps.rate_hz = 10.0;
  return fitted;
}

/// A log of a robot that turns at 2 rad/s about its axle for 10 s while it drives on by `speed`
/// [m/s]; base is `ahead` [m] of the axle.
inline FittedLog turning_twin(double ahead, double speed = 0.0) {
  constexpr double kRate = 2.0;  // [rad/s]
  FittedLog fitted = standing_twin();
  fitted.log.T_odom_base = localization::TransformBuffer({.length = std::chrono::hours(1)});
  const SE2 T_axle_base{ahead, 0.0, 0.0};
  const SE2 T_map_odom{1.0, 2.0, 0.5};
  for (int k = 0; k <= 1000; ++k) {
    const double turn = kRate * 0.01 * k;
    const double radius = speed / kRate;
    const SE2 T_odom_axle{radius * std::sin(turn), radius * (1.0 - std::cos(turn)), turn};
    fitted.log.T_odom_base.add(std::chrono::milliseconds(5000 + 10 * k), T_odom_axle * T_axle_base);
    if (k % 10 == 0) {
      fitted.log.scans[static_cast<std::size_t>(k) / 10].T_map_base =
          T_map_odom * T_odom_axle * T_axle_base;
    }
  }
  return fitted;
}

inline Scenario read_twin(const FittedLog& fitted, int people = 0) {
  YamlDocument document = YamlDocument::parse(twin_scenario(fitted, people), "scenario.yaml");
  return read_scenario(std::move(document), ".", "other").scenario;
}

/// The lidar of a twin, on a robot that describes another one.
inline sim::LidarConfig read_twin_lidar(const FittedLog& fitted) {
  const Scenario scenario = read_twin(fitted);
  EXPECT_EQ(scenario.lidars.size(), 1U);
  EXPECT_EQ(scenario.lidars.front().profile, "ideal");
  return apply_changes(sim::LidarConfig{}, scenario.lidars.front().changes);
}

}  // namespace castaway::testbed
