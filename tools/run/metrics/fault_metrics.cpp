#include "tools/run/metrics/fault_metrics.hpp"

#include "tools/run/metrics/recovery.hpp"

namespace castaway::testbed {
namespace {

constexpr Stamp kAftermath = std::chrono::seconds(5);

bool is_reset(const sim::FaultEdge::What& what) {
  const auto* fault = std::get_if<sim::SensorFault>(&what);
  return fault != nullptr && fault->kind == sim::FaultKind::kOdometryReset;
}

}  // namespace

std::vector<FaultWindow> fault_windows(const std::vector<RunEvent>& events, Stamp end) {
  std::vector<FaultWindow> windows;
  std::vector<bool> open;
  for (const RunEvent& event : events) {
    const auto* edge = event.as<sim::FaultEdge>();
    if (edge == nullptr) continue;
    if (edge->begins) {
      const bool instant = is_reset(edge->what);
      windows.push_back({edge->what, event.stamp, instant ? event.stamp : end});
      open.push_back(!instant);
      continue;
    }
    for (std::size_t i = 0; i < windows.size(); ++i) {
      if (!open[i] || windows[i].fault != edge->what) continue;
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
