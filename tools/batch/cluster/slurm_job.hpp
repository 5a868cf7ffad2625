/// The jobs of a batch in Slurm.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace castaway::testbed {

/// How a batch is spread over a Slurm cluster.
struct SlurmOptions {
  std::string partition{};  ///< Empty: Slurm's default.
  std::string time{};       ///< Limit of a task, as sbatch takes it; empty: Slurm's default.
  int tasks = 16;           ///< Of the array: shards of the batch.
  int cores = 1;            ///< Of a task: its workers.
  std::vector<std::string> extra{};  ///< Further options of sbatch.
};

/// The command that every task runs.
struct SharedCommand {
  std::filesystem::path program;    ///< castaway
  std::filesystem::path directory;  ///< In which it runs. Absolute.
  std::filesystem::path logs;       ///< Folder of what the tasks print. Absolute.
  std::vector<std::string> words;   ///< `shared_words`
  std::string name;                 ///< Of the job.
};

/// Script of the array: task I makes shard I.
std::string array_script(const SharedCommand& command, const SlurmOptions& options);
/// Script of the job behind it, which makes the tables.
std::string collect_script(const SharedCommand& command, const SlurmOptions& options);

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
