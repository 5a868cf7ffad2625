#include "tools/run/metrics/localizer_metrics.hpp"

#include <algorithm>

#include "tools/run/metrics/statistics/bootstrap.hpp"
#include "tools/run/metrics/statistics/wrong_time.hpp"

namespace castaway::testbed {
namespace {

bool is_tracking(const std::vector<RecoveryWindow>& windows, Stamp stamp) {
  return std::none_of(windows.begin(), windows.end(),
                      [&](const RecoveryWindow& window) { return window.is_lost_at(stamp); });
}

constexpr double kBootstrapBlock =
    5.0;  // [s] Length of a bootstrap block; rows within it are correlated.

/// Number of rows in a block of 5 s, by the mean period of the rows.
std::size_t block_of(const std::vector<MetricRow>& rows) {
  if (rows.size() < 2) return 1;
  const double period =
      seconds(rows.back().stamp - rows.front().stamp) / static_cast<double>(rows.size() - 1);
  return period > 0.0 ? static_cast<std::size_t>(std::max(kBootstrapBlock / period, 1.0)) : 1;
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
  const std::size_t block = block_of(rows);
  const auto summed_up = [block](std::vector<double> sample, const char* name) {
    return statistics_with_intervals(std::move(sample), {.stream = name, .block = block});
  };
  metrics.position_error_m = summed_up(std::move(position), "position_error_m");
  metrics.yaw_error_rad = summed_up(std::move(yaw), "yaw_error_rad");
  metrics.tracking_error_m = summed_up(std::move(tracking), "tracking_error_m");
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
  metrics.recovery_time_s = statistics_with_intervals(std::move(times), {.stream = "time_s"});
  metrics.recovery_distance_m =
      statistics_with_intervals(std::move(distances), {.stream = "distance_m"});
}

void measure_wrong_lock(const std::vector<MetricRow>& rows, const RecoveryConfig& config,
                        LocalizerMetrics& metrics) {
  int answered = 0;
  int wrong = 0;
  for (const MetricRow& row : rows) {
    if (!pose_error(row)) continue;
    ++answered;
    if (is_wrong_lock(row, config)) ++wrong;
  }
  if (answered > 0) metrics.wrong_lock_share = static_cast<double>(wrong) / answered;
}

void measure_wrong_lock_time(const std::vector<MetricRow>& rows, Stamp end,
                             const RecoveryConfig& config, LocalizerMetrics& metrics) {
  WrongTime time;
  for (const MetricRow& row : rows) time.take(row.stamp, is_wrong_lock(row, config));
  time.finish(end);
  metrics.wrong_lock_s = time.total_s();
  metrics.longest_wrong_lock_s = time.longest_s();
}

void measure_availability(const std::vector<MetricRow>& rows, LocalizerMetrics& metrics) {
  int scored = 0;
  int available = 0;
  for (const MetricRow& row : rows) {
    if (!row.T_map_base_true || row.torn) continue;
    ++scored;
    if (row.T_map_base_estimate && !row.lost) ++available;
  }
  if (scored > 0) metrics.availability = static_cast<double>(available) / scored;
}

/// Computes the APE of the trajectories in the TUM files: one pose per stamp, the first one.
std::optional<Ape> ape_of(const std::vector<MetricRow>& rows) {
  std::vector<StampedPose> truth;
  std::vector<StampedPose> estimate;
  std::optional<Stamp> newest;
  for (const MetricRow& row : rows) {
    if (newest && row.stamp <= *newest) continue;
    newest = row.stamp;
    if (row.T_map_base_true) truth.push_back({row.stamp, *row.T_map_base_true});
    if (row.T_map_base_estimate) estimate.push_back({row.stamp, *row.T_map_base_estimate});
  }
  return absolute_pose_error(truth, estimate);
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

/// Up to this time an alarm is a correct response to the kidnap (or unknown start) of a window.
Stamp alarm_grace_end(const RecoveryWindow& window, const RecoveryConfig& config) {
  const Stamp grace = std::min(window.begin + config.alarm_grace, window.end);
  return std::max(window.recovered.value_or(window.end), grace);
}

/// True if an alarm is a correct response to a kidnap or to an unknown start.
bool is_excused(const MetricRow& row, const std::vector<RecoveryWindow>& windows,
                const RecoveryConfig& config) {
  return std::any_of(windows.begin(), windows.end(), [&](const RecoveryWindow& window) {
    return row.answered() >= window.taken && row.answered() < alarm_grace_end(window, config);
  });
}

void measure_false_alarms(const std::vector<MetricRow>& rows, Stamp end,
                          const RecoveryConfig& config, LocalizerMetrics& metrics) {
  if (rows.empty()) return;
  Stamp watched = end - rows.front().stamp;
  for (const RecoveryWindow& window : metrics.windows) {
    watched -= alarm_grace_end(window, config) - window.taken;
  }
  if (watched <= Stamp::zero() || !metrics.tracking_error_m) return;
  bool was_lost = false;
  for (const MetricRow& row : rows) {
    const bool onset = row.lost && !was_lost;
    const bool excused = is_excused(row, metrics.windows, config);
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
  metrics.has_truth = truth_share(all).value_or(0.0) > 0.0;
  const std::vector<RunEvent> kidnaps = kidnaps_of(events);
  const std::vector<MetricRow> rows = mark_torn_rows(all, kidnaps);
  metrics.windows = recovery_windows(rows, breaks_of(events), known_start, end, config);
  measure_errors(rows, metrics);
  measure_recovery(metrics);
  measure_wrong_lock(rows, config, metrics);
  measure_wrong_lock_time(rows, end, config, metrics);
  measure_availability(rows, metrics);
  metrics.jumps = jumps_of(rows, metrics.windows);
  measure_detection(metrics);
  measure_false_alarms(rows, end, config, metrics);
  metrics.calibration = calibration_of(rows, config);
  metrics.discrimination = discrimination_of(rows);
  metrics.ape = ape_of(rows);
  return metrics;
}

}  // namespace castaway::testbed
