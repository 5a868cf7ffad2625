#include "localization/space/ndt/ndt_scan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

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

}  // namespace castaway::localization
