/// Moments of weighted planar poses, and sampling from a Gaussian over poses.
#pragma once

#include <span>

#include <Eigen/Core>

#include "localization/geometry/random.hpp"
#include "localization/geometry/se2.hpp"

namespace castaway::localization {

/// Mean and covariance of poses.
struct PoseMoments {
  SE2 mean;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< Of (x, y, yaw): m^2, m rad, rad^2.
};

/// x, y and yaw of `a` less those of `b`, the yaw wrapped: m, m, rad, along the axes of map.
Eigen::Vector3d difference(const SE2& a, const SE2& b);
/// The pose moved by such a difference.
SE2 offset(const SE2& pose, const Eigen::Vector3d& difference);

/// Weighted moments. The mean yaw is the direction of the mean heading, and deviations are wrapped.
/// `weights` are non-negative with a positive sum, as many as `poses`.
PoseMoments pose_moments(std::span<const SE2> poses, std::span<const double> weights);

/// Draws poses from N(mean, covariance). Conditioned once, sampled many times. A covariance that is
/// not positive semi-definite is replaced by the nearest one that is.
class PoseGaussian {
 public:
  PoseGaussian(const SE2& mean, const Eigen::Matrix3d& covariance);
  [[nodiscard]] SE2 sample(Rng& rng) const;

 private:
  SE2 mean_;
  Eigen::Matrix3d root_;  ///< root_ * root_^T = covariance
};

}  // namespace castaway::localization
