/// Fits the constant offsets of single beams to a log.
///
/// The middle one of seven neighbouring beams on a straight surface lies beside the line through
/// them by its offset and by noise. Noise differs from one part of the log to the next, the offset
/// does not: it is what the mean residuals of a beam in different parts have in common.
#pragma once

#include <optional>
#include <vector>

#include "tools/twin/alignment/aligned_log.hpp"
#include "tools/twin/fits/figure.hpp"

namespace castaway::testbed {

/// Offsets of beams, in the terms of `sim::RangeNoise`.
struct BeamBiasFit {
  Figure sigma_m;         ///< [m] Standard deviation of the offsets; not negative.
  std::size_t beams = 0;  ///< Beams that were seen in at least two parts of the log.
  /// [m] Mean residuals of these beams, ascending, and the standard deviation of such means by the
  /// offsets and by noise.
  std::vector<double> means_m;
  double means_sigma_m = 0.0;
};

/// Needs no map. Only scans count before which the robot moved: to one that stands, a wall that is
/// not flat looks like offsets. Nothing if fewer than 200 pairs of parts with ten residuals each
/// show the same beam, for all beams together.
std::optional<BeamBiasFit> fit_beam_bias(const AlignedLog& log);

}  // namespace castaway::testbed
