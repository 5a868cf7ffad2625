/// Records of a run for tests of sinks.
#pragma once

#include <string>
#include <vector>

#include "castaway/stamp.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// A run of these localizers.
inline RunInfo run_of(const std::vector<std::string>& localizers) {
  RunInfo info;
  info.scenario = "a-scenario";
  info.world = "a-world";
  info.robot = "a-robot";
  info.seed = 7;
  info.localizers = localizers;
  return info;
}

/// A scan at `t` [s], delivered 0.1 s later: the truth is at x = `t` / 10 m, every estimate 0.2 m
/// to the left of it and rotated by 0.1.
inline ScanRecord record_at(double t, const std::vector<std::string>& localizers) {
  ScanRecord record;
  record.stamp = localization::from_seconds(t);
  record.delivered = localization::from_seconds(t + 0.1);
  record.true_pose = SE2{0.1 * t, 0.0, 0.0};
  record.T_odom_base = {0.1 * t, 0.0, 0.0};
  for (const std::string& name : localizers) {
    LocalizerRecord& localizer = record.localizers.emplace_back();
    localizer.name = name;
    localizer.estimate.emplace();
    localizer.estimate->stamp = record.stamp;
    localizer.estimate->T_map_base = {0.1 * t, 0.2, 0.1};
    localizer.estimate->quality = 0.75;
    localizer.estimate->probability = 0.5;
    localizer.update_cpu = std::chrono::milliseconds(2);
  }
  return record;
}

/// A kidnap at `t` [s] by 4 m along y.
inline RunEvent kidnap_to(double t) {
  return {localization::from_seconds(t), KidnapEvent{}, SE2{0.1 * t, 0.0, 0.0},
          SE2{0.1 * t, 4.0, 0.0}};
}

}  // namespace castaway::testbed
