#include "tools/commands/map_scores.hpp"

#include "tools/commands/world_likeness.hpp"

namespace castaway::testbed {

double judged_range(double range_max) {
  constexpr double kLongest = 50.0;
  for (const double range : {2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0, 25.0}) {
    if (range_max <= range) return range;
  }
  return kLongest;
}

MapScores map_scores(const Scenario& scenario, const std::filesystem::path& base,
                     const sim::LidarConfig& lidar) {
  WorldChoice mapped = scenario.world;
  mapped.differences = sim::DifferenceSpec{};
  SurveyOptions options{lidar.T_base_laser.translation().z(), scenario.wall_height};
  options.seed = scenario.seed;
  if (scenario.start.place == StartSpec::Place::kPose) {
    options.inside = scenario.start.pose.head<2>();
  }
  const LoadedWorld world = build_world(mapped, base, options);
  const sim::PlaceLikeness places =
      world_likeness(world, {lidar.T_base_laser.translation().z(), judged_range(lidar.range_max)});
  return {sim::ambiguity_of(places), {places.places, places.likeness}};
}

}  // namespace castaway::testbed
