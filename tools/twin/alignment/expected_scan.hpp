/// What a map says that the beams of an aligned scan should measure.
#pragma once

#include <vector>

#include "tools/twin/alignment/aligned_log.hpp"

namespace castaway::testbed {

/// A beam against the map.
struct ExpectedBeam {
  float range = 0.0F;    ///< [m] To the first cell that is not free, at most the range asked for.
  float cosine = 0.0F;   ///< Of the angle of incidence on the wall; 0 where `straight` is false.
  bool wall = false;     ///< The range ends at an occupied cell.
  std::size_t cell = 0;  ///< Index of that cell in the grid.
  /// The wall is straight for at least 0.15 m on both sides, and its incidence is known.
  bool straight = false;
};

/// The beams of a scan from its pose, by index, cast up to `longest` [m]. Every beam starts where
/// the lidar was at the beam's time. Empty if that motion is unknown.
std::vector<ExpectedBeam> expect_scan(const AlignedLog& log, const AlignedScan& scan,
                                      double longest);

/// Indices of at most `most` scans of a log, evenly spread.
std::vector<std::size_t> spread_scans(const AlignedLog& log, std::size_t most);

}  // namespace castaway::testbed
