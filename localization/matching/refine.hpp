/// Refines a pose below the grid's resolution: climbs the score from a start, and measures its
/// curvature at the maximum.
#pragma once

#include <functional>
#include <optional>

#include "localization/geometry/pose_statistics.hpp"
#include "localization/sensor/endpoint_model.hpp"

namespace castaway::localization {

/// A Gaussian prior of the pose in information form.
struct PosePrior {
  SE2 mean;
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< Inverse covariance of (x, y, yaw).
};

/// The prior of a belief, which may be certain in some direction.
PosePrior make_prior(const PoseMoments& belief);

/// Minus half the squared Mahalanobis distance of a pose. [nats]
double log_prior(const PosePrior& prior, const SE2& pose);

/// Step sizes of the climb.
struct RefineConfig {
  double step_m = 0.08;    ///< [m] First step.
  double step_rad = 0.03;  ///< [rad] First step.
  int halvings = 4;        ///< The last step is the first divided by 2^halvings.
};

/// Returns the pose near `start` with the highest score: log-likelihood of the scan minus half the
/// squared Mahalanobis distance from the prior. Coordinate search with halved steps; it moves only
/// where the score increases, so a flat score returns the start.
SE2 refine_pose(const EndpointModel& model, const ScanPoints& points, const SE2& start,
                const std::optional<PosePrior>& prior, const RefineConfig& config);

/// The peak of a posterior with its covariance, where mean and variance along the least certain
/// direction of the position (with what it is correlated with) are replaced by those of the
/// posterior at `steps` poses to either side, half a standard deviation apart. Where a scan says
/// nothing about a direction, as along a corridor, the peak is one of its noise.
PoseMoments average_along_ridge(const std::function<double(const SE2&)>& log_posterior,
                                const PoseMoments& peak, int steps);

/// Information (inverse covariance) about the pose from the scan alone: the negative curvature of
/// the log-likelihood by central differences, with negative eigenvalues set to 0.
Eigen::Matrix3d scan_information(const EndpointModel& model, const ScanPoints& points,
                                 const SE2& T_map_base);

}  // namespace castaway::localization
