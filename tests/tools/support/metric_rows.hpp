/// Rows for tests of metrics: a robot on the x axis, one row per second.
#pragma once

#include <vector>

#include "castaway/stamp.hpp"
#include "tools/run/metrics/run_rows.hpp"

namespace castaway::testbed {

using localization::from_seconds;

/// A row at `t` [s] at x = `t` / 10 m with these errors of position [m] and yaw [rad].
inline MetricRow row_at(double t, double error = 0.0, double yaw_error = 0.0) {
  MetricRow row;
  row.stamp = from_seconds(t);
  row.T_odom_base = {0.1 * t, 0.0, 0.0};
  row.T_map_base_true = SE2{0.1 * t, 0.0, 0.0};
  row.T_map_base_estimate = SE2{0.1 * t, error, yaw_error};
  return row;
}

/// Rows at 0, 1, 2... s with these position errors [m].
inline std::vector<MetricRow> rows_with(const std::vector<double>& errors) {
  std::vector<MetricRow> rows;
  for (const double error : errors) rows.push_back(row_at(static_cast<double>(rows.size()), error));
  return rows;
}

/// `count` rows at 0, 1, 2... s without error.
inline std::vector<MetricRow> right_rows(std::size_t count) {
  return rows_with(std::vector<double>(count, 0.0));
}

/// A kidnap of which only the time is set.
inline RunEvent kidnap_at(double t) { return {from_seconds(t), KidnapEvent{}}; }

}  // namespace castaway::testbed
