#include "tools/run/metrics/stated_metrics.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "tools/run/metrics/calibration.hpp"
#include "tools/run/metrics/metrics_json.hpp"
#include "tools/run/metrics/statistics/wrong_time.hpp"

namespace castaway::testbed {
namespace {

/// A share of countable things.
struct Share {
  std::size_t of = 0;
  std::size_t counted = 0;

  void take(bool counts) {
    ++of;
    if (counts) ++counted;
  }
  [[nodiscard]] std::optional<double> value() const {
    if (of == 0) return std::nullopt;
    return static_cast<double>(counted) / static_cast<double>(of);
  }
};

void measure_alarms(const std::vector<MetricRow>& rows, Stamp end, StatedMetrics& stated) {
  Share alarm;
  WrongTime time;
  bool was_lost = false;
  for (const MetricRow& row : rows) {
    alarm.take(row.lost);
    time.take(row.stamp, row.lost);
    if (row.lost && !was_lost) ++stated.alarms;
    was_lost = row.lost;
  }
  time.finish(end);
  stated.alarm_share = alarm.value();
  stated.longest_alarm_s = time.longest_s();
}

}  // namespace

StatedMetrics measure_stated(const std::vector<MetricRow>& rows, Stamp end,
                             const JumpConfig& jump) {
  StatedMetrics stated;
  Share answered;
  Share sure;
  double probabilities = 0.0;
  for (const MetricRow& row : rows) {
    answered.take(row.T_map_base_estimate.has_value());
    if (!row.T_map_base_estimate) continue;
    sure.take(row.probability >= kSure);
    probabilities += row.probability;
  }
  stated.scans = rows.size();
  stated.answered_share = answered.value();
  stated.sure_share = sure.value();
  if (sure.of > 0) stated.probability_mean = probabilities / static_cast<double>(sure.of);
  if (sure.of > 1) {
    const int jumps = jumps_of(rows, {}, jump).count;
    stated.steady_share = 1.0 - jumps / static_cast<double>(sure.of - 1);
  }
  measure_alarms(rows, end, stated);
  return stated;
}

std::optional<double> agreement_of(const std::vector<MetricRow>& a,
                                   const std::vector<MetricRow>& b) {
  Share agreeing;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (!a[i].T_map_base_estimate || !b[i].T_map_base_estimate) continue;
    MetricRow row = a[i];
    row.T_map_base_true = b[i].T_map_base_estimate;
    row.above = a[i].above - b[i].above;
    row.torn = false;
    agreeing.take(is_right(row, {}));
  }
  return agreeing.value();
}

nlohmann::ordered_json to_json(const StatedMetrics& metrics) {
  return {{"scans", metrics.scans},
          {"answered_share", json_figure(metrics.answered_share)},
          {"probability_mean", json_figure(metrics.probability_mean)},
          {"sure_share", json_figure(metrics.sure_share)},
          {"alarm_share", json_figure(metrics.alarm_share)},
          {"alarms", metrics.alarms},
          {"longest_alarm_s", json_figure(metrics.longest_alarm_s)},
          {"steady_share", json_figure(metrics.steady_share)}};
}

}  // namespace castaway::testbed
