#include "tools/twin/odometry/drive_fit.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace castaway::testbed {
namespace {

/// Weight of a residual by Huber's function.
double huber(double normalized) {
  constexpr double kBend = 2.0;
  return std::min(1.0, kBend / std::max(std::abs(normalized), 1e-9));
}

constexpr int kUnknowns = 6;
/// scale, yaw_scale, curvature, and x, y, yaw of T_base_drive
using Parameters = Eigen::Matrix<double, kUnknowns, 1>;

DriveErrors to_errors(const Parameters& p, double track) {
  return {errors_of(p(0), p(1), p(2), track), {p(3), p(4), p(5)}};
}

using Jacobian = Eigen::Matrix<double, 3, kUnknowns>;

Eigen::Vector3d residual_of(const Stretch& stretch, const Parameters& p, double track) {
  const SE2 miss = miss_of(stretch, to_errors(p, track));
  return {miss.x, miss.y, miss.yaw};
}

Jacobian jacobian_of(const Stretch& stretch, const Parameters& p, double track) {
  constexpr double kStep = 1e-5;
  const Eigen::Vector3d r = residual_of(stretch, p, track);
  Jacobian J;
  for (int k = 0; k < kUnknowns; ++k) {
    J.col(k) = (residual_of(stretch, p + kStep * Parameters::Unit(k), track) - r) / kStep;
  }
  return J;
}

/// The stretch without the random errors of its odometry, as far as its residual tells them: the
/// rest of the residual is the alignment's.
Stretch without_noise(Stretch stretch, const Eigen::Vector3d& residual, OdometryNoise noise) {
  const Eigen::Vector3d all = noise.variances(stretch);
  noise.match = noise.match_yaw = noise.stamp = 0.0;
  const Eigen::Vector3d by_odometry = noise.variances(stretch).cwiseQuotient(all);
  const Eigen::Vector3d error = residual.cwiseProduct(by_odometry);
  double driven = 0.0;
  for (const OdometryStep& step : stretch.steps) driven += std::abs(step.along);
  for (OdometryStep& step : stretch.steps) {
    step.along -= error.x() * std::abs(step.along) / std::max(driven, 1e-9);
    step.turn -= error.z() * std::abs(step.turn) / std::max(stretch.turn, 1e-9);
  }
  return stretch;
}

/// One Gauss-Newton step of the weighted least squares. The measured motion has its noise in common
/// with the residuals, which would bias them: motion without that noise serves as instrument
/// (P. G. Wright, "The Tariff on Animal and Vegetable Oils", 1928, appendix B), in those directions
/// only that the data tell and not the usual errors.
Parameters improve(const std::vector<const std::vector<Stretch>*>& sets, const OdometryNoise& noise,
                   const Parameters& p, double track) {
  /// Size of usual errors, for paths that cannot tell them apart.
  const Parameters usual = (Parameters() << 0.1, 0.1, 0.1, 0.2, 0.2, 0.1).finished();
  using Square = Eigen::Matrix<double, kUnknowns, kUnknowns>;
  const Square prior = usual.array().square().inverse().matrix().asDiagonal();
  Square H = Square::Zero();
  Parameters g = prior * p;
  Parameters unbias = Parameters::Zero();
  for (const auto* stretches : sets) {
    for (const Stretch& s : *stretches) {
      const Eigen::Vector3d r = residual_of(s, p, track);
      const Jacobian J = jacobian_of(s, p, track);
      const Jacobian Z = jacobian_of(without_noise(s, r, noise), p, track);
      const Eigen::Vector3d sigma = noise.variances(s).cwiseSqrt();
      for (int row = 0; row < 3; ++row) {
        const double weight = huber(r(row) / sigma(row)) / (sigma(row) * sigma(row));
        H += weight * J.row(row).transpose() * J.row(row);
        g += weight * J.row(row).transpose() * r(row);
        unbias += weight * (Z - J).row(row).transpose() * r(row);
      }
    }
  }
  const Eigen::LDLT<Square> solver(H + prior);
  return p - solver.solve(g + H * solver.solve(unbias));
}

}  // namespace

DriveFit fit_drive(const Stretches& stretches, double track, YawWalk walk) {
  constexpr int kRounds = 6;
  DriveFit fit;
  Parameters parameters = Parameters::Zero();
  for (int round = 0; round < kRounds; ++round) {
    parameters = improve({&stretches.brief, &stretches.far}, fit.noise, parameters, track);
    fit.errors = to_errors(parameters, track);
    fit.noise = fit_noise({&stretches.brief, &stretches.far}, fit.errors, fit.noise, walk);
  }
  return fit;
}

}  // namespace castaway::testbed
