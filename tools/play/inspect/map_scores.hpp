/// Perceptual aliasing of a scenario's map, as seen by its lidar.
#pragma once

#include <filesystem>
#include <string>

#include "sim/map/ambiguity.hpp"
#include "sim/sensor/lidar_config.hpp"
#include "tools/outputs/records/place_scores.hpp"
#include "tools/scenario/sections/scenario.hpp"

namespace castaway::testbed {

/// A map's ambiguity, overall and by place.
struct MapScores {
  sim::Ambiguity ambiguity;
  PlaceScores places;
};

/// Range [m] for which a map is scored: `range_max` rounded up to one of 2, 3, 4, 6, 8, 12, 16, 25,
/// 50 m, so that lidars of similar range share their scores.
double scoring_range(double range_max);

/// Scores the world as it was mapped, without later differences, seen from the lidar's height.
/// Loads the world; takes seconds for a building.
MapScores map_scores(const Scenario& scenario, const std::filesystem::path& base,
                     const sim::LidarConfig& lidar);

/// Converts scores to and from text without loss, for transfer between processes.
std::string scores_text(const MapScores& scores);
MapScores parse_scores(const std::string& text);

}  // namespace castaway::testbed
