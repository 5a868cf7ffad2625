#include "tools/run/metrics/fault_metrics.hpp"

#include "tools/run/metrics/recovery.hpp"

namespace castaway::testbed {
namespace {

constexpr Stamp kAftermath = std::chrono::seconds(5);

}  // namespace

std::vector<FaultWindow> fault_windows(const std::vector<RunEvent>& events, Stamp end) {
  std::vector<FaultWindow> windows;
  std::vector<bool> open;
  for (const RunEvent& event : events) {
    if (event.kind == EventKind::kFaultOn) {
      const bool instant = event.detail == "odometry-reset";
      windows.push_back({event.detail, event.stamp, instant ? event.stamp : end});
      open.push_back(!instant);
    }
    if (event.kind != EventKind::kFaultOff) continue;
    for (std::size_t i = 0; i < windows.size(); ++i) {
      if (!open[i] || windows[i].fault != event.detail) continue;
      windows[i].end = event.stamp;
      open[i] = false;
      break;
    }
  }
  return windows;
}

FaultMetrics measure_fault(const std::vector<MetricRow>& rows, const FaultWindow& window) {
  const RecoveryConfig limits;
  FaultMetrics metrics;
  double sum = 0.0;
  int scored = 0;
  int wrong_confident = 0;
  for (const MetricRow& row : rows) {
    if (row.answered() < window.begin || row.answered() >= window.end + kAftermath) continue;
    metrics.alarm = metrics.alarm || row.lost;
    const auto error = pose_error(row);
    if (!error) continue;
    ++scored;
    sum += error->position_m;
    if (!row.lost && !is_right(row, limits)) ++wrong_confident;
  }
  if (scored == 0) return metrics;
  metrics.mean_error_m = sum / scored;
  metrics.wrong_confident_share = static_cast<double>(wrong_confident) / scored;
  return metrics;
}

}  // namespace castaway::testbed
