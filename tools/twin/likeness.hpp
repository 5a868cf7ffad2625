/// How alike a log and its twin are.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/twin/alignment/aligned_log.hpp"
#include "tools/twin/log_fit.hpp"

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

/// Values of one quantity in a log and in its twin, ascending.
struct LikeSamples {
  std::string name;
  std::string unit;
  std::vector<double> log;
  std::vector<double> twin;
};

/// Error of odometry over stretches of one length, root of the mean square.
struct DriftPoint {
  double length_m = 0.0;
  double log_m = 0.0;
  double twin_m = 0.0;
};

/// How alike a log and its twin are, by quantity.
struct Likeness {
  std::vector<LikeSamples> samples;
  std::vector<DriftPoint> drift;  ///< By length.
};

/// Distance between two distributions: the area between their cumulative distribution functions, in
/// the unit of the samples, which are ascending and not empty.
///
/// L. N. Wasserstein, "Markov processes over denumerable products of spaces", Problems of
/// Information Transmission 5, 1969, for exponent 1.
double wasserstein_distance(const std::vector<double>& a, const std::vector<double>& b);

/// Residuals of ranges on walls, error of odometry over 10 m, share of beams blocked in a scan, and
/// evidence of `mh_amcl` at the aligned poses. A quantity without values on one side is left out.
Likeness compare_logs(const AlignedLog& log, const AlignedLog& twin);

}  // namespace castaway::testbed
