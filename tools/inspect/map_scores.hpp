/// How alike the places of a scenario's map look to its lidar.
#pragma once

#include <filesystem>
#include <string>

#include "sim/map/ambiguity.hpp"
#include "sim/sensor/lidar_config.hpp"
#include "tools/records/place_scores.hpp"
#include "tools/scenario/sections/scenario.hpp"

namespace castaway::testbed {

/// A map's ambiguity, on the whole and by place.
struct MapScores {
  sim::Ambiguity ambiguity;
  PlaceScores places;
};

/// The range that a lidar is judged by: the next of 2, 3, 4, 6, 8, 12, 16, 25, 50 m, so that lidars
/// of nearly the same range share their figures. [m]
double judged_range(double range_max);

/// Of the world as it was mapped, whatever differs by now, seen from the lidar's height. Loads the
/// world; seconds for a building.
MapScores map_scores(const Scenario& scenario, const std::filesystem::path& base,
                     const sim::LidarConfig& lidar);

/// To hand them from one process to another, and back without loss.
std::string scores_text(const MapScores& scores);
MapScores parse_scores(const std::string& text);

}  // namespace castaway::testbed
