#include "tools/batch/cluster/slurm_job.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/batch/cluster/command_output.hpp"

namespace castaway::testbed {
namespace {

std::string header(const SharedCommand& command, const SlurmOptions& options,
                   const std::string& what) {
  const std::filesystem::path log = command.logs / (what + "-%j.log");
  std::string text = "#!/bin/sh\n";
  const auto add = [&text](const std::string& option) { text += "#SBATCH " + option + "\n"; };
  add("--job-name=" + shell_word(command.name));
  add("--output=" + shell_word(log.string()));
  if (!options.partition.empty()) add("--partition=" + shell_word(options.partition));
  if (!options.time.empty()) add("--time=" + shell_word(options.time));
  for (const std::string& option : options.extra) add(option);
  return text;
}

std::string command_line(const SharedCommand& command) {
  std::string line =
      fmt::format("cd {} && exec {}", shell_word(command.directory), shell_word(command.program));
  for (const std::string& word : command.words) line += " " + shell_word(word);
  return line;
}

/// A number of a job, without the name of a cluster behind it.
std::string job_number(const std::string& printed) {
  const std::size_t end = printed.find_first_not_of("0123456789");
  std::string number = printed.substr(0, end);
  if (number.empty()) throw std::runtime_error("sbatch named no job: " + printed);
  return number;
}

}  // namespace

std::string array_script(const SharedCommand& command, const SlurmOptions& options) {
  return header(command, options, "task") +
         fmt::format(
             "#SBATCH --cpus-per-task={}\n#SBATCH --requeue\n{} -j {} "
             "--shard \"$SLURM_ARRAY_TASK_ID/{}\"\n",
             options.cores, command_line(command), options.cores, options.tasks);
}

std::string collect_script(const SharedCommand& command, const SlurmOptions& options) {
  return header(command, options, "collect") + "#SBATCH --requeue\n" + command_line(command) +
         " --collect\n";
}

std::string submit_script(const std::filesystem::path& script,
                          const std::vector<std::string>& more) {
  std::vector<std::string> words{"sbatch", "--parsable"};
  words.insert(words.end(), more.begin(), more.end());
  words.push_back(script.string());
  return job_number(output_of(words));
}

JobTasks tasks_of(const std::string& job) {
  const CommandOutput result =
      run_command({"squeue", "--noheader", "--array", "--jobs=" + job, "--format=%t"});
  const bool unknown = result.err.find("Invalid job id") != std::string::npos;
  if (result.exit_code != 0 && !unknown) {
    throw std::runtime_error("squeue: " + result.err.substr(0, result.err.find('\n')));
  }
  JobTasks tasks;
  std::istringstream lines(result.out);
  for (std::string state; lines >> state;) {
    ++(state == "PD" || state == "CF" || state == "RQ" ? tasks.waiting : tasks.running);
  }
  return tasks;
}

}  // namespace castaway::testbed
