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

Eigen::Vector3d residual_of(const Stretch& stretch, const Parameters& p, double track) {
  const SE2 miss = miss_of(stretch, to_errors(p, track));
  return {miss.x, miss.y, miss.yaw};
}

/// One Gauss-Newton step of the weighted least squares.
Parameters improve(const std::vector<Stretch>& stretches, const OdometryNoise& noise,
                   const Parameters& p, double track) {
  constexpr double kStep = 1e-5;
  /// Size of usual errors, for paths that cannot tell them apart.
  const Parameters usual = (Parameters() << 0.1, 0.1, 0.1, 0.2, 0.2, 0.1).finished();
  using Square = Eigen::Matrix<double, kUnknowns, kUnknowns>;
  Square H = usual.array().square().inverse().matrix().asDiagonal();
  Parameters g = H * p;
  for (const Stretch& s : stretches) {
    const Eigen::Vector3d r = residual_of(s, p, track);
    Eigen::Matrix<double, 3, kUnknowns> J;
    for (int k = 0; k < kUnknowns; ++k) {
      J.col(k) = (residual_of(s, p + kStep * Parameters::Unit(k), track) - r) / kStep;
    }
    const Eigen::Vector3d sigma = noise.variances(s).cwiseSqrt();
    for (int row = 0; row < 3; ++row) {
      const double weight = huber(r(row) / sigma(row)) / (sigma(row) * sigma(row));
      H += weight * J.row(row).transpose() * J.row(row);
      g += weight * J.row(row).transpose() * r(row);
    }
  }
  return p - H.ldlt().solve(g);
}

}  // namespace

DriveFit fit_drive(const Stretches& stretches, double track, YawWalk walk) {
  constexpr int kRounds = 6;
  DriveFit fit;
  Parameters parameters = Parameters::Zero();
  for (int round = 0; round < kRounds; ++round) {
    parameters = improve(stretches.far, fit.noise, parameters, track);
    fit.errors = to_errors(parameters, track);
    fit.noise = fit_noise({&stretches.brief, &stretches.far}, fit.errors, fit.noise, walk);
  }
  return fit;
}

}  // namespace castaway::testbed
