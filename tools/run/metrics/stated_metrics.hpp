/// What a localizer states itself, without any true pose.
#pragma once

#include <optional>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "tools/run/metrics/output_jumps.hpp"
#include "tools/run/metrics/run_rows.hpp"

namespace castaway::testbed {

/// What a localizer states over a run. Nothing here needs the truth. A share is missing if there
/// was nothing to count.
struct StatedMetrics {
  std::size_t scans = 0;
  std::optional<double> answered_share;    ///< Share of the scans that were answered.
  std::optional<double> probability_mean;  ///< Of the answers.
  std::optional<double> sure_share;        ///< Share of the answers stating at least `kSure`.
  std::optional<double> alarm_share;       ///< Share of the scans with the alarm.
  int alarms = 0;                          ///< Times at which the alarm was raised.
  double longest_alarm_s = 0.0;            ///< [s] Longest uninterrupted alarm.
  /// Share of the answers that are the previous answer moved by odometry, to 0.2 m and 0.2 rad.
  std::optional<double> steady_share;
};

/// Measures what the rows of a run that ended at `end` state.
StatedMetrics measure_stated(const std::vector<MetricRow>& rows, Stamp end,
                             const JumpConfig& jump = {});

/// Share of the scans answered by both localizers whose answers are right by each other (0.5 m,
/// 0.35 rad); nothing if there are none. Rows are those of one run, in the same order.
std::optional<double> agreement_of(const std::vector<MetricRow>& a,
                                   const std::vector<MetricRow>& b);

nlohmann::ordered_json to_json(const StatedMetrics& metrics);

}  // namespace castaway::testbed
