/// Matches single scans to the map of a log.
#pragma once

#include <optional>

#include "localization/map/distance_field.hpp"
#include "localization/matching/refine.hpp"
#include "tools/twin/alignment/aligned_log.hpp"

namespace castaway::testbed {

/// Matches scans to the surfaces of the map of a log near a pose. The inside of walls does not
/// count: it would draw every scan into the nearest wall. The log must outlive it.
class ScanAligner {
 public:
  /// `log`: with its grid and `T_path_base`. `walls`: surfaces of the walls, if they are known.
  ScanAligner(const AlignedLog& log, std::optional<WallOffsets> walls);

  /// The best pose of base near `start`, or nothing if the motion at that time is unknown or no
  /// beam returned. `sigma` [m] is the uncertainty of the start.
  [[nodiscard]] std::optional<SE2> align(const LaserScan& scan, const SE2& start,
                                         double sigma) const;

  /// The share of a scan's end points that lie near walls.
  [[nodiscard]] double on_walls(const AlignedScan& aligned) const;

 private:
  [[nodiscard]] LaserScan move_to_centres(LaserScan scan, const SE2& T_map_base) const;

  const AlignedLog& log_;
  std::optional<WallOffsets> walls_;
  localization::DistanceField distances_;
  localization::EndpointModel model_;
};

}  // namespace castaway::testbed
