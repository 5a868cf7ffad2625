/// Refines a pose below the grid: climbs the score from a start, and measures its curvature at the
/// top.
#pragma once

#include <optional>

#include "localization/sensor/endpoint_model.hpp"

namespace castaway::localization {

/// A Gaussian belief about the pose, as a quadratic form.
struct PosePrior {
  SE2 mean;
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< Inverse covariance of (x, y, yaw).
};

/// Steps of the climb.
struct RefineConfig {
  double step_m = 0.08;    ///< [m] First step.
  double step_rad = 0.03;  ///< [rad] First step.
  int halvings = 4;        ///< The last step is the first divided by 2^halvings.
};

/// The pose near `start` with the highest score: log-likelihood of the scan minus half the prior's
/// squared distance. Coordinate search with halved steps; moves only where the score rises, so a
/// flat score keeps the start.
SE2 refine_pose(const EndpointModel& model, const ScanPoints& points, const SE2& start,
                const std::optional<PosePrior>& prior, const RefineConfig& config);

/// Information (inverse covariance) that the scan alone gives about the pose: the negative
/// curvature of the log-likelihood by central differences, its negative eigenvalues cut to 0.
Eigen::Matrix3d scan_information(const EndpointModel& model, const ScanPoints& points,
                                 const SE2& T_map_base);

}  // namespace castaway::localization
