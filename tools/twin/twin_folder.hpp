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
  Likeness likeness;
  RecordedPlace run;  ///< Of the twin, with seed 1.
};

/// Writes what a twin's scenario reads: `world.yaml`, `map.yaml`, `path.tum`, `scan_times.txt`.
/// `map`: of the log.
void write_twin_inputs(const RosMap& map, const FittedLog& fitted,
                       const std::filesystem::path& folder);

/// Fits a log and writes its twin into a folder: `scenario.yaml` with `world.yaml` (the building as
/// the log saw it), `map.yaml`, `path.tum` and `scan_times.txt`; parts to use elsewhere
/// (`lidar.yaml`, `odometry.yaml`, `people.yaml`, and `differences.yaml` if the building differs
/// from its map); and all figures in `calibration.json`. Throws as `fit_log` and
/// `build_simulation`.
Twin build_twin(const RecordedPlace& place, AlignBy by, const std::filesystem::path& folder);

nlohmann::ordered_json to_json(const Twin& twin);

}  // namespace castaway::testbed
