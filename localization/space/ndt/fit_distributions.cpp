#include "localization/space/ndt/fit_distributions.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Eigenvalues>

namespace castaway::localization {
namespace {

constexpr float kTall = 1.0F;        // [m^2] Variance of a planar map's walls in z.
constexpr std::size_t kLeast = 3;    // Points of a part.
constexpr int kMostSplits = 3;       // One after the other.
constexpr float kThin = 0.6F;        // [spacings] Standard deviation of points on one plane.
constexpr float kWorthwhile = 0.5F;  // Thickness of the parts relative to the whole.

/// Least variance: of rounding to the spacing.
float rounding(const FitConfig& config) {
  return static_cast<float>(config.spacing * config.spacing / 12.0);
}

/// A plane that divides points: those ahead of it come second.
struct Cut {
  Eigen::Vector3f axis;
  float at = 0.0F;
  float thickness = 0.0F;  ///< [m^2] Of both parts: the smallest variance times the points.

  [[nodiscard]] bool is_ahead(const Eigen::Vector3f& p) const { return axis.dot(p) > at; }
};

using Points = std::span<Eigen::Vector3f>;

std::pair<Points, Points> divide(Points points, const Cut& cut) {
  const auto middle = std::stable_partition(
      points.begin(), points.end(), [&](const Eigen::Vector3f& p) { return !cut.is_ahead(p); });
  const auto count = static_cast<std::size_t>(middle - points.begin());
  return {points.first(count), points.subspan(count)};
}

float thickness(Points points, const FitConfig& config) {
  return static_cast<float>(points.size()) * fit_distribution(points, config).variances[0];
}

/// The cut across a principal axis whose parts are the thinnest; nothing if none is worthwhile.
std::optional<Cut> best_cut(Points points, const NormalDistribution& whole,
                            const FitConfig& config) {
  std::optional<Cut> best;
  float least = kWorthwhile * static_cast<float>(points.size()) * whole.variances[0];
  for (int k = 0; k < 3; ++k) {
    Cut cut{whole.axes.col(k), whole.axes.col(k).dot(whole.mean)};
    const auto [behind, ahead] = divide(points, cut);
    if (behind.size() < kLeast || ahead.size() < kLeast) continue;
    cut.thickness = thickness(behind, config) + thickness(ahead, config);
    if (cut.thickness >= least) continue;
    least = cut.thickness;
    best = cut;
  }
  return best;
}

void fit_parts(Points points, const FitConfig& config, int splits, std::vector<FittedCell>& parts) {
  NormalDistribution whole = fit_distribution(points, config);
  const float thin = kThin * static_cast<float>(config.spacing);
  if (whole.variances[0] > thin * thin && splits < kMostSplits) {
    if (const auto cut = best_cut(points, whole, config)) {
      const auto [behind, ahead] = divide(points, *cut);
      fit_parts(behind, config, splits + 1, parts);
      fit_parts(ahead, config, splits + 1, parts);
      return;
    }
  }
  const auto along = static_cast<float>(config.along);
  whole.variances.tail<2>() *= along * along;
  parts.push_back({whole, static_cast<float>(points.size())});
}

}  // namespace

NormalDistribution fit_distribution(std::span<const Eigen::Vector3f> points,
                                    const FitConfig& config) {
  assert(!points.empty());
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  for (const Eigen::Vector3f& p : points) mean += p;
  mean /= static_cast<float>(points.size());
  Eigen::Matrix3f covariance = rounding(config) * Eigen::Matrix3f::Identity();
  for (const Eigen::Vector3f& p : points) {
    covariance += (p - mean) * (p - mean).transpose() / static_cast<float>(points.size());
  }
  if (config.planar) covariance(2, 2) = kTall;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver(covariance);
  return {mean, solver.eigenvectors(), solver.eigenvalues()};
}

std::vector<FittedCell> fit_cell(std::span<Eigen::Vector3f> points, const FitConfig& config) {
  std::vector<FittedCell> parts;
  fit_parts(points, config, 0, parts);
  return parts;
}

}  // namespace castaway::localization
