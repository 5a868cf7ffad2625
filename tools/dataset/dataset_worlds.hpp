/// What the sequences of a data set have in common: worlds, maps, and how hard these are.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "tools/formats/ros_map.hpp"
#include "tools/inspect/map_scores.hpp"

namespace castaway::testbed {

/// Builds worlds and robots once for all sequences that share them.
class DatasetWorlds {
 public:
  /// `base`: folder that relative paths of the scenarios start from.
  explicit DatasetWorlds(std::filesystem::path base) : base_(std::move(base)) {}

  /// Builds the scenario unless one with the same world, robot, lidars and route was built before.
  /// Throws what `build_simulation` throws.
  void check(const Scenario& scenario);
  /// Asks how alike the places of its map look. `check` it first.
  void ask_scores(const Scenario& scenario);
  /// Finds out whatever was asked, `workers` maps at a time, each in a process of its own.
  /// `drafts`: a folder for what they find; what is left there may go. Throws FileError where that
  /// fails: the worlds were built before.
  void find_scores(int workers, const std::filesystem::path& drafts);

  /// What `find_scores` found.
  [[nodiscard]] const MapScores& scores(const Scenario& scenario) const;
  /// The world's name, as in summaries. `check` it first.
  [[nodiscard]] const std::string& world(const Scenario& scenario) const;
  /// Maps by world: of the first scenario there.
  [[nodiscard]] const std::map<std::string, RosMap>& maps() const { return maps_; }

 private:
  /// What was built.
  struct Built {
    sim::LidarConfig lidar;
    std::string world;
  };

  [[nodiscard]] const Built& built(const Scenario& scenario) const;
  [[nodiscard]] std::string score_key(const Scenario& scenario) const;
  [[nodiscard]] MapScores judged(const Scenario& scenario) const;

  std::filesystem::path base_;
  std::map<std::string, Built> built_;
  std::map<std::string, Scenario> asked_;
  std::map<std::string, MapScores> scores_;
  std::map<std::string, RosMap> maps_;
};

}  // namespace castaway::testbed
