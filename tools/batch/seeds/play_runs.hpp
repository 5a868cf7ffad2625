/// Plays the runs of a folder, several at a time.
#pragma once

#include <functional>
#include <vector>

#include "tools/base/output/runs_folder.hpp"
#include "tools/build/shared_worlds.hpp"

namespace castaway::testbed {

/// Plays the run of an index, in a worker, into its folder, and returns its exit code. `worlds`:
/// those of the worker.
using PlayRun = std::function<int(std::size_t index, SharedWorlds& worlds)>;

/// Plays the runs that `folder` does not hold yet, `workers` at a time, and shows the progress.
/// Returns the exit codes of all. A run that throws, or whose process dies, has kRunFailed, and the
/// reason is printed. Throws Interrupted, with what is kept.
std::vector<int> play_runs(const RunsFolder& folder, int workers, const PlayRun& play_run);

}  // namespace castaway::testbed
