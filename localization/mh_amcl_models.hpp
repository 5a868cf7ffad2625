/// The constant part of MH-AMCL: settings, map, and the models that depend on these alone.
#pragma once

#include "localization/map/distance_field.hpp"
#include "localization/matching/cascade_matcher.hpp"
#include "localization/mh_amcl_config.hpp"
#include "localization/search/create.hpp"
#include "localization/search/rescue.hpp"
#include "localization/sensor/distance_filter.hpp"
#include "localization/sensor/evidence_model.hpp"
#include "localization/tracking_filter.hpp"

namespace castaway::localization {

/// Conditioned once, used for every scan. Not copyable, since the models refer to the map and to
/// each other.
struct MhAmclModels {
  /// @throws std::invalid_argument for an invalid map or settings.
  MhAmclModels(const MhAmclConfig& mh_amcl, OccupancyGrid grid);
  MhAmclModels(const MhAmclModels&) = delete;

  MhAmclConfig config;
  OccupancyGrid map;
  DistanceField distances;  ///< To the surfaces of obstacles.
  EndpointModel endpoint;
  EvidenceModel evidence;
  DistanceFilter distance_filter;
  CascadeMatcher matcher;
  TrackingFilter filter;
  Rescue rescue;
  CreateContext context;
};

}  // namespace castaway::localization
