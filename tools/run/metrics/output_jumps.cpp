#include "tools/run/metrics/output_jumps.hpp"

#include <algorithm>
#include <utility>

namespace castaway::testbed {
namespace {

using localization::distance;
using localization::yaw_distance;

/// The previous answer moved by odometry.
SE2 predict_answer(const MetricRow& before, const MetricRow& now) {
  return *before.T_map_base_estimate * before.T_odom_base.inverse() * now.T_odom_base;
}

bool is_tracking(const std::vector<RecoveryWindow>& windows, const MetricRow& row) {
  return std::none_of(windows.begin(), windows.end(), [&](const RecoveryWindow& window) {
    // The row of the recovery itself still belongs to the window: it is the response to the kidnap.
    return row.answered() >= window.taken &&
           row.answered() <= window.recovered.value_or(window.end);
  });
}

}  // namespace

OutputJumps jumps_of(const std::vector<MetricRow>& rows, const std::vector<RecoveryWindow>& windows,
                     const JumpConfig& config) {
  OutputJumps jumps;
  const MetricRow* before = nullptr;
  for (const MetricRow& row : rows) {
    if (!row.T_map_base_estimate) continue;
    const MetricRow* last = std::exchange(before, &row);
    if (last == nullptr) continue;
    const SE2 unmoved = predict_answer(*last, row);
    const double leap = distance(unmoved, *row.T_map_base_estimate);
    jumps.largest_m = std::max(jumps.largest_m, leap);
    const bool jumped = leap > config.position_m ||
                        yaw_distance(unmoved, *row.T_map_base_estimate) > config.yaw_rad;
    if (!jumped) continue;
    ++jumps.count;
    if (is_tracking(windows, row)) ++jumps.while_tracking;
  }
  return jumps;
}

}  // namespace castaway::testbed
