#include "localization/space/stack/slope_classes.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace castaway::localization {
namespace {

constexpr double kLevel = 0.02;
constexpr double kSteepnessStep = 0.06;  // Of steepness.
constexpr int kDirections = 16;

/// Steepness and direction in steps; (0, 0) for level ground.
std::pair<int, int> bin_of(const GroundSurface& surface) {
  const double x = surface.slope_x;
  const double y = surface.slope_y;
  const double steepness = std::hypot(x, y);
  if (!(steepness >= kLevel)) return {0, 0};
  const double turns = std::atan2(y, x) / (2.0 * std::numbers::pi);
  const auto direction = static_cast<int>(std::lround(kDirections * turns));
  return {1 + static_cast<int>((steepness - kLevel) / kSteepnessStep),
          (direction + kDirections) % kDirections};
}

/// Surfaces of one bin.
struct Bin {
  std::uint16_t number = 0;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double count = 0.0;
};

}  // namespace

SlopeClasses sort_by_slope(const ElevationMap& ground) {
  std::map<std::pair<int, int>, Bin> bins{{{0, 0}, {}}};
  SlopeClasses classes;
  classes.of_surface.assign(ground.surfaces.size(), 0);
  for (std::size_t i = 0; i < ground.surfaces.size(); ++i) {
    const GroundSurface& surface = ground.surfaces[i];
    if (!surface.drivable) continue;
    const auto next = static_cast<std::uint16_t>(bins.size());
    Bin& bin = bins.try_emplace(bin_of(surface), Bin{next}).first->second;
    bin.sum += Eigen::Vector2f(surface.slope_x, surface.slope_y).cast<double>();
    bin.count += 1.0;
    classes.of_surface[i] = bin.number;
  }
  classes.slopes.assign(bins.size(), Eigen::Vector2d::Zero());
  for (const auto& [key, bin] : bins) {
    if (bin.number > 0) classes.slopes[bin.number] = bin.sum / bin.count;
  }
  return classes;
}

Eigen::Matrix3d orientation_on(const Eigen::Vector2d& slope, double yaw) {
  const Eigen::Vector2d heading(std::cos(yaw), std::sin(yaw));
  Eigen::Matrix3d R_grid_base;
  R_grid_base.col(0) = Eigen::Vector3d(heading.x(), heading.y(), slope.dot(heading)).normalized();
  R_grid_base.col(2) = Eigen::Vector3d(-slope.x(), -slope.y(), 1.0).normalized();
  R_grid_base.col(1) = R_grid_base.col(2).cross(R_grid_base.col(0));
  return R_grid_base;
}

}  // namespace castaway::localization
