#include "tools/play/inspect/map_scores.hpp"

#include <nlohmann/json.hpp>

#include "tools/base/bytes/json_number.hpp"
#include "tools/base/files/json_text.hpp"
#include "tools/play/inspect/world_likeness.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

double scoring_range(double range_max) {
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
      world_likeness(world, {lidar.T_base_laser.translation().z(), scoring_range(lidar.range_max)});
  return {sim::ambiguity_of(places), {places.places, places.likeness}};
}

std::string scores_text(const MapScores& scores) {
  Json places = Json::array();
  for (const Eigen::Vector2d& place : scores.places.places) {
    places.push_back({place.x(), place.y()});
  }
  const sim::Ambiguity& ambiguity = scores.ambiguity;
  const Json root{{"mean", ambiguity.mean},      {"p90", ambiguity.p90},
                  {"twins", ambiguity.twins},    {"count", ambiguity.places},
                  {"places", std::move(places)}, {"scores", scores.places.scores}};
  return json_text(root);
}

MapScores parse_scores(const std::string& text) {
  const Json root = Json::parse(text);
  MapScores scores;
  scores.ambiguity = {root.at("mean").get<double>(), root.at("p90").get<double>(),
                      root.at("twins").get<double>(), integer<int>(root.at("count"))};
  for (const Json& place : root.at("places")) {
    scores.places.places.emplace_back(place[0].get<double>(), place[1].get<double>());
  }
  scores.places.scores = root.at("scores").get<std::vector<double>>();
  return scores;
}

}  // namespace castaway::testbed
