/// Data shared by the sequences of a data set: worlds, maps, and the maps' ambiguity scores.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "tools/base/formats/ros_map.hpp"
#include "tools/play/inspect/map_scores.hpp"

namespace castaway::testbed {

/// Builds worlds and robots once for all sequences that share them.
class DatasetWorlds {
 public:
  /// `base`: folder that relative paths in the scenarios start from.
  explicit DatasetWorlds(std::filesystem::path base) : base_(std::move(base)) {}

  /// Builds the scenario unless an equivalent one (same world, robot, lidars and route) was built
  /// before. Throws what `build_simulation` throws.
  void check(const Scenario& scenario);
  /// Requests the scores of the scenario's map. Precondition: `check` was called for it.
  void request_scores(const Scenario& scenario);
  /// Computes all requested scores, `workers` maps at a time. Throws std::runtime_error naming the
  /// world that failed.
  void compute_scores(int workers);

  /// Scores computed by `compute_scores`.
  [[nodiscard]] const MapScores& scores(const Scenario& scenario) const;
  /// Name of the world, as in summaries. Precondition: `check` was called for the scenario.
  [[nodiscard]] const std::string& world(const Scenario& scenario) const;
  /// Maps by world name; each is from the first scenario that was built in the world.
  [[nodiscard]] const std::map<std::string, RosMap>& maps() const { return maps_; }

 private:
  /// Results of building a scenario.
  struct Built {
    sim::LidarConfig lidar;
    std::string world;
  };

  [[nodiscard]] const Built& built_world(const Scenario& scenario) const;
  [[nodiscard]] std::string score_key(const Scenario& scenario) const;
  [[nodiscard]] MapScores score_map(const Scenario& scenario) const;

  std::filesystem::path base_;
  std::map<std::string, Built> built_;
  std::map<std::string, Scenario> asked_;
  std::map<std::string, MapScores> scores_;
  std::map<std::string, RosMap> maps_;
};

}  // namespace castaway::testbed
