/// Where on a map a single scan could have been taken: the global search of `mh_amcl` on its own.
#pragma once

#include <vector>

#include "localization/mh_amcl_config.hpp"

namespace castaway::testbed {

/// Searches one map as mode `improved` does, without a past: matcher, refinement, evidence by end
/// points and rays. The map must outlive it.
class PlaceFinder {
 public:
  PlaceFinder(const localization::MhAmclConfig& config, const localization::OccupancyGrid& map);

  /// Poses of base in map, refined, the best by evidence first; none for a scan without points.
  [[nodiscard]] std::vector<localization::SE2> find(const localization::ScanPoints& points) const;

 private:
  localization::MhAmclConfig config_;
  localization::DistanceField distances_;
  localization::EndpointModel endpoint_;
  localization::EvidenceModel evidence_;
  localization::CascadeMatcher matcher_;
};

}  // namespace castaway::testbed
