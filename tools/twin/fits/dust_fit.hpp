/// Fits short returns of what hangs in the air to a log: dust, rain.
///
/// A beam on a straight wall that returns too early, although its neighbours return that wall, met
/// something small. Legs of chairs and of people are seen there again by the scans just before and
/// after; grains are not.
#pragma once

#include <optional>
#include <vector>

#include "tools/twin/alignment/aligned_log.hpp"
#include "tools/twin/fits/dust_counts.hpp"
#include "tools/twin/fits/figure.hpp"

namespace castaway::testbed {

/// Grains that return beams, in the terms of `sim::LightEffects`.
struct DustFit {
  Figure per_m;           ///< [1/m] Grains per metre of beam, up to `range_m`.
  double range_m = 10.0;  ///< [m] Farther grains are not seen; 10 m if fewer than five were.
  std::size_t hits = 0;   ///< Grains within `range_m`, and what is taken for them.
  std::size_t beams = 0;  ///< On straight walls between neighbours that return them.
  double metres = 0.0;    ///< [m] Of these beams, up to `range_m`, where a grain would be counted.
  double other_per_m = 0.0;   ///< [1/m] What is taken for grains beyond `range_m`.
  std::vector<DustBin> bins;  ///< By range.
};

/// Without any grain the interval ends at 3 / `metres`. Nothing if fewer than 500 beams qualify.
std::optional<DustFit> fit_dust(const AlignedLog& log);

}  // namespace castaway::testbed
