/// The function that writes the page of a run. Pages are on a higher floor: commands pass it down.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "tools/base/formats/level_map.hpp"
#include "tools/base/formats/ros_map.hpp"

namespace castaway::testbed {

/// What paths are drawn on.
struct ReportMaps {
  std::optional<RosMap> map;
  LevelMaps levels{};  ///< Of a run on several floors, drawn in place of the map.
};

/// Writes the page of a run that is over into its folder.
using ReportWriter =
    std::function<void(const std::filesystem::path& run_folder, const ReportMaps& maps)>;

}  // namespace castaway::testbed
