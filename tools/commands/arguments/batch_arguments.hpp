/// Options of commands that make many jobs.
#pragma once

#include <functional>
#include <string>

#include "tools/batch/cluster/slurm_batch.hpp"
#include "tools/batch/jobs/batch_request.hpp"
#include "tools/batch/jobs/job_folder.hpp"
#include "tools/commands/arguments/command_line.hpp"

namespace castaway::testbed {

/// Values of the options.
struct BatchArguments {
  BatchRequest request;
  ClusterRequest cluster;
  std::string out;
  std::string shard;

  /// True if several processes share the jobs.
  [[nodiscard]] bool is_shared() const {
    return request.collect || cluster.slurm || cluster.attach || !shard.empty();
  }
  /// Reads the texts. Throws std::invalid_argument naming the options that do not go together, or
  /// that need --out.
  void check();
};

/// The options --shard, --collect and those of Slurm. `unit`: plural of what is made.
void add_sharing_options(Command& command, BatchArguments& arguments, const std::string& unit);

/// These, and -j, --out and --retry-failed.
void add_batch_options(Command& command, BatchArguments& arguments, const std::string& unit);

/// What a batch is that a command line asks for: its words, and the files that they name. `kind`
/// names the files of its folder.
JobIdentity identity_of_command(const std::string& kind);

/// Makes kept trials on a cluster, as `follow_on_cluster` does. `collect`: shows the results; it
/// is given what to collect. `kind`: as in `identity_of_command`.
int follow_trials(const std::string& kind, int trials, const BatchArguments& arguments,
                  const std::function<int(const BatchRequest&)>& collect);

}  // namespace castaway::testbed
