#include "tools/batch/cluster/slurm_batch.hpp"

#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "tools/base/files/json_text.hpp"
#include "tools/base/formats/json_file.hpp"
#include "tools/base/output/interruption.hpp"
#include "tools/base/output/listed_path.hpp"
#include "tools/base/output/make_folder.hpp"
#include "tools/base/output/own_file.hpp"
#include "tools/base/output/progress_line.hpp"
#include "tools/base/output/say.hpp"
#include "tools/batch/cluster/repeated_command.hpp"
#include "tools/batch/jobs/shard.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kJobs = "slurm.json";
constexpr const char* kArrayScript = "array.sh";
constexpr const char* kCollectScript = "collect.sh";
constexpr int kMostTries = 3;

/// What was submitted.
struct SubmittedJobs {
  std::string array;    ///< Number of the job.
  std::string collect;  ///< Of the job behind it.
  int tasks = 1;        ///< Shards of the batch.
  int tries = 1;
};

void save_jobs(const SubmittedJobs& jobs, const fs::path& folder) {
  const Json json{{"array", jobs.array},
                  {"collect", jobs.collect},
                  {"tasks", jobs.tasks},
                  {"tries", jobs.tries}};
  write_own_file(folder / kJobs, json_text(json, 1) + "\n");
}

std::optional<SubmittedJobs> load_jobs(const fs::path& folder) {
  std::error_code none;
  if (!fs::exists(folder / kJobs, none)) return std::nullopt;
  const Json json = read_json(folder / kJobs);
  SubmittedJobs jobs;
  read_fields(folder / kJobs, [&] {
    jobs = {json.at("array").get<std::string>(), json.at("collect").get<std::string>(),
            json.at("tasks").get<int>(), json.at("tries").get<int>()};
  });
  return jobs;
}

/// The command that follows the jobs of this one.
std::string attaching_command() {
  std::string line = "castaway";
  for (const std::string& word : shared_words(own_words())) line += " " + word;
  return line + " --attach";
}

SharedCommand command_of(const SlurmBatch& batch) {
  return {fs::read_symlink("/proc/self/exe"), fs::current_path(),
          fs::absolute(batch.folder) / "slurm", shared_words(own_words()), batch.name};
}

/// Submits tasks of the array, such as "1-8", and the job behind them.
void submit(const fs::path& folder, const std::string& tasks, SubmittedJobs& jobs) {
  jobs.array = submit_script(folder / kArrayScript, {"--array=" + tasks});
  jobs.collect = submit_script(folder / kCollectScript, {"--dependency=afterany:" + jobs.array});
}

void refuse_running(const fs::path& folder) {
  const auto jobs = load_jobs(folder);
  if (!jobs || (tasks_of(jobs->array).none() && tasks_of(jobs->collect).none())) return;
  throw std::runtime_error(fmt::format("{}: its job {} is in Slurm's queue; {} follows it",
                                       folder.string(), jobs->array, attaching_command()));
}

/// One line on a terminal.
class QueueLine {
 public:
  QueueLine() : terminal_(isatty(fileno(stderr)) != 0) {}
  ~QueueLine() {
    if (terminal_) show_progress("");
  }
  QueueLine(const QueueLine&) = delete;
  QueueLine& operator=(const QueueLine&) = delete;

  [[nodiscard]] bool is_shown() const { return terminal_; }
  static void show(const SlurmBatch& batch, const JobTasks& tasks) {
    const std::size_t done =
        batch.done ? batch.done() : static_cast<std::size_t>(batch.all) - batch.missing().size();
    show_progress(fmt::format("{} / {} {}; {} tasks run, {} wait", done, batch.all, batch.unit,
                              tasks.running, tasks.waiting));
  }

 private:
  bool terminal_;
};

void pause() {
  constexpr auto kStep = std::chrono::milliseconds(100);
  constexpr int kSteps = 20;
  for (int i = 0; i < kSteps; ++i) {
    throw_if_interrupted();
    std::this_thread::sleep_for(kStep);
  }
}

/// Waits until a job has no task left.
void wait_for(const std::string& job, const SlurmBatch& batch) {
  const QueueLine line;
  for (JobTasks tasks = tasks_of(job); !tasks.none(); tasks = tasks_of(job)) {
    if (line.is_shown()) QueueLine::show(batch, tasks);
    pause();
  }
}

/// `jobs` becomes what was submitted last.
void follow(const SlurmBatch& batch, SubmittedJobs& jobs) {
  wait_for(jobs.array, batch);
  while (jobs.tries < kMostTries) {
    const std::vector<int> shards = shards_of(batch.missing(), jobs.tasks);
    if (shards.empty()) break;
    say(fmt::format("shards {} of {} ended with {} missing; submitted again",
                    fmt::join(shards, ", "), jobs.tasks, batch.unit));
    submit(batch.folder, fmt::format("{}", fmt::join(shards, ",")), jobs);
    ++jobs.tries;
    save_jobs(jobs, batch.folder);
    wait_for(jobs.array, batch);
  }
  wait_for(jobs.collect, batch);
}

SubmittedJobs submit_all(const SlurmBatch& batch, const SlurmOptions& options) {
  const fs::path& folder = batch.folder;
  refuse_running(folder);
  make_folder(folder);
  const SharedCommand command = command_of(batch);
  require_no_link(folder, "slurm");
  fs::create_directories(folder / "slurm");
  write_own_file(folder / kArrayScript, array_script(command, options));
  write_own_file(folder / kCollectScript, collect_script(command, options));
  SubmittedJobs jobs;
  jobs.tasks = options.tasks;
  submit(folder, fmt::format("1-{}", options.tasks), jobs);
  save_jobs(jobs, batch.folder);
  say(fmt::format("job {} with {} tasks, and job {} for the tables; logs in {}", jobs.array,
                  jobs.tasks, jobs.collect, (folder / "slurm").string()));
  return jobs;
}

SubmittedJobs submitted_before(const fs::path& folder) {
  if (auto jobs = load_jobs(folder)) return *jobs;
  throw std::runtime_error(folder.string() +
                           ": was not submitted to Slurm; use --slurm in place of --attach");
}

}  // namespace

int follow_on_cluster(const SlurmBatch& batch, const ClusterRequest& request) {
  SubmittedJobs jobs =
      request.slurm ? submit_all(batch, request.options) : submitted_before(batch.folder);
  const Interruptible interruptible;
  try {
    follow(batch, jobs);
  } catch (Interrupted& interrupted) {
    interrupted.kept =
        fmt::format("job {} goes on; {} follows it", jobs.array, attaching_command());
    throw;
  }
  return batch.collect();
}

fs::path folder_beside(fs::path folder, const std::string& ending) {
  if (!folder.has_filename()) folder = folder.parent_path();
  return folder += ending;
}

}  // namespace castaway::testbed
