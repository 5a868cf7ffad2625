/// What the metrics know of a run, and how far it went.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// One scan and one localizer's answer to it.
struct MetricRow {
  Stamp stamp{};                           ///< The scan's; rows come in its order.
  SE2 T_odom_base;                         ///< Odometry, for distances where there is no truth.
  std::optional<SE2> T_map_base_true;      ///< Nothing: the row is not scored.
  std::optional<SE2> T_map_base_estimate;  ///< Nothing: the localizer has no answer.
  bool lost = false;                       ///< The alarm.
  Stamp delivered{};                       ///< When the answer was there, if later than `stamp`.
  double probability = 0.0;                ///< In [0, 1]: stated, that the estimate is right.
  double quality = 0.0;                    ///< In [0, 1]: how well the scan fits the map there.
  double sigma_m = 0.0;  ///< sqrt((var_x + var_y) / 2) of the stated covariance. [m]
  bool torn = false;     ///< Part of the scan was taken before a kidnap and part after: not scored.

  /// When the answer was there: a recovery or an alarm counts from then on.
  [[nodiscard]] Stamp answered() const { return std::max(stamp, delivered); }
};

/// True pose against estimate.
struct PoseError {
  double position_m = 0.0;
  double yaw_rad = 0.0;  ///< In [0, pi].
};

/// Nothing without truth or estimate, nor for a torn scan.
std::optional<PoseError> pose_error(const MetricRow& row);

/// When the robot was displaced.
std::vector<RunEvent> kidnaps_of(const std::vector<RunEvent>& events);

/// The rows with those marked whose scan a kidnap tore: it was lifted or put down between the
/// first beam and the last. Such a scan has no one true pose.
std::vector<MetricRow> with_torn_marked(std::vector<MetricRow> rows,
                                        const std::vector<RunEvent>& kidnaps);

/// Distance driven up to each row, 0 at the first: along the true path, along odometry where the
/// truth is not known. A kidnap's jump does not count, nor does a way that it is carried. [m]
std::vector<double> driven_distance(const std::vector<MetricRow>& rows,
                                    const std::vector<RunEvent>& kidnaps);

}  // namespace castaway::testbed
