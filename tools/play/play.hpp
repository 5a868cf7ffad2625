/// Plays a scenario in the simulator: what `run` and `experiment` share.
#pragma once

#include <filesystem>

#include "tools/play/execute.hpp"
#include "tools/scenario/scenario_file.hpp"

namespace castaway::testbed {

/// Where a run goes and what it says.
struct PlayOptions {
  std::filesystem::path base;  ///< Folder of the scenario's file, for relative paths.
  std::filesystem::path out;   ///< Run folder.
  bool force = false;          ///< It may hold other files, too.
  std::vector<std::filesystem::path> inputs{};  ///< Files that the run reads: `inputs_of`.
  bool keep_list = true;                        ///< As in `RunPlan`.
  bool json = false;                            ///< Prints summary.json instead of words.
  bool silent = false;                          ///< Prints no result.
  bool quiet = false;              ///< Prints nothing at all: no progress, no warnings.
  std::filesystem::path video{};   ///< Film of the run; empty: none.
  bool timing = true;              ///< As in `RunPlan`.
  std::vector<SinkMaker> sinks{};  ///< Further ones; these are given labels, too.
  /// How alike places look, for labels; nothing: found out if labels are asked for.
  std::shared_ptr<const PlaceScores> scores{};  // Shared by the runs of a data set.
};

/// runs/<scenario>/seed-<n>
std::filesystem::path default_run_folder(const Scenario& scenario);

/// The files that a run of the scenario reads: its own, its world's and its robot's.
std::vector<std::filesystem::path> inputs_of(const Scenario& scenario,
                                             const std::filesystem::path& file);

/// Plays it without a word and leaves its run folder; throws std::exception where it fails.
void play_silently(const LoadedScenario& loaded, const PlayOptions& options);

/// Plays it and leaves its run folder. Returns the exit code, kDone or kRunFailed; throws
/// std::exception for a scenario that cannot be built.
int play(const LoadedScenario& loaded, const PlayOptions& options);

}  // namespace castaway::testbed
