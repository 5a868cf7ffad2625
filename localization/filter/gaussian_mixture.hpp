/// A belief about the pose as a mixture of normal distributions: few numbers in place of many
/// particles.
///
/// D. L. Alspach, H. W. Sorenson, "Nonlinear Bayesian Estimation Using Gaussian Sum
/// Approximations", IEEE Transactions on Automatic Control 17 (1972).
#pragma once

#include <vector>

#include "localization/geometry/pose_statistics.hpp"

namespace castaway::localization {

/// One normal distribution.
struct GaussianComponent {
  PoseMoments pose;
  double log_weight = 0.0;  ///< [nats] Not normalised.
};

/// Components about poses that a linear model holds for; empty: no belief.
struct GaussianMixture {
  std::vector<GaussianComponent> components;

  [[nodiscard]] bool empty() const { return components.empty(); }
};

/// Sizes of a mixture.
struct MixtureConfig {
  /// [m] A component whose position has a larger standard deviation is divided in three.
  double widest = 0.25;
  double widest_yaw = 0.3;  ///< [rad] The same of its yaw.
  int most = 9;             ///< Components kept; the heaviest.
  double lightest = 1e-4;   ///< Components with a smaller share of the weight are dropped.
  double same = 1.0;        ///< Components with a smaller Mahalanobis distance become one.
};

/// @throws std::invalid_argument if a value is out of range.
void validate(const MixtureConfig& config);

/// Mixture with the moments of a normal distribution, with no component wider than the settings
/// allow, as far as their number does.
GaussianMixture make_mixture(const MixtureConfig& config, const PoseMoments& gaussian);

/// Moves all components by the odometry step `u`, whose noise has this covariance in the frame of
/// base before the step (paper, eq. 3 and 4, linearised).
void predict(GaussianMixture& mixture, const SE2& u, const Eigen::Matrix3d& covariance_base);

/// Weights that sum to 1.
std::vector<double> normalized_weights(const GaussianMixture& mixture);

/// Moments of the whole. Requires a component.
PoseMoments moments(const GaussianMixture& mixture);

/// Drops light components and joins those that are the same, heaviest first. Keeps the heaviest
/// one.
void reduce(GaussianMixture& mixture, const MixtureConfig& config);

/// Probability that the pose is within `distance` [m] and `yaw` [rad] of `T_map_base`; the yaw
/// counts as independent of the position.
double probability_near(const GaussianMixture& mixture, const SE2& T_map_base, double distance,
                        double yaw);

/// Seven poses for each component: its mean, and one standard deviation to both sides along its
/// principal axes. For pictures.
std::vector<SE2> sigma_points(const GaussianMixture& mixture);

}  // namespace castaway::localization
