/// The formats of other tools that a run is asked to leave behind.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "tools/run/run_sink.hpp"
#include "tools/sinks/bag_sink.hpp"

namespace castaway::testbed {

/// What is asked for.
struct ExportConfig {
  std::optional<BagConfig> bag;  ///< bag/; nothing: none.
  bool carmen = false;           ///< log.carmen
  bool kitti = false;            ///< kitti/
  bool map = false;              ///< map/map.yaml and map/map.pgm: the localizers' map.
};

/// Writes the map, if asked to, and returns the sinks that write the rest.
std::vector<std::unique_ptr<RunSink>> export_sinks(const std::filesystem::path& run_folder,
                                                   const RunInfo& info, const RosMap& map,
                                                   const ExportConfig& config);

}  // namespace castaway::testbed
