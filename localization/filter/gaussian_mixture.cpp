#include "localization/filter/gaussian_mixture.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <stdexcept>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "localization/filter/particle_set.hpp"
#include "localization/motion/odometry_noise.hpp"

namespace castaway::localization {
namespace {

/// Root of a covariance with its columns along the principal axes, ascending.
Eigen::Matrix3d principal_root(const Eigen::Matrix3d& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
}

/// The standard deviation along the principal axis that is the widest relative to the settings;
/// nothing if none is too wide.
std::optional<Eigen::Vector3d> too_wide(const MixtureConfig& config, const PoseMoments& pose) {
  const Eigen::Vector3d limits(config.widest, config.widest, config.widest_yaw);
  const Eigen::Matrix3d scaled =
      limits.cwiseInverse().asDiagonal() * pose.covariance * limits.cwiseInverse().asDiagonal();
  const Eigen::Vector3d axis = principal_root(scaled).col(2);
  if (axis.norm() <= 1.0) return std::nullopt;
  return limits.asDiagonal() * axis;
}

/// Three components with the same moments together, apart along `sigma`: one standard deviation of
/// the one that they replace.
std::array<GaussianComponent, 3> divide(const GaussianComponent& wide,
                                        const Eigen::Vector3d& sigma) {
  constexpr double kApart = 1.2;  // [standard deviations]
  constexpr double kSide = 0.25;  // Weight of each outer one.
  const Eigen::Matrix3d rest =
      wide.pose.covariance - 2.0 * kSide * kApart * kApart * sigma * sigma.transpose();
  const auto component = [&](double shift, double weight) {
    return GaussianComponent{{offset(wide.pose.mean, shift * sigma), rest},
                             wide.log_weight + std::log(weight)};
  };
  return {component(-kApart, kSide), component(0.0, 1.0 - 2.0 * kSide), component(kApart, kSide)};
}

double mahalanobis2(const PoseMoments& from, const SE2& to) {
  const Eigen::Vector3d d = difference(to, from.mean);
  return d.dot(from.covariance.ldlt().solve(d));
}

double cdf(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

/// Probability of an interval about 0 of half width `half`, for N(mean, sigma).
double probability_within(double half, double mean, double sigma) {
  const double s = std::max(sigma, 1e-9);
  return cdf((half - mean) / s) - cdf((-half - mean) / s);
}

/// Probability of a disc about 0, for a normal distribution with independent parts: the midpoint
/// rule over chords across the first axis, within five standard deviations.
double probability_of_disc(double radius, const Eigen::Vector2d& mean,
                           const Eigen::Vector2d& sigma) {
  constexpr int kChords = 32;
  constexpr double kFar = 5.0;
  const double s = std::max(sigma.x(), 1e-9);
  const double low = std::max(-radius, mean.x() - kFar * s);
  const double high = std::min(radius, mean.x() + kFar * s);
  if (low >= high) return 0.0;
  const double width = (high - low) / kChords;
  double sum = 0.0;
  for (int k = 0; k < kChords; ++k) {
    const double from = low + k * width;
    const double at = from + 0.5 * width;
    const double chord = std::sqrt(std::max(radius * radius - at * at, 0.0));
    sum += (cdf((from + width - mean.x()) / s) - cdf((from - mean.x()) / s)) *
           probability_within(chord, mean.y(), sigma.y());
  }
  return sum;
}

double probability_near(const PoseMoments& pose, const SE2& T_map_base, double radius, double yaw) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(
      Eigen::Matrix2d(pose.covariance.topLeftCorner<2, 2>()));
  const Eigen::Vector3d d = difference(pose.mean, T_map_base);
  const Eigen::Vector2d mean = solver.eigenvectors().transpose() * d.head<2>();
  const Eigen::Vector2d sigma = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  return probability_of_disc(radius, mean, sigma) *
         probability_within(yaw, d[2], std::sqrt(std::max(pose.covariance(2, 2), 0.0)));
}

}  // namespace

void validate(const MixtureConfig& config) {
  if (!(config.widest > 0.0 && config.widest_yaw > 0.0)) {
    throw std::invalid_argument("mixture widest and widest_yaw must be positive");
  }
  if (config.most < 1) throw std::invalid_argument("mixture most must be at least 1");
}

GaussianMixture make_mixture(const MixtureConfig& config, const PoseMoments& gaussian) {
  GaussianMixture mixture{{{gaussian, 0.0}}};
  std::vector<GaussianComponent>& all = mixture.components;
  for (std::size_t i = 0; i < all.size();) {
    const bool room = all.size() + 2 <= static_cast<std::size_t>(config.most);
    const auto sigma = room ? too_wide(config, all[i].pose) : std::nullopt;
    if (!sigma) {
      ++i;
      continue;
    }
    const auto parts = divide(all[i], *sigma);
    all[i] = parts[1];
    all.push_back(parts[0]);
    all.push_back(parts[2]);
  }
  return mixture;
}

void predict(GaussianMixture& mixture, const SE2& u, const Eigen::Matrix3d& covariance_base) {
  for (GaussianComponent& component : mixture.components) {
    PoseMoments& pose = component.pose;
    const Eigen::Vector2d way = Eigen::Rotation2Dd(pose.mean.yaw) * Eigen::Vector2d(u.x, u.y);
    Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
    F(0, 2) = -way.y();
    F(1, 2) = way.x();
    pose.covariance =
        F * pose.covariance * F.transpose() + rotate_to_map(covariance_base, pose.mean.yaw);
    pose.mean = pose.mean * u;
  }
}

std::vector<double> normalized_weights(const GaussianMixture& mixture) {
  std::vector<double> log_weights;
  for (const GaussianComponent& c : mixture.components) log_weights.push_back(c.log_weight);
  return normalized_weights(log_weights);
}

PoseMoments moments(const GaussianMixture& mixture) {
  assert(!mixture.empty());
  if (mixture.components.size() == 1) return mixture.components.front().pose;
  const std::vector<double> weights = normalized_weights(mixture);
  std::vector<SE2> means;
  for (const GaussianComponent& c : mixture.components) means.push_back(c.pose.mean);
  PoseMoments whole = pose_moments(means, weights);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    whole.covariance += weights[i] * mixture.components[i].pose.covariance;
  }
  return whole;
}

void reduce(GaussianMixture& mixture, const MixtureConfig& config) {
  const std::vector<double> weights = normalized_weights(mixture);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    mixture.components[i].log_weight = std::log(std::max(weights[i], 1e-300));
  }
  std::stable_sort(mixture.components.begin(), mixture.components.end(),
                   [](const auto& a, const auto& b) { return a.log_weight > b.log_weight; });
  std::vector<GaussianComponent> kept;
  for (const GaussianComponent& c : mixture.components) {
    if (!kept.empty() && c.log_weight < std::log(config.lightest)) break;
    const auto same = std::find_if(kept.begin(), kept.end(), [&](const GaussianComponent& other) {
      return mahalanobis2(other.pose, c.pose.mean) < config.same * config.same;
    });
    if (same != kept.end()) {
      const double weight = std::exp(same->log_weight) + std::exp(c.log_weight);
      same->pose = moments({{*same, c}});
      same->log_weight = std::log(weight);
    } else if (kept.size() < static_cast<std::size_t>(config.most)) {
      kept.push_back(c);
    }
  }
  mixture.components = std::move(kept);
}

double probability_near(const GaussianMixture& mixture, const SE2& T_map_base, double distance,
                        double yaw) {
  const std::vector<double> weights = normalized_weights(mixture);
  double sum = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    sum += weights[i] * probability_near(mixture.components[i].pose, T_map_base, distance, yaw);
  }
  return sum;
}

std::vector<SE2> sigma_points(const GaussianMixture& mixture) {
  std::vector<SE2> poses;
  for (const GaussianComponent& c : mixture.components) {
    const Eigen::Matrix3d root = principal_root(c.pose.covariance);
    poses.push_back(c.pose.mean);
    for (Eigen::Index k = 0; k < 3; ++k) {
      poses.push_back(offset(c.pose.mean, root.col(k)));
      poses.push_back(offset(c.pose.mean, -root.col(k)));
    }
  }
  return poses;
}

}  // namespace castaway::localization
