/// The jobs of a campaign in Slurm.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace castaway::testbed {

/// How a campaign is spread over a Slurm cluster.
struct SlurmOptions {
  std::string partition{};  ///< Empty: Slurm's default.
  std::string time{};       ///< Limit of a task, as sbatch takes it; empty: Slurm's default.
  int tasks = 16;           ///< Of the array: shards of the campaign.
  int cores = 1;            ///< Of a task: its workers.
  std::vector<std::string> extra{};  ///< Further options of sbatch.
};

/// The command of a campaign, which every task runs.
struct CampaignCommand {
  std::filesystem::path program;     ///< castaway
  std::filesystem::path spec;        ///< Absolute.
  std::filesystem::path out;         ///< Absolute.
  std::vector<std::string> options;  ///< --set, --allow-programs
  std::string name;                  ///< Of the campaign.
};

/// Script of the array: task I makes shard I.
std::string array_script(const CampaignCommand& command, const SlurmOptions& options);
/// Script of the job behind it, which makes the tables.
std::string collect_script(const CampaignCommand& command, const SlurmOptions& options);

/// Submits a script; `more`: options in front of it. Returns the number of the job. Throws
/// std::runtime_error with what sbatch says.
std::string submit_script(const std::filesystem::path& script,
                          const std::vector<std::string>& more = {});

/// How many tasks of a job are in each state.
struct JobTasks {
  int waiting = 0;
  int running = 0;

  [[nodiscard]] bool none() const { return waiting == 0 && running == 0; }
};

/// Asks squeue. A job that Slurm does not know any more has none. Throws std::runtime_error if
/// Slurm cannot be asked.
JobTasks tasks_of(const std::string& job);

}  // namespace castaway::testbed
