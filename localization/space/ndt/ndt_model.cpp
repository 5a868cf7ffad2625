#include "localization/space/ndt/ndt_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/LU>

namespace castaway::localization {
namespace {

/// The distribution nearest to a part of a scan.
struct Nearest {
  float mahalanobis2 = std::numeric_limits<float>::infinity();
  Eigen::Vector3f from_mean = Eigen::Vector3f::Zero();    // [m]
  Eigen::Matrix3f information = Eigen::Matrix3f::Zero();  // [1/m^2]
};

/// Of a point.
Nearest nearest_to_point(const NdtMap& map, const Eigen::Vector3f& p_map, float variance) {
  Nearest nearest;
  const NormalDistribution* best = nullptr;
  map.for_each_near(p_map, [&](const NormalDistribution& d) {
    const Eigen::Vector3f along = d.axes.transpose() * (p_map - d.mean);
    const float m2 = (along.array().square() / (d.variances.array() + variance)).sum();
    if (m2 >= nearest.mahalanobis2) return;
    nearest.mahalanobis2 = m2;
    best = &d;
  });
  if (best == nullptr) return nearest;
  nearest.from_mean = p_map - best->mean;
  const Eigen::Vector3f weights = (best->variances.array() + variance).inverse();
  nearest.information = best->axes * weights.asDiagonal() * best->axes.transpose();
  return nearest;
}

/// Of a distribution with its covariance in map, to which the sensor's variance was added.
Nearest nearest_to_distribution(const NdtMap& map, const Eigen::Vector3f& p_map,
                                const Eigen::Matrix3f& covariance) {
  Nearest nearest;
  map.for_each_near(p_map, [&](const NormalDistribution& d) {
    const Eigen::Matrix3f information = (d.covariance() + covariance).inverse();
    const Eigen::Vector3f from_mean = p_map - d.mean;
    const float m2 = from_mean.dot(information * from_mean);
    if (m2 < nearest.mahalanobis2) nearest = {m2, from_mean, information};
  });
  return nearest;
}

}  // namespace

NdtModel::NdtModel(const EndpointConfig& config, const NdtMap& map, const Volume* volume)
    : config_((validate(config), config)), map_(map), volume_(volume) {}

std::optional<NdtModel::Stance> NdtModel::stand(const SE2& T_map_base) const {
  Stance stance;
  stance.along_x = Eigen::Vector3f::UnitX();
  stance.along_y = Eigen::Vector3f::UnitY();
  Eigen::Isometry3d T = to_se3(T_map_base);
  if (volume_ != nullptr) {
    const auto base = volume_->lift(T_map_base);
    const auto ground = volume_->atlas().to_map(T_map_base);
    if (!base || !ground) return std::nullopt;
    T = base->T_map_base;
    const auto yaw_grid = static_cast<float>(volume_->atlas().ground().frame.T_map_grid.yaw);
    const Eigen::Vector2f slope_grid(ground->surface->slope_x, ground->surface->slope_y);
    const Eigen::Vector2f slope = Eigen::Rotation2Df(yaw_grid) * slope_grid;
    stance.along_x.z() = slope.x();
    stance.along_y.z() = slope.y();
  }
  stance.R = T.linear().cast<float>();
  stance.t = T.translation().cast<float>();
  stance.axis = stance.R.col(2);
  return stance;
}

void NdtModel::add(const Stance& stance, const NdtScanPart& part, bool is_point,
                   NdtFit& sum) const {
  const auto variance = static_cast<float>(config_.sigma * config_.sigma);
  const Eigen::Vector3f from_base = stance.R * part.p_base;
  const Eigen::Vector3f p_map = from_base + stance.t;
  const Nearest nearest =
      is_point ? nearest_to_point(map_, p_map, variance)
               : nearest_to_distribution(map_, p_map,
                                         stance.R * part.covariance * stance.R.transpose() +
                                             variance * Eigen::Matrix3f::Identity());
  const double hit = std::exp(-0.5 * static_cast<double>(nearest.mahalanobis2));
  const auto points = static_cast<double>(part.points);
  sum.log_likelihood += points * (std::log(hit + config_.floor) - std::log1p(config_.floor));
  Eigen::Matrix3f J;
  J << stance.along_x, stance.along_y, stance.axis.cross(from_base);
  const double weight = points * hit / (hit + config_.floor);
  sum.gradient -= weight * (J.transpose() * nearest.information * nearest.from_mean).cast<double>();
  sum.information += weight * (J.transpose() * nearest.information * J).cast<double>();
}

NdtFit NdtModel::fit(const NdtScan& scan, const SE2& T_map_base) const {
  NdtFit sum;
  if (scan.parts.empty()) return sum;
  const auto stance = stand(T_map_base);
  if (!stance) {
    sum.log_likelihood = config_.independent_beams * endpoint_log_likelihood(config_, 1e3);
    return sum;
  }
  double points = 0.0;
  for (const NdtScanPart& part : scan.parts) {
    points += static_cast<double>(part.points);
    add(*stance, part, scan.points, sum);
  }
  const double scale = config_.independent_beams / points;
  sum.log_likelihood *= scale;
  sum.gradient *= scale;
  sum.information *= scale;
  return sum;
}

}  // namespace castaway::localization
