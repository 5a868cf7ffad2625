#include "localization/mh_amcl_models.hpp"

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

}  // namespace

MhAmclModels::MhAmclModels(const MhAmclConfig& mh_amcl, OccupancyGrid grid)
    : config((validate(mh_amcl), mh_amcl)),
      planar(planar_map(config, std::move(grid))),
      endpoint(config.refinement, planar->distances),
      evidence(config.evidence, planar->grid, planar->distances),
      distance_filter(config.distance_filter, evidence.world()),
      matcher(std::make_unique<CascadeMatcher>(config.matcher, planar->grid, planar->distances)),
      filter({config.tracking, planar->distances}, config.reseed, config.refine),
      rescue(config.rescue, *matcher),
      context{config.create, config.merge, config.posterior, config.motion, endpoint, evidence} {}

MhAmclModels::MhAmclModels(const MhAmclConfig& mh_amcl,
                           std::shared_ptr<const Volume> ground_and_surfaces)
    : config((validate(mh_amcl), mh_amcl)),
      volume(std::move(ground_and_surfaces)),
      endpoint(config.refinement, *volume),
      evidence(config.evidence, *volume),
      distance_filter(config.distance_filter, evidence.world()),
      matcher(std::make_unique<StackMatcher>(config.matcher, *volume)),
      filter({config.tracking, *volume}, config.reseed, config.refine),
      rescue(config.rescue, *matcher),
      context{config.create, config.merge, config.posterior, config.motion,
              endpoint,      evidence,     volume.get()} {}

}  // namespace castaway::localization
