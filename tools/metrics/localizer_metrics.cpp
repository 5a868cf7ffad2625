#include "tools/metrics/localizer_metrics.hpp"

#include <algorithm>

namespace castaway::testbed {
namespace {

bool is_tracking(const std::vector<RecoveryWindow>& windows, Stamp stamp) {
  return std::none_of(windows.begin(), windows.end(),
                      [&](const RecoveryWindow& window) { return window.is_lost_at(stamp); });
}

void measure_errors(const std::vector<MetricRow>& rows, LocalizerMetrics& metrics) {
  std::vector<double> position;
  std::vector<double> yaw;
  std::vector<double> tracking;
  for (const MetricRow& row : rows) {
    const auto error = pose_error(row);
    if (!error) continue;
    position.push_back(error->position_m);
    yaw.push_back(error->yaw_rad);
    if (is_tracking(metrics.windows, row.stamp)) tracking.push_back(error->position_m);
  }
  metrics.position_error_m = statistics(std::move(position));
  metrics.yaw_error_rad = statistics(std::move(yaw));
  metrics.tracking_error_m = statistics(std::move(tracking));
}

void measure_recovery(LocalizerMetrics& metrics) {
  std::vector<double> times;
  std::vector<double> distances;
  for (const RecoveryWindow& window : metrics.windows) {
    if (window.scored) ++metrics.events;
    if (!window.recovered) continue;
    times.push_back(seconds(*window.recovered - window.begin));
    distances.push_back(window.distance_m);
  }
  metrics.recovered = static_cast<int>(times.size());
  if (metrics.events > 0) {
    metrics.success = static_cast<double>(metrics.recovered) / metrics.events;
  }
  metrics.recovery_time_s = statistics(std::move(times));
  metrics.recovery_distance_m = statistics(std::move(distances));
}

void measure_wrong_lock(const std::vector<MetricRow>& rows, const RecoveryConfig& config,
                        LocalizerMetrics& metrics) {
  int answered = 0;
  int wrong = 0;
  for (const MetricRow& row : rows) {
    if (!pose_error(row)) continue;
    ++answered;
    if (!row.lost && !is_right(row, config)) ++wrong;
  }
  if (answered > 0) metrics.wrong_lock_share = static_cast<double>(wrong) / answered;
}

void measure_detection(LocalizerMetrics& metrics) {
  std::vector<double> delays;
  for (const RecoveryWindow& window : metrics.windows) {
    if (window.unknown_start || !window.scored) continue;
    if (const auto delay = window.detection_delay_s()) {
      delays.push_back(*delay);
    } else {
      ++metrics.undetected;
    }
  }
  metrics.detection_delay_s = statistics(std::move(delays));
}

/// Up to when an alarm answers the kidnap (or the unknown start) of a window.
Stamp excused_until(const RecoveryWindow& window, const RecoveryConfig& config) {
  const Stamp grace = std::min(window.begin + config.alarm_grace, window.end);
  return std::max(window.recovered.value_or(window.end), grace);
}

void measure_false_alarms(const std::vector<MetricRow>& rows, Stamp end,
                          const RecoveryConfig& config, LocalizerMetrics& metrics) {
  if (rows.empty()) return;
  Stamp watched = end - rows.front().stamp;
  for (const RecoveryWindow& window : metrics.windows) {
    watched -= excused_until(window, config) - window.taken;
  }
  if (watched <= Stamp::zero() || !metrics.tracking_error_m) return;
  bool was_lost = false;
  for (const MetricRow& row : rows) {
    const bool onset = row.lost && !was_lost;
    const bool excused = std::any_of(
        metrics.windows.begin(), metrics.windows.end(), [&](const RecoveryWindow& window) {
          return row.answered() >= window.taken && row.answered() < excused_until(window, config);
        });
    if (onset && is_right(row, config) && !excused) ++metrics.false_alarms;
    was_lost = row.lost;
  }
  metrics.watched_s = seconds(watched);
  metrics.false_alarms_per_h = metrics.false_alarms * 3600.0 / metrics.watched_s;
}

}  // namespace

LocalizerMetrics measure(const std::vector<MetricRow>& all, const std::vector<RunEvent>& events,
                         bool known_start, Stamp end, const RecoveryConfig& config) {
  LocalizerMetrics metrics;
  const std::vector<RunEvent> kidnaps = kidnaps_of(events);
  const std::vector<MetricRow> rows = with_torn_marked(all, kidnaps);
  metrics.windows = recovery_windows(rows, kidnaps, known_start, end, config);
  measure_errors(rows, metrics);
  measure_recovery(metrics);
  measure_wrong_lock(rows, config, metrics);
  measure_detection(metrics);
  measure_false_alarms(rows, end, config, metrics);
  metrics.calibration = calibration_of(rows, config);
  return metrics;
}

}  // namespace castaway::testbed
