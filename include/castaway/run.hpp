/// Runs of a scenario, with localizers of your own.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "castaway/grid.hpp"
#include "castaway/localizer.hpp"
#include "castaway/scenario.hpp"

namespace castaway {

/// What a localizer of your own is told before a run.
struct LocalizerSetup {
  std::string name;        ///< Of the localizer in the run.
  std::uint64_t seed = 0;  ///< Root of its random numbers.
  OccupancyGrid map;
};

/// A localizer of your own.
struct OwnLocalizer {
  std::string name;  ///< Names it in the run and in files.
  /// Makes it, for each run or trial anew. What it throws reaches the caller of the run, as do
  /// exceptions of the localizer.
  std::function<std::unique_ptr<Localizer>(const LocalizerSetup& setup)> make;
};

/// A text as `--localizer` takes it ("mh_amcl", "amcl:amcl-recovery", "program:python3 mine.py",
/// "library:./libmine.so"), or a localizer of your own.
using AnyLocalizer = std::variant<std::string, OwnLocalizer>;

/// What a run leaves besides its folder.
struct RunResult {
  std::string summary;                        ///< summary.json (docs/formats.md).
  std::map<std::string, std::string> failed;  ///< Why, by localizer that the run went on without.
  std::vector<std::string> missed;            ///< Expectations that were not met, a sentence each.
  std::vector<std::string> warnings;  ///< About the robot, the world and the run, a sentence each.
};

/// Where a run lies, and who rides on it.
struct RunOptions {
  std::filesystem::path out;               ///< The run folder.
  std::vector<AnyLocalizer> localizers{};  ///< Instead of the scenario's; empty: those.
  bool force = false;                      ///< The folder may hold other files, too.
};

/// Simulates a scenario as `castaway run` does, prints nothing, and leaves the same files in the
/// run folder. Files that castaway did not write are never replaced. @throws std::runtime_error or
/// std::invalid_argument with the program's text; then nothing is left in the folder.
RunResult run(const Scenario& scenario, const RunOptions& options);

}  // namespace castaway
