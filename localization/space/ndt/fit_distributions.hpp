/// Fits normal distributions to points.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace castaway::localization {

/// A normal distribution of points in space.
struct NormalDistribution {
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();       ///< [m]
  Eigen::Matrix3f axes = Eigen::Matrix3f::Identity();   ///< Columns: principal axes, of length 1.
  Eigen::Vector3f variances = Eigen::Vector3f::Zero();  ///< [m^2] Along these; ascending.

  [[nodiscard]] Eigen::Matrix3f covariance() const {
    return axes * variances.asDiagonal() * axes.transpose();
  }
};

/// How points are fitted.
struct FitConfig {
  double spacing = 0.05;  ///< [m] Of the points. No distribution is thinner than rounding to it.
  double along = 2.0;     ///< Factor of the standard deviations along a surface.
  bool planar = false;    ///< Points with z = 0 stand for walls without end in z.
};

/// The distribution of at least one point, as it is: `along` does not count.
NormalDistribution fit_distribution(std::span<const Eigen::Vector3f> points,
                                    const FitConfig& config);

/// A distribution, and how many points it was fitted to.
struct FittedCell {
  NormalDistribution distribution;
  float points = 0.0F;
};

/// The distributions of a cell's points (at least one), which are reordered. Points that are not on
/// one plane are split where their parts are nearest to planes.
std::vector<FittedCell> fit_cell(std::span<Eigen::Vector3f> points, const FitConfig& config);

}  // namespace castaway::localization
