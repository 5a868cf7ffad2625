/// Chooses the places between which a recorded log is spliced into a kidnap.
#pragma once

#include "localization/geometry/se2.hpp"
#include "tools/build/recorded/spliced_source.hpp"

namespace castaway::testbed {

/// Where a spliced kidnap comes from, seen from where it leads.
enum class SpliceKind {
  kFar,        ///< The scan half a log away.
  kNear,       ///< The nearest pose that is another place.
  kLookAlike,  ///< The most similar scan of another place.
};

/// The names of the kinds: "far", "near", "look-alike".
inline constexpr const char* kSpliceKinds[] = {"far", "near", "look-alike"};

/// Throws std::invalid_argument for a text that is not one of `kSpliceKinds`.
SpliceKind parse_splice_kind(const std::string& text);

/// Parameters of the choice. Another place is at least `min_distance_m`, heights included where
/// they are known, or `min_turn_rad` away.
struct SpliceConfig {
  SpliceKind kind = SpliceKind::kFar;
  std::size_t lead = 30;         ///< Scans before the kidnap.
  double min_distance_m = 1.0;   ///< [m]
  double min_turn_rad = 1.5708;  ///< [rad]
  double range_max = 0.0;        ///< [m] Longer returns are not compared; 0: all are.
};

/// Returns the splice that leads to scan `to`. The window is not set. Throws std::out_of_range if
/// there is no such scan, std::runtime_error if the log has no other place, or no true poses.
Splice choose_splice(const Frames& frames, std::size_t to, const SpliceConfig& config);

/// Mean difference of the ranges of two scans of one lidar, each capped at 1 m; a return and no
/// return differ by 1 m. Of about 90 beams. 1 if the scans have different numbers of beams.
double range_difference(const LaserScan& a, const LaserScan& b, double range_max);

}  // namespace castaway::testbed
