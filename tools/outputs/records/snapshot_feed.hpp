/// Finds the snapshots of a run as they appear in its folder.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// A picture from snapshots/t<stamp>-<occasion>-<view>.png.
struct Snapshot {
  Stamp stamp{};
  std::string view;  ///< "chase", "overview" or "map".
  std::string png;
};

/// Polls the folder for new pictures.
class SnapshotFeed {
 public:
  explicit SnapshotFeed(const std::filesystem::path& run_folder)
      : folder_(run_folder / "snapshots") {}

  /// Pictures that are new since the last call, sorted by name. Other files are ignored.
  std::vector<Snapshot> take_new();

 private:
  std::filesystem::path folder_;
  std::set<std::string> seen_;
};

}  // namespace castaway::testbed
