/// Error of a log's odometry over stretches of its path.
#pragma once

#include <optional>
#include <vector>

#include "tools/twin/alignment/aligned_log.hpp"

namespace castaway::testbed {

/// What odometry missed over a stretch.
struct Drift {
  double way_m = 0.0;  ///< [m] Travel of the wheels.
  double miss_m =
      0.0;  ///< [m] Distance between the measured end of the stretch and the aligned one.
};

/// Successive stretches of at least `length` [m] each, without resets of odometry, as measured.
std::vector<Drift> drifts_over(const AlignedLog& log, double length);

/// Root of the mean square of the misses [m]; nothing for fewer than 4 stretches.
std::optional<double> drift_rms(const std::vector<Drift>& drifts);

}  // namespace castaway::testbed
