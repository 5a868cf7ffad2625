/// Fits mixed pixels to a log: beams that hit the edge of a near surface report a range between it
/// and the surface behind.
///
/// Depth steps are found in the scans themselves, between two flat surfaces: the share of steps
/// with a beam in between, times the angle between beams, is the opening of a beam.
#pragma once

#include <optional>
#include <vector>

#include "tools/twin/alignment/aligned_log.hpp"
#include "tools/twin/fits/figure.hpp"

namespace castaway::testbed {

/// Opening of the beams, in the terms of `sim::LightEffects`.
struct MixedFit {
  Figure divergence_deg;  ///< [deg] Full opening of a beam.
  double reach_m = 0.0;   ///< [m] Larger steps are not mixed; the maximum range if all are.
  /// Depth steps of one size, for the plot.
  struct Bin {
    double step_m = 0.0;  ///< Mean.
    double steps = 0.0;
    double mixed = 0.0;    ///< Those with a beam in between.
    double visible = 0.0;  ///< Those where a mixed beam would be told from both surfaces.
    double other = 0.0;    ///< Those that are expected to have a beam in between for other reasons.
  };
  std::vector<Bin> bins;
  double other = 0.0;  ///< Share of steps with a beam in between for other reasons.
  std::size_t steps = 0;
};

/// Nothing if there are too few depth steps. `others`: shares of steps that have a beam in between
/// for other reasons, by size, as of `shares_in_between`; none if it is empty.
std::optional<MixedFit> fit_mixed(const AlignedLog& log, const std::vector<double>& others = {});

/// Shares of depth steps with a beam in between, by size.
std::vector<double> shares_in_between(const AlignedLog& log);

}  // namespace castaway::testbed
