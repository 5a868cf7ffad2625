/// Plays a scenario in the simulator; shared by `run`, `experiment` and `dataset`.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tools/build/build_localizers.hpp"
#include "tools/build/ros2/bridge_config.hpp"
#include "tools/build/shared_worlds.hpp"
#include "tools/outputs/records/scan_row.hpp"
#include "tools/play/report_writer.hpp"
#include "tools/run/loop.hpp"
#include "tools/scenario/scenario_file.hpp"

namespace castaway::testbed {

/// Makes a further sink of a run; `labels` are those of the run's tables.
using SinkMaker = std::function<std::unique_ptr<RunSink>(
    const RunInfo& info, const std::shared_ptr<const LabelContext>& labels)>;

/// Output folder and printing of a run.
struct PlayOptions {
  std::filesystem::path base;  ///< Folder of the scenario's file, for relative paths.
  std::filesystem::path out;   ///< Run folder.
  bool force = false;          ///< The folder may hold other files, too.
  std::vector<std::filesystem::path> inputs{};  ///< Files that the run reads: `inputs_of`.
  bool keep_list = true;                        ///< As in `OutputRequest`.
  bool json = false;                            ///< Prints summary.json instead of words.
  bool silent = false;                          ///< Prints no result.
  bool quiet = false;                     ///< Prints nothing at all: no progress, no warnings.
  std::filesystem::path video{};          ///< Film of the run; empty: none.
  ReportWriter report{};                  ///< Writes the page, where the scenario asks for one.
  std::optional<BridgeOptions> bridge{};  ///< Lets nodes of ROS 2 look on.
  bool timing = true;                     ///< As in `RunFiles`.
  std::vector<SinkMaker> sinks{};         ///< Further ones.
  std::function<std::unique_ptr<RunSink>()> watcher{};  ///< Makes one that needs no labels.
  std::function<void(const std::string&)> warn{};  ///< Takes warnings; empty: they are printed.
  /// Likeness of places, for labels; nothing: computed where labels are written.
  std::shared_ptr<const PlaceScores> scores{};  // Shared by the runs of a data set.
  SharedWorlds* worlds = nullptr;  ///< Shared by the runs of a process; nullptr: they are built.
  ModelsOfRun models{};
};

/// runs/<scenario>/seed-<n>
std::filesystem::path default_run_folder(const Scenario& scenario);

/// The files that a run of the scenario reads: its own, its world's and its robot's.
std::vector<std::filesystem::path> inputs_of(const Scenario& scenario,
                                             const std::filesystem::path& file);

/// Simulates the scenario, prints nothing and leaves the run folder. Returns the localizers that
/// were left out on the way. Throws std::exception if it fails.
std::vector<LostLocalizer> play_to_the_end(const LoadedScenario& loaded,
                                           const PlayOptions& options);

/// Simulates the scenario, prints nothing and leaves the run folder. Throws std::exception if it
/// fails, or a localizer does.
void play_silently(const LoadedScenario& loaded, const PlayOptions& options);

/// Simulates the scenario and leaves the run folder. Returns kDone or kRunFailed; throws
/// std::exception for a scenario that cannot be built.
int play(const LoadedScenario& loaded, const PlayOptions& options);

}  // namespace castaway::testbed
