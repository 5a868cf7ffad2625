/// Finds where on a map a single scan could have been taken, with the global search of `mh_amcl`.
#pragma once

#include <vector>

#include "localization/mh_amcl/mh_amcl_models.hpp"

namespace castaway::testbed {

/// A place where a scan fits.
struct FoundPlace {
  localization::SE2 T_map_base;
  double log_likelihood = 0.0;  ///< Evidence of the scan (`Evidence`).
};

/// Searches one map as mode `improved` does, without earlier scans: matcher, refinement, evidence
/// by end points and rays.
class PlaceFinder {
 public:
  PlaceFinder(const localization::MhAmclConfig& config, const localization::OccupancyGrid& map);

  /// Refined places, best evidence first; empty for a scan without points.
  [[nodiscard]] std::vector<FoundPlace> find(const localization::ScanPoints& points) const;
  /// The place to which refinement converges from a pose: what a search started there would list.
  [[nodiscard]] FoundPlace refine(const localization::ScanPoints& points,
                                  const localization::SE2& T_map_base) const;
  /// Share of the beams that end at least 0.3 m before the first wall on the map.
  [[nodiscard]] double blocked_share(const localization::ScanPoints& points,
                                     const localization::SE2& T_map_base) const;
  [[nodiscard]] const localization::EvidenceModel& evidence() const { return models_.evidence; }

 private:
  localization::MhAmclModels models_;
};

}  // namespace castaway::testbed
