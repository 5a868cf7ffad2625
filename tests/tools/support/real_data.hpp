/// Recorded logs of real robots, which are not part of the project.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>

namespace castaway::testbed {

inline constexpr const char* kNoRealData =
    "no recorded logs: set CASTAWAY_REAL_DATA to the folder that holds intel/, aces/...";

/// Folder of the logs: $CASTAWAY_REAL_DATA, or shared/data/real beside the source tree.
inline std::optional<std::filesystem::path> real_data() {
  const char* given = std::getenv("CASTAWAY_REAL_DATA");
  const std::filesystem::path folder =
      given != nullptr ? std::filesystem::path(given)
                       : std::filesystem::path(CASTAWAY_SOURCE_DIR) / "../shared/data/real";
  if (!std::filesystem::exists(folder / "intel/map.yaml")) return std::nullopt;
  return folder;
}

}  // namespace castaway::testbed
