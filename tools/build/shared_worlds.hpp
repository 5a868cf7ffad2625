/// Worlds that the runs of one process have in common.
#pragma once

#include <filesystem>
#include <memory>

#include "tools/base/process/latest_few.hpp"
#include "tools/build/build_world.hpp"

namespace castaway::testbed {

/// Worlds with their surveys and free spaces, built once; the latest few are kept. What a run gets
/// does not depend on whether it was built before.
class SharedWorlds {
 public:
  /// As `build_world`. A world that the difference layer changes is built for each run.
  std::shared_ptr<const LoadedWorld> get(const WorldChoice& choice,
                                         const std::filesystem::path& base,
                                         const SurveyOptions& options);

 private:
  LatestFew<LoadedWorld> worlds_;
};

}  // namespace castaway::testbed
