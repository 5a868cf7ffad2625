#include "tests/bench/workbench/odometry_drift.hpp"

#include <cmath>
#include <numbers>

namespace castaway::testbed {
namespace {

constexpr double kStride = 1.0;  // [m] Distance between the starts of consecutive segments.

/// Odometry, true pose and the distance driven so far.
struct Step {
  SE2 T_odom_base;
  SE2 T_map_base;
  double way = 0.0;  ///< [m]
};

DriftSegment drift(const Step& a, const Step& b) {
  const SE2 by_odometry = a.T_odom_base.inverse() * b.T_odom_base;
  const SE2 in_truth = a.T_map_base.inverse() * b.T_map_base;
  const SE2 error = in_truth.inverse() * by_odometry;
  const double length = b.way - a.way;
  const double yaw_deg = std::abs(error.yaw) * 180.0 / std::numbers::pi;
  return {100.0 * std::hypot(error.x, error.y) / length, yaw_deg / length};
}

void add_segments(const std::vector<Step>& steps, double length_m,
                  std::vector<DriftSegment>& segments) {
  std::size_t end = 0;
  double next_begin = 0.0;
  for (const Step& begin : steps) {
    if (begin.way < next_begin) continue;
    while (end < steps.size() && steps[end].way < begin.way + length_m) ++end;
    if (end == steps.size()) return;
    segments.push_back(drift(begin, steps[end]));
    next_begin = begin.way + kStride;
  }
}

}  // namespace

std::vector<DriftSegment> drift_segments(const Frames& frames, double length_m) {
  std::vector<DriftSegment> segments;
  std::vector<Step> steps;
  for (const Frame& frame : frames) {
    const auto* event = std::get_if<RunEvent>(&frame.data);
    if (event != nullptr && event->is<KidnapEvent>()) {
      add_segments(steps, length_m, segments);
      steps.clear();
    }
    const auto* reading = std::get_if<OdometryFrame>(&frame.data);
    if (reading == nullptr || !reading->true_pose) continue;
    Step step{reading->odometry.T_odom_base, reading->true_pose->T_map_base, 0.0};
    if (!steps.empty()) {
      const SE2& before = steps.back().T_map_base;
      step.way =
          steps.back().way + std::hypot(step.T_map_base.x - before.x, step.T_map_base.y - before.y);
    }
    steps.push_back(step);
  }
  add_segments(steps, length_m, segments);
  return segments;
}

std::optional<DriftSegment> mean_drift(const std::vector<DriftSegment>& segments) {
  if (segments.empty()) return std::nullopt;
  DriftSegment mean;
  for (const DriftSegment& segment : segments) {
    mean.percent += segment.percent / static_cast<double>(segments.size());
    mean.deg_per_m += segment.deg_per_m / static_cast<double>(segments.size());
  }
  return mean;
}

}  // namespace castaway::testbed
