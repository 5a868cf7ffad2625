#include "localization/matching/refine.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Eigenvalues>

namespace castaway::localization {
namespace {

/// Steps along the axes of base in both directions: forward, left, turn.
std::array<Eigen::Vector3d, 6> steps(double yaw, double step_m, double step_rad) {
  const double c = step_m * std::cos(yaw);
  const double s = step_m * std::sin(yaw);
  return {Eigen::Vector3d{c, s, 0.0},          Eigen::Vector3d{-c, -s, 0.0},
          Eigen::Vector3d{-s, c, 0.0},         Eigen::Vector3d{s, -c, 0.0},
          Eigen::Vector3d{0.0, 0.0, step_rad}, Eigen::Vector3d{0.0, 0.0, -step_rad}};
}

/// A pose and its score.
struct ScoredPose {
  SE2 pose;
  double score = 0.0;
};

using Score = std::function<double(const SE2&)>;

/// Takes every step that improves the score; false if none did.
bool climb(const Score& score, double step_m, double step_rad, ScoredPose& best) {
  bool risen = false;
  for (const auto& step : steps(best.pose.yaw, step_m, step_rad)) {
    const SE2 pose = offset(best.pose, step);
    const double value = score(pose);
    if (value <= best.score) continue;
    best = {pose, value};
    risen = true;
  }
  return risen;
}

}  // namespace

PosePrior make_prior(const PoseMoments& belief) {
  const Eigen::Matrix3d slack = Eigen::Vector3d(1e-6, 1e-6, 1e-7).asDiagonal();
  return {belief.mean, (belief.covariance + slack).inverse()};
}

double log_prior(const PosePrior& prior, const SE2& pose) {
  const Eigen::Vector3d d = difference(pose, prior.mean);
  return -0.5 * d.dot(prior.information * d);
}

SE2 refine_pose(const EndpointModel& model, const ScanPoints& points, const SE2& start,
                const std::optional<PosePrior>& prior, const RefineConfig& config) {
  constexpr int kMovesPerLevel = 8;
  const Score score = [&](const SE2& pose) {
    return model.log_likelihood(points, pose) + (prior ? log_prior(*prior, pose) : 0.0);
  };
  ScoredPose best{start, score(start)};
  double scale = 1.0;
  for (int level = 0; level <= config.halvings; ++level, scale *= 0.5) {
    int moves = 0;
    while (moves++ < kMovesPerLevel &&
           climb(score, scale * config.step_m, scale * config.step_rad, best)) {
    }
  }
  return best.pose;
}

PoseMoments average_along_ridge(const std::function<double(const SE2&)>& log_posterior,
                                const PoseMoments& peak, int steps) {
  constexpr double kStep = 0.5;      // [standard deviations]
  constexpr double kLeast = 0.0625;  // [variances] Less cannot be told with such steps.
  const Eigen::Matrix3d& covariance = peak.covariance;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> position(
      Eigen::Matrix2d(covariance.topLeftCorner<2, 2>()));
  const double variance = position.eigenvalues()[1];
  if (!(variance > 0.0)) return peak;
  const Eigen::Vector3d ridge =
      covariance.leftCols<2>() * position.eigenvectors().col(1) / std::sqrt(variance);
  std::vector<double> scores;
  for (int i = -steps; i <= steps; ++i) {
    scores.push_back(log_posterior(offset(peak.mean, kStep * i * ridge)));
  }
  const double most = *std::max_element(scores.begin(), scores.end());
  double sum = 0.0;
  double first = 0.0;
  double second = 0.0;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    const double t = kStep * (static_cast<double>(i) - steps);
    const double weight = std::exp(scores[i] - most);
    sum += weight;
    first += weight * t;
    second += weight * t * t;
  }
  const double mean = first / sum;
  const double spread = std::max(second / sum - mean * mean, kLeast);
  return {offset(peak.mean, mean * ridge), covariance + (spread - 1.0) * ridge * ridge.transpose()};
}

Eigen::Matrix3d scan_information(const EndpointModel& model, const ScanPoints& points,
                                 const SE2& T_map_base) {
  const Eigen::Vector3d h(model.frame().resolution, model.frame().resolution, 0.02);
  const auto f = [&](const Eigen::Vector3d& d) {
    return model.log_likelihood(points, offset(T_map_base, d));
  };
  const double centre = f(Eigen::Vector3d::Zero());
  Eigen::Matrix3d H;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Eigen::Vector3d a = h[i] * Eigen::Vector3d::Unit(i);
    H(i, i) = (f(a) - 2.0 * centre + f(-a)) / (h[i] * h[i]);
    for (Eigen::Index j = 0; j < i; ++j) {
      const Eigen::Vector3d b = h[j] * Eigen::Vector3d::Unit(j);
      H(i, j) = (f(a + b) - f(a - b) - f(b - a) + f(-a - b)) / (4.0 * h[i] * h[j]);
      H(j, i) = H(i, j);
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(-H);
  const Eigen::Vector3d values = solver.eigenvalues().cwiseMax(0.0);
  return solver.eigenvectors() * values.asDiagonal() * solver.eigenvectors().transpose();
}

}  // namespace castaway::localization
