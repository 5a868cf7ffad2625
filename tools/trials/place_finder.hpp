/// Where on a map a single scan could have been taken: the global search of `mh_amcl` on its own.
#pragma once

#include <vector>

#include "localization/mh_amcl_config.hpp"

namespace castaway::testbed {

/// A place where a scan fits.
struct FoundPlace {
  localization::SE2 T_map_base;
  double log_likelihood = 0.0;  ///< Evidence of the scan, 0 at best (`Evidence`).
};

/// Searches one map as mode `improved` does, without a past: matcher, refinement, evidence by end
/// points and rays. The map must outlive it.
class PlaceFinder {
 public:
  PlaceFinder(const localization::MhAmclConfig& config, const localization::OccupancyGrid& map);

  /// Places, refined, the best by evidence first; none for a scan without points.
  [[nodiscard]] std::vector<FoundPlace> find(const localization::ScanPoints& points) const;
  /// The place that refinement finds from a pose: what a search that looked there would list.
  [[nodiscard]] FoundPlace refined(const localization::ScanPoints& points,
                                   const localization::SE2& T_map_base) const;
  /// Share of the beams that end 0.3 m or more before the map has a wall.
  [[nodiscard]] double blocked_share(const localization::ScanPoints& points,
                                     const localization::SE2& T_map_base) const;

 private:
  localization::MhAmclConfig config_;
  const localization::OccupancyGrid& map_;
  localization::DistanceField distances_;
  localization::EndpointModel endpoint_;
  localization::EvidenceModel evidence_;
  localization::CascadeMatcher matcher_;
};

}  // namespace castaway::testbed
