/// Plays the runs of a folder, several at a time or in several processes.
#pragma once

#include <functional>
#include <vector>

#include "tools/base/output/runs_folder.hpp"
#include "tools/batch/cluster/slurm_batch.hpp"
#include "tools/batch/jobs/batch_request.hpp"
#include "tools/build/shared_worlds.hpp"

namespace castaway::testbed {

/// Plays the run of an index, in a worker, into its folder, and returns its exit code. `worlds`:
/// those of the worker.
using PlayRun = std::function<int(std::size_t index, SharedWorlds& worlds)>;

/// Plays the runs that `folder` does not hold yet, `workers` at a time, and shows the progress.
/// Returns the exit codes of all. A run that throws, or whose process dies, has kRunFailed, and the
/// reason is printed. Throws Interrupted, with what is kept.
std::vector<int> play_runs(const RunsFolder& folder, int workers, const PlayRun& play_run);

/// How a process of a batch works in its folder of runs.
RunsShare share_of(const BatchRequest& batch);

/// As `play_runs`, of a folder of the shard's runs; `play_run` is given the index among all. To
/// collect, plays none, and throws std::runtime_error naming the runs that are missing.
std::vector<int> make_runs(const RunsFolder& folder, const BatchRequest& batch,
                           const PlayRun& play_run);

/// Says that a shard is done. Returns kRunFailed if one of its runs failed.
int end_shard(const Shard& shard, const std::vector<int>& codes);

/// Plays runs on a cluster, as `follow_on_cluster` does. `folders`: of the runs; scripts and logs
/// are in `<out>.slurm`.
int follow_runs(const std::filesystem::path& out, const std::string& name,
                const std::vector<std::filesystem::path>& folders,
                const std::function<int()>& collect, const ClusterRequest& cluster);

}  // namespace castaway::testbed
