/// Finds where on the map a scan could have been taken: exhaustive at a coarse level, then the best
/// of every neighbourhood, to be refined at full resolution (`refine_pose`).
///
/// After the cascade of the paper (section IV-A) with two changes: yaws every 3 degrees instead of
/// pi/8, and 16 neighbouring places scored at once, because for one yaw and beam their bytes lie
/// side by side (E. Olson, "Real-Time Correlative Scan Matching", ICRA 2009).
#pragma once

#include <optional>
#include <vector>

#include "localization/map/byte_field.hpp"
#include "localization/sensor/scan_points.hpp"

namespace castaway::localization {

/// Parameters of the search.
struct MatcherConfig {
  ByteFieldConfig field;
  double yaw_step = 0.0524;    ///< [rad] About 3 degrees; rounded so that whole steps make a turn.
  int points = 64;             ///< End points used, even over the scan; at most 256.
  int candidates = 60;         ///< At most so many are returned.
  double suppression_m = 1.6;  ///< [m] Only the best of a square of this size...
  double suppression_rad = 0.1745;  ///< [rad] ...and of this range of yaws is kept.
};

/// Throws std::invalid_argument where a figure is out of its range.
void validate(const MatcherConfig& config);

/// A place where a scan fits.
struct Candidate {
  SE2 T_map_base;      ///< Centre of the coarse cell, yaw of the step.
  double score = 0.0;  ///< In [0, 1]: mean of the bytes under the end points.
};

/// Restricts a search to the surroundings of a pose.
struct MatchWindow {
  SE2 centre;               ///< Pose of base in map.
  double radius = 1.1;      ///< [m] Half edge of the square.
  double yaw_radius = 0.6;  ///< [rad]
};

/// Searches one map.
class CascadeMatcher {
 public:
  CascadeMatcher(const MatcherConfig& config, const OccupancyGrid& grid,
                 const DistanceField& distances);

  /// Candidates on free cells, best first; none for a scan without points.
  [[nodiscard]] std::vector<Candidate> match(const ScanPoints& points,
                                             const std::optional<MatchWindow>& window = {}) const;

 private:
  /// Up to 16 neighbouring coarse cells of one row.
  struct Block {
    int column = 0;
    int row = 0;
    std::uint16_t free = 0;  ///< Bit j: cell column + j is free.
  };
  [[nodiscard]] std::vector<Block> blocks_within(const std::optional<MatchWindow>& window) const;

  MatcherConfig config_;
  ByteField field_;
  std::vector<Block> blocks_;
  int yaws_ = 0;
};

}  // namespace castaway::localization
