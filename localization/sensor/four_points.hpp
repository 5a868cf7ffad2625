/// Points of scans, four at a time.
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "localization/geometry/four_floats.hpp"
#include "localization/sensor/scan_points.hpp"

namespace castaway::localization {

/// The points with these coordinates from the `first` on; zeros behind the last one.
[[gnu::always_inline]] inline FourPoints four_points(const std::vector<float>& x,
                                                     const std::vector<float>& y,
                                                     const std::vector<float>& z,
                                                     std::size_t first) {
  const std::size_t count = x.size() - first;
  if (count >= 4) return {load_four(&x[first]), load_four(&y[first]), load_four(&z[first])};
  return {load_some(&x[first], count), load_some(&y[first], count), load_some(&z[first], count)};
}

/// End points of a scan, and where its beams begin.
[[gnu::always_inline]] inline FourPoints four_ends(const ScanPoints& points, std::size_t first) {
  return four_points(points.x, points.y, points.z, first);
}
[[gnu::always_inline]] inline FourPoints four_origins(const ScanPoints& points, std::size_t first) {
  return four_points(points.origin_x, points.origin_y, points.origin_z, first);
}

/// `R p + t`; each to the bit that of one point.
[[gnu::always_inline]] inline FourPoints transform(const Eigen::Matrix3f& R,
                                                   const Eigen::Vector3f& t, const FourPoints& p) {
  const auto row = [&](int i) { return R(i, 0) * p.x + (R(i, 1) * p.y + R(i, 2) * p.z) + t(i); };
  return {row(0), row(1), row(2)};
}

}  // namespace castaway::localization
