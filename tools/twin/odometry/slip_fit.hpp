/// Fits slips of single wheels: tails of odometry's errors that the random walk does not have.
#pragma once

#include <vector>

#include "tools/twin/fits/figure.hpp"
#include "tools/twin/odometry/odometry_noise.hpp"

namespace castaway::testbed {

/// Slips in the terms of `sim::SlipConfig`.
struct SlipFit {
  Figure rate_per_m;      ///< [1/m] Of each wheel.
  double length_m = 0.0;  ///< [m] Rolled during a slip of which `kShare` is lost.
  int slips = 0;          ///< Number of clear ones.

  /// Shares of stretches whose yaw is farther off than some number of standard deviations.
  struct Tail {
    double sigmas = 0.0;
    double measured = 0.0;
    double model = 0.0;  ///< By noise and slips.
  };
  std::vector<Tail> tail;

  static constexpr double kShare = 0.3;
};

/// Counts stretches whose yaw is more than four standard deviations off. A wheel that slips turns
/// too far, so that odometry is ahead; as many in which odometry is behind are other errors.
/// `blocks`: of the legs.
SlipFit fit_slips(const std::vector<Stretch>& stretches, const DriveErrors& errors,
                  const OdometryNoise& noise, double track, const Blocks& blocks);

}  // namespace castaway::testbed
