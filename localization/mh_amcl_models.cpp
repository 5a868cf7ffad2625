#include "localization/mh_amcl_models.hpp"

#include <utility>

#include "localization/map/hollow.hpp"

namespace castaway::localization {

MhAmclModels::MhAmclModels(const MhAmclConfig& mh_amcl, OccupancyGrid grid)
    : config((validate(mh_amcl), mh_amcl)),
      map((validate(grid), std::move(grid))),
      distances(hollow(map, config.surface_depth), config.max_distance),
      endpoint(config.refinement, distances),
      evidence(config.evidence, map, distances),
      distance_filter(config.distance_filter, evidence.walls()),
      matcher(config.matcher, map, distances),
      filter({config.tracking, distances}, config.reseed, config.refine),
      rescue(config.rescue, matcher),
      context{config.create, config.merge, config.posterior, config.motion, endpoint, evidence} {}

}  // namespace castaway::localization
