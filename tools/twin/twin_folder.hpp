/// Builds the twin of a log: a folder with a scenario that `castaway run` plays.
#pragma once

#include <filesystem>
#include <vector>

#include <nlohmann/json.hpp>

#include "tools/twin/likeness.hpp"
#include "tools/twin/log_fit.hpp"

namespace castaway::testbed {

/// A twin, and how alike it is.
struct Twin {
  FittedLog fitted;
  Figure people;
  std::vector<LikeSamples> likeness;
};

/// Fits a log and writes its twin into a folder: `scenario.yaml` with `map.yaml` and `path.tum`,
/// the parts of the scenario in files of their own (`lidar.yaml`, `odometry.yaml`, `people.yaml`,
/// and `differences.yaml` if the building differs from its map), and all figures in
/// `calibration.json`. Throws as `fit_log` and `build_simulation`.
Twin build_twin(const RecordedPlace& place, AlignBy by, const std::filesystem::path& folder);

nlohmann::ordered_json to_json(const Twin& twin);

}  // namespace castaway::testbed
