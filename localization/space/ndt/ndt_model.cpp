#include "localization/space/ndt/ndt_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include <Eigen/LU>

#include "localization/space/ndt/fit_distributions.hpp"

namespace castaway::localization {
namespace {

constexpr double kSpacing = 0.04;  // [m] Noise of a lidar: no part is thinner.

Eigen::Vector3f point(const ScanPoints& points, std::size_t i, bool planar) {
  return {points.x[i], points.y[i], planar ? 0.0F : points.z[i]};
}

using Cell = std::array<int, 3>;

Cell cell_of(const Eigen::Vector3f& p, double edge) {
  const auto index = [&](float v) {
    return static_cast<int>(std::floor(static_cast<double>(v) / edge));
  };
  return {index(p.x()), index(p.y()), index(p.z())};
}

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

NdtScan scan_of_points(const ScanPoints& points, bool planar) {
  NdtScan scan;
  scan.parts.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) scan.parts[i].p_base = point(points, i, planar);
  return scan;
}

NdtScan scan_of_distributions(const ScanPoints& points, double cell, bool planar) {
  std::vector<std::pair<Cell, Eigen::Vector3f>> sorted;
  sorted.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f p = point(points, i, planar);
    sorted.emplace_back(cell_of(p, cell), p);
  }
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  NdtScan scan;
  scan.points = false;
  std::vector<Eigen::Vector3f> members;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    members.push_back(sorted[i].second);
    if (i + 1 < sorted.size() && sorted[i + 1].first == sorted[i].first) continue;
    for (const FittedCell& part : fit_cell(members, {kSpacing, 1.0, false})) {
      scan.parts.push_back({part.distribution.mean, part.distribution.covariance(), part.points});
    }
    members.clear();
  }
  return scan;
}

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
