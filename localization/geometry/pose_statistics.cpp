#include "localization/geometry/pose_statistics.hpp"

#include <cassert>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <boost/random/normal_distribution.hpp>

namespace castaway::localization {

Eigen::Vector3d difference(const SE2& a, const SE2& b) {
  return {a.x - b.x, a.y - b.y, wrap_angle(a.yaw - b.yaw)};
}

SE2 offset(const SE2& pose, const Eigen::Vector3d& difference) {
  return {pose.x + difference[0], pose.y + difference[1], wrap_angle(pose.yaw + difference[2])};
}

PoseMoments pose_moments(std::span<const SE2> poses, std::span<const double> weights) {
  assert(poses.size() == weights.size());
  double sum = 0.0;
  Eigen::Vector4d mean = Eigen::Vector4d::Zero();  // x, y, cos, sin
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const SE2& p = poses[i];
    mean += weights[i] * Eigen::Vector4d(p.x, p.y, std::cos(p.yaw), std::sin(p.yaw));
    sum += weights[i];
  }
  mean /= sum;
  PoseMoments moments{{mean[0], mean[1], std::atan2(mean[3], mean[2])}, Eigen::Matrix3d::Zero()};
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const SE2& p = poses[i];
    const Eigen::Vector3d d(p.x - mean[0], p.y - mean[1], wrap_angle(p.yaw - moments.mean.yaw));
    moments.covariance += weights[i] / sum * d * d.transpose();
  }
  return moments;
}

PoseGaussian::PoseGaussian(const SE2& mean, const Eigen::Matrix3d& covariance) : mean_(mean) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Eigen::Vector3d sigma = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  root_ = solver.eigenvectors() * sigma.asDiagonal();
}

SE2 PoseGaussian::sample(Rng& rng) const {
  boost::random::normal_distribution<double> normal;
  Eigen::Vector3d n;
  for (Eigen::Index i = 0; i < 3; ++i) n[i] = normal(rng);
  const Eigen::Vector3d d = root_ * n;
  return {mean_.x + d[0], mean_.y + d[1], wrap_angle(mean_.yaw + d[2])};
}

}  // namespace castaway::localization
