/// Rows of a run, the input of the metrics, and the distance driven.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// One scan and one localizer's answer to it.
struct MetricRow {
  Stamp stamp{};                           ///< Stamp of the scan; rows are sorted by it.
  SE2 T_odom_base;                         ///< Odometry, for distances if the truth is not known.
  std::optional<SE2> T_map_base_true;      ///< Nothing if unknown; the row is then not scored.
  std::optional<SE2> T_map_base_estimate;  ///< Nothing if the localizer has no answer.
  bool lost = false;                       ///< The localizer raises the alarm.
  Stamp delivered{};                       ///< Time of the answer, if later than `stamp`.
  double probability = 0.0;                ///< In [0, 1]: stated probability that the estimate is
                                           ///< right.
  double quality = 0.0;                    ///< In [0, 1]: how well the scan fits the map at the
                                           ///< estimate.
  double sigma_m = 0.0;  ///< [m] sqrt((var_x + var_y) / 2) of the stated covariance.
  double above = 0.0;    ///< [m] How far the estimate is above the robot; 0 on one floor.
  bool torn = false;     ///< A kidnap happened during the scan, so it is not scored.

  /// Time of the answer; recoveries and alarms are timed by it.
  [[nodiscard]] Stamp answered() const { return std::max(stamp, delivered); }
};

/// Error of an estimate relative to the true pose.
struct PoseError {
  double position_m = 0.0;
  double yaw_rad = 0.0;  ///< In [0, pi].
};

/// Nothing if truth or estimate is missing or the scan is torn.
std::optional<PoseError> pose_error(const MetricRow& row);

/// The events that displaced the robot.
std::vector<RunEvent> kidnaps_of(const std::vector<RunEvent>& events);

/// The events that end what a localizer did before: kidnaps and an operator's orders.
std::vector<RunEvent> breaks_of(const std::vector<RunEvent>& events);

/// The events without orders to other localizers.
std::vector<RunEvent> events_for(const std::string& localizer, const std::vector<RunEvent>& events);

/// Marks the rows of torn scans: the robot was lifted or put down between the first and the last
/// beam. Such a scan has no single true pose.
std::vector<MetricRow> mark_torn_rows(std::vector<MetricRow> rows,
                                      const std::vector<RunEvent>& kidnaps);

/// Share of the rows whose true pose is known; nothing without rows.
std::optional<double> truth_share(const std::vector<MetricRow>& rows);

/// Distance driven [m] up to each row, 0 at the first: along the true path, or along odometry if
/// the truth is not known. Neither the jump of a kidnap nor the path while the robot is carried
/// counts.
std::vector<double> driven_distance(const std::vector<MetricRow>& rows,
                                    const std::vector<RunEvent>& kidnaps);

}  // namespace castaway::testbed
