/// The difference layer in YAML: `differences` of world files and of scenarios.
///
///     differences:
///       move_furniture: 0.3          # share of the movable pieces that stand elsewhere...
///       reach_m: 2                   # ...by at most so far
///       remove: 0.1                  # share that is gone
///       close_doors: 0.5             # share of the open doors that are closed
///       open_doors: 0                # share of the closed doors that are open
///       add_boxes: 10                # boxes that stand about
///       seed: 7                      # instead of the run's
///       changes:                     # by name, carried out first
///         - move: {name: sofa, by: [0.5, 0], turn_deg: 20}
///         - remove: {name: plant}
///         - open: {name: store-door, open_deg: 60}
///         - close: {name: office-door}
///         - add: {box: {at: [1, 2], size: [0.4, 0.4, 0.4]}}     # any object
#pragma once

#include <filesystem>

#include "sim/difference/difference.hpp"
#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {

/// Reads `differences` under `root`; empty if there are none. Meshes of added objects are searched
/// in `folder`.
sim::DifferenceSpec read_differences(YamlReader& root, const std::filesystem::path& folder);

}  // namespace castaway::testbed
