/// Points of scans, four at a time.
#pragma once

#include <cstddef>

#include <Eigen/Core>

#include "localization/geometry/four_floats.hpp"
#include "localization/sensor/scan_points.hpp"

namespace castaway::localization {

/// Coordinates of four points.
struct FourPoints {
  FourFloats x, y, z;
};

/// End points of a scan from the `first` on; zeros behind the last one.
[[gnu::always_inline]] inline FourPoints four_points(const ScanPoints& points, std::size_t first) {
  const std::size_t count = points.size() - first;
  if (count >= 4) {
    return {load_four(&points.x[first]), load_four(&points.y[first]), load_four(&points.z[first])};
  }
  return {load_some(&points.x[first], count), load_some(&points.y[first], count),
          load_some(&points.z[first], count)};
}

/// `R p + t`; each to the bit that of one point.
[[gnu::always_inline]] inline FourPoints transformed(const Eigen::Matrix3f& R,
                                                     const Eigen::Vector3f& t,
                                                     const FourPoints& p) {
  const auto row = [&](int i) { return R(i, 0) * p.x + (R(i, 1) * p.y + R(i, 2) * p.z) + t(i); };
  return {row(0), row(1), row(2)};
}

}  // namespace castaway::localization
