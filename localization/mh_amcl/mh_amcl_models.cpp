#include "localization/mh_amcl/mh_amcl_models.hpp"

#include <stdexcept>
#include <utility>

#include "localization/map/hollow.hpp"
#include "localization/matching/cascade_matcher.hpp"
#include "localization/matching/stack_matcher.hpp"

namespace castaway::localization {
namespace {

PlanarMap planar_map(const MhAmclConfig& config, OccupancyGrid grid) {
  validate(grid);
  const OccupancyGrid hollowed = hollow(grid, config.surface_depth);
  return {std::move(grid), {hollowed, config.max_distance}};
}

const PlanarMap& planar_of(const Ground& ground) { return std::get<PlanarMap>(ground); }

const Volume& volume_of(const Ground& ground) { return *std::get<SpaceMap>(ground).volume; }

/// Cells of a map, if poses are refined on them.
std::optional<NdtMap> ndt_map_of(const MhAmclConfig& config, const OccupancyGrid& grid) {
  if (config.refine_by == RefineMethod::kClimb) return std::nullopt;
  return NdtMap(hollow(grid, config.surface_depth), config.ndt);
}

std::optional<NdtMap> ndt_map_of(const MhAmclConfig& config, const VoxelMap& voxels) {
  if (config.refine_by == RefineMethod::kClimb) return std::nullopt;
  return NdtMap(voxels, config.ndt);
}

/// Registration as sharp as a model of end points; nothing without cells.
std::optional<NdtRegistration> registration(const MhAmclConfig& config,
                                            const EndpointConfig& endpoint,
                                            const std::optional<NdtMap>& map,
                                            const Volume* volume) {
  if (!map) return std::nullopt;
  const bool points = config.refine_by == RefineMethod::kNdtPoints;
  return NdtRegistration{NdtModel(endpoint, *map, volume),
                         points ? NdtMatching::kPoints : NdtMatching::kDistributions,
                         config.ndt.cell};
}

std::optional<NdtRefinement> refinement(const MhAmclConfig& config,
                                        const std::optional<NdtMap>& map, const Volume* volume) {
  if (!map) return std::nullopt;
  return NdtRefinement{*registration(config, config.refinement, map, volume),
                       *registration(config, config.evidence.endpoint, map, volume)};
}

/// Weighs particles, if distances to surfaces do not.
std::optional<AlongBeamModel> along_beams(const MhAmclConfig& config, const Volume& volume) {
  if (config.track_by == TrackingError::kDistance) return std::nullopt;
  return AlongBeamModel(config.tracking, volume);
}

/// @throws std::invalid_argument for a setting that needs a 3-D map.
const MhAmclConfig& validate_on_plane(const MhAmclConfig& config) {
  validate(config);
  if (config.track_by == TrackingError::kDistance) return config;
  throw std::invalid_argument("particles are weighed along beams on 3-D maps only");
}

}  // namespace

MhAmclModels::MhAmclModels(const MhAmclConfig& mh_amcl, OccupancyGrid grid)
    : config(validate_on_plane(mh_amcl)),
      ground(planar_map(config, std::move(grid))),
      ndt_map(ndt_map_of(config, planar_of(ground).grid)),
      ndt(refinement(config, ndt_map, nullptr)),
      endpoint(config.refinement, planar_of(ground).distances),
      evidence(config.evidence, planar_of(ground).grid, planar_of(ground).distances),
      distance_filter(config.distance_filter, evidence.world()),
      matcher(std::make_unique<CascadeMatcher>(config.matcher, planar_of(ground).grid,
                                               planar_of(ground).distances)),
      filter({config.tracking, planar_of(ground).distances}, config.reseed, config.refine,
             config.mixture, registration(config, config.tracking, ndt_map, nullptr)),
      rescue(config.rescue, *matcher),
      context{config.create, config.merge, config.posterior, config.motion,
              endpoint,      evidence,     nullptr,          ndt ? &*ndt : nullptr} {}

MhAmclModels::MhAmclModels(const MhAmclConfig& mh_amcl,
                           std::shared_ptr<const Volume> ground_and_surfaces)
    : config((validate(mh_amcl), mh_amcl)),
      ground(SpaceMap{std::move(ground_and_surfaces)}),
      ndt_map(ndt_map_of(config, volume_of(ground).voxels())),
      ndt(refinement(config, ndt_map, &volume_of(ground))),
      endpoint(config.refinement, volume_of(ground)),
      evidence(config.evidence, volume_of(ground)),
      distance_filter(config.distance_filter, evidence.world()),
      matcher(std::make_unique<StackMatcher>(config.matcher, volume_of(ground))),
      filter({config.tracking, volume_of(ground)}, config.reseed, config.refine, config.mixture,
             registration(config, config.tracking, ndt_map, &volume_of(ground)),
             along_beams(config, volume_of(ground))),
      rescue(config.rescue, *matcher),
      context{config.create, config.merge, config.posterior,   config.motion,
              endpoint,      evidence,     &volume_of(ground), ndt ? &*ndt : nullptr} {}

}  // namespace castaway::localization
