#include "tools/campaign/place_finder.hpp"

namespace castaway::testbed {

using localization::SE2;

PlaceFinder::PlaceFinder(const localization::MhAmclConfig& config,
                         const localization::OccupancyGrid& map)
    : config_(config),
      distances_(map, config.max_distance),
      endpoint_(config.evidence.endpoint, distances_),
      evidence_(config.evidence, map, distances_),
      matcher_(config.matcher, map, distances_) {}

std::vector<SE2> PlaceFinder::find(const localization::ScanPoints& points) const {
  if (points.empty()) return {};
  const localization::CreateContext context{config_.create, config_.merge, config_.posterior,
                                            config_.motion, endpoint_,     evidence_};
  std::vector<SE2> poses;
  for (const auto& place : refine_candidates(context, matcher_.match(points), points)) {
    poses.push_back(place.T_map_base);
  }
  return poses;
}

}  // namespace castaway::testbed
