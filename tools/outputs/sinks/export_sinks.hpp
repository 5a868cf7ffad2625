/// Exports of a run in the formats of other tools.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "tools/outputs/sinks/bag_sink.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// The requested exports.
struct ExportConfig {
  std::optional<BagConfig> bag;  ///< bag/; nothing if it is not requested.
  bool carmen = false;           ///< log.carmen
  bool kitti = false;            ///< kitti/
  bool map = false;              ///< map/map.yaml and map/map.pgm: the localizers' map.
};

/// Writes the map if it is requested, and returns the sinks that write the other formats.
std::vector<std::unique_ptr<RunSink>> export_sinks(const std::filesystem::path& run_folder,
                                                   const RunInfo& info, const RosMap& map,
                                                   const ExportConfig& config);

}  // namespace castaway::testbed
