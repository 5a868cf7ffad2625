/// The beams of an aligned scan, compared with the map one by one.
#pragma once

#include <vector>

#include "localization/map/distance_field.hpp"
#include "tools/twin/alignment/expected_scan.hpp"

namespace castaway::testbed {

/// A beam of a scan against the map, in cells of the grid's frame.
struct BeamView {
  Eigen::Vector2d from;
  Eigen::Vector2d end;    ///< Of the measured range, or of the expected one if it was lost.
  double range_m = 0.0;   ///< To `end`.
  double turn_rad = 0.0;  ///< Width of the beam's sector.
  bool returns = false;   ///< It was measured.
  bool foreign = false;   ///< It ends where the map has neither a wall nor the unknown.
  bool through = false;   ///< It passes through a wall of the map, at `wall`.
  bool confirms = false;  ///< It ends at that wall.
  Eigen::Vector2d wall;   ///< Centre of the cell of the expected wall.
};

/// Compares the beams of a log's scans with its map, up to 20 m. The log must outlive it.
class BeamViewer {
 public:
  explicit BeamViewer(const AlignedLog& log);

  /// The beams that measured something or were lost; empty if the motion is unknown.
  [[nodiscard]] std::vector<BeamView> view(const AlignedScan& aligned) const;

 private:
  [[nodiscard]] BeamView view_of(const AlignedScan& aligned, std::size_t i,
                                 const ExpectedBeam& beam, double r) const;

  const AlignedLog& log_;
  localization::DistanceField distances_;
};

}  // namespace castaway::testbed
