/// The constant part of MH-AMCL: settings, map, and the models that depend on these alone.
#pragma once

#include <memory>
#include <optional>

#include "localization/matching/place_matcher.hpp"
#include "localization/mh_amcl/ground.hpp"
#include "localization/mh_amcl/mh_amcl_config.hpp"
#include "localization/mh_amcl/tracking_filter.hpp"
#include "localization/search/create.hpp"
#include "localization/search/rescue.hpp"
#include "localization/sensor/distance_filter.hpp"
#include "localization/sensor/evidence_model.hpp"

namespace castaway::localization {

/// Conditioned once, used for every scan. Not copyable, since the models refer to the map and to
/// each other.
struct MhAmclModels {
  /// @throws std::invalid_argument for an invalid map or settings.
  MhAmclModels(const MhAmclConfig& mh_amcl, OccupancyGrid grid);
  /// For a 3-D map. Poses are in its atlas.
  MhAmclModels(const MhAmclConfig& mh_amcl, std::shared_ptr<const Volume> ground_and_surfaces);
  MhAmclModels(const MhAmclModels&) = delete;

  MhAmclConfig config;
  Ground ground;
  std::optional<NdtMap> ndt_map;     ///< None: `RefineMethod::kClimb`.
  std::optional<NdtRefinement> ndt;  ///< On `ndt_map`.
  EndpointModel endpoint;
  EvidenceModel evidence;
  DistanceFilter distance_filter;
  std::unique_ptr<const PlaceMatcher> matcher;
  TrackingFilter filter;
  Rescue rescue;
  CreateContext context;
};

}  // namespace castaway::localization
