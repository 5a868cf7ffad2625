#include "tools/commands/arguments/batch_arguments.hpp"

#include <stdexcept>

#include "tools/batch/cluster/repeated_command.hpp"
#include "tools/batch/jobs/kept_trials.hpp"
#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {
namespace {

/// Refuses options of Slurm where nothing is submitted.
void require_slurm(const ClusterRequest& cluster) {
  const SlurmOptions none;
  const SlurmOptions& options = cluster.options;
  const bool given = !options.partition.empty() || !options.time.empty() ||
                     options.tasks != none.tasks || !options.extra.empty();
  if (cluster.slurm || !given) return;
  throw std::invalid_argument("--partition, --time, --array-size and --sbatch go with --slurm");
}

void add_slurm_options(Command& command, ClusterRequest& cluster, const std::string& unit) {
  SlurmOptions& options = cluster.options;
  command.add_flag("--slurm", cluster.slurm,
                   "Submit the " + unit + " to Slurm as an array of shards, and follow them");
  command.add_flag("--attach", cluster.attach, "Follow the jobs that --slurm submitted");
  command.add_option("--partition", options.partition, "Slurm's partition");
  command.add_option("--time", options.time, "Slurm's time limit of a task, such as 2:00:00");
  command.add_option("--array-size", options.tasks, "Tasks of the array, each with -j cores")
      .range(1, 100000)
      .show_default();
  command.add_option("--sbatch", options.extra, "Further option of sbatch, such as --mem=1G")
      .repeatable();
}

}  // namespace

void BatchArguments::check() {
  request.out = out;
  const int ways = (cluster.slurm ? 1 : 0) + (cluster.attach ? 1 : 0) + (request.collect ? 1 : 0) +
                   (shard.empty() ? 0 : 1);
  if (ways > 1) {
    throw std::invalid_argument("give one of --slurm, --attach, --shard and --collect");
  }
  if (out.empty() && (ways > 0 || request.retry_failed)) {
    throw std::invalid_argument(
        "--slurm, --attach, --shard, --collect and --retry-failed need --out DIR");
  }
  require_slurm(cluster);
  if (!shard.empty()) request.shard = parse_shard(shard);
  cluster.options.cores = request.workers;
}

void add_sharing_options(Command& command, BatchArguments& arguments, const std::string& unit) {
  command.add_option("--shard", arguments.shard,
                     "I/N: make every N-th of the " + unit +
                         ", from the I-th on; the other processes make the rest in the same "
                         "folder");
  command.add_flag(
      "--collect", arguments.request.collect,
      "Show the results when all shards are done; names the " + unit + " that are missing");
  add_slurm_options(command, arguments.cluster, unit);
}

void add_batch_options(Command& command, BatchArguments& arguments, const std::string& unit) {
  BatchRequest& request = arguments.request;
  command.add_option("-j,--jobs", request.workers, "At a time: " + unit)
      .range(1, 1024)
      .show_default();
  Option out = command.add_option("--out", arguments.out,
                                  "Folder that keeps the results, to create or to go on in");
  if (!arguments.out.empty()) out.show_default();
  command.add_flag("--retry-failed", request.retry_failed, "Make failed " + unit + " again");
  add_sharing_options(command, arguments, unit);
}

JobIdentity identity_of_command(const std::string& kind) {
  const std::vector<std::string> words = asked_words(own_words());
  return identity_of_this_program(kind, hash_of_named_files(words),
                                  "command: " + emit_yaml(write_yaml(words)) + "\n");
}

int follow_trials(const std::string& kind, int trials, const BatchArguments& arguments,
                  const std::function<int(const BatchRequest&)>& collect) {
  BatchRequest request = arguments.request;
  if (arguments.cluster.attach) require_job_folder(request.out, kind);
  const JobFolder folder(request.out, identity_of_command(kind));
  request.collect = true;
  return follow_on_cluster(
      {folder.path(), kind, "trials", trials,
       [&] { return jobs_without_row(folder.path(), trials); }, [&] { return collect(request); }},
      arguments.cluster);
}

}  // namespace castaway::testbed
