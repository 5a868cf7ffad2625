#include "tools/batch/campaign/slurm_campaign.hpp"

#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "tools/base/files/file.hpp"
#include "tools/base/files/json_text.hpp"
#include "tools/base/formats/json_file.hpp"
#include "tools/base/output/interruption.hpp"
#include "tools/base/output/listed_path.hpp"
#include "tools/base/output/progress_line.hpp"
#include "tools/base/output/say.hpp"
#include "tools/batch/campaign/campaign_check.hpp"
#include "tools/batch/campaign/campaign_folder.hpp"
#include "tools/batch/campaign/campaign_run.hpp"
#include "tools/batch/campaign/stopping_rule.hpp"

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
  int tasks = 1;        ///< Shards of the campaign.
  int tries = 1;
};

void save_jobs(const SubmittedJobs& jobs, CampaignFolder& folder) {
  const Json json{{"array", jobs.array},
                  {"collect", jobs.collect},
                  {"tasks", jobs.tasks},
                  {"tries", jobs.tries}};
  folder.put(kJobs, [&](const fs::path& file) { write_file(file, json_text(json, 1) + "\n"); });
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

CampaignCommand command_of(const CampaignRequest& request, const std::string& name) {
  CampaignCommand command{fs::read_symlink("/proc/self/exe"),
                          fs::absolute(request.spec),
                          fs::absolute(request.out),
                          {},
                          name};
  for (const std::string& assignment : request.overrides) {
    command.options.insert(command.options.end(), {"--set", assignment});
  }
  if (request.programs != FilePrograms::kRefused) command.options.emplace_back("--allow-programs");
  if (request.retry_failed) command.options.emplace_back("--retry-failed");
  return command;
}

/// Submits tasks of the array, such as "1-8", and the job behind them.
void submit(const fs::path& folder, const std::string& tasks, SubmittedJobs& jobs) {
  jobs.array = submit_script(folder / kArrayScript, {"--array=" + tasks});
  jobs.collect = submit_script(folder / kCollectScript, {"--dependency=afterany:" + jobs.array});
}

void refuse_running(const CampaignRequest& request) {
  const auto jobs = load_jobs(request.out);
  if (!jobs || (tasks_of(jobs->array).none() && tasks_of(jobs->collect).none())) return;
  throw std::runtime_error(fmt::format(
      "{}: job {} of this campaign is in Slurm's queue; castaway campaign {} --out {} --attach "
      "follows it",
      request.out.string(), jobs->array, request.spec.string(), request.out.string()));
}

/// Shards with missing cells, from 1 on.
std::set<int> unfinished_shards(const CampaignRequest& request, const CampaignSpec& spec,
                                int tasks) {
  RowIndex rows(request.out, spec.cells());
  std::set<int> shards;
  for (const int cell : missing_cells(spec, rows, static_cast<std::size_t>(spec.cells()))) {
    shards.insert(shard_of(spec, cell, tasks));
  }
  return shards;
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
  void show(std::size_t done, int all, const JobTasks& tasks) const {
    show_progress(fmt::format("{} / {} cells; {} tasks run, {} wait", done, all, tasks.running,
                              tasks.waiting));
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
void wait_for(const std::string& job, const CampaignRequest& request, const CampaignSpec& spec) {
  const QueueLine line;
  for (JobTasks tasks = tasks_of(job); !tasks.none(); tasks = tasks_of(job)) {
    if (line.is_shown()) {
      line.show(RowIndex(request.out, spec.cells()).cells().size(), spec.cells(), tasks);
    }
    pause();
  }
}

/// `jobs` becomes what was submitted last.
void follow(const CampaignRequest& request, const CheckedCampaign& campaign, CampaignFolder& folder,
            SubmittedJobs& jobs) {
  const CampaignSpec& spec = campaign.spec;
  wait_for(jobs.array, request, spec);
  while (jobs.tries < kMostTries) {
    const std::set<int> shards = unfinished_shards(request, spec, jobs.tasks);
    if (shards.empty()) break;
    say(fmt::format("shards {} of {} ended with cells missing; submitted again",
                    fmt::join(shards, ", "), jobs.tasks));
    submit(folder.path(), fmt::format("{}", fmt::join(shards, ",")), jobs);
    ++jobs.tries;
    save_jobs(jobs, folder);
    wait_for(jobs.array, request, spec);
  }
  wait_for(jobs.collect, request, spec);
}

int follow_to_the_end(const CampaignRequest& request, const CheckedCampaign& campaign,
                      CampaignFolder& folder, SubmittedJobs jobs) {
  const Interruptible interruptible;
  try {
    follow(request, campaign, folder, jobs);
  } catch (Interrupted& interrupted) {
    interrupted.kept =
        fmt::format("job {} goes on; castaway campaign {} --out {} --attach follows it", jobs.array,
                    request.spec.string(), request.out.string());
    throw;
  }
  return collect_campaign(request);
}

}  // namespace

int make_on_slurm(const CampaignRequest& request, const SlurmOptions& options) {
  const CheckedCampaign campaign = check_campaign(request);
  refuse_running(request);
  CampaignFolder folder(request.out, identity_of(campaign));
  const CampaignCommand command = command_of(request, campaign.spec.name);
  require_no_link(folder.path(), "slurm");
  fs::create_directories(folder.path() / "slurm");
  folder.put(kArrayScript,
             [&](const fs::path& file) { write_file(file, array_script(command, options)); });
  folder.put(kCollectScript,
             [&](const fs::path& file) { write_file(file, collect_script(command, options)); });
  SubmittedJobs jobs;
  jobs.tasks = options.tasks;
  submit(folder.path(), fmt::format("1-{}", options.tasks), jobs);
  save_jobs(jobs, folder);
  say(fmt::format("job {} with {} tasks, and job {} for the tables; logs in {}", jobs.array,
                  jobs.tasks, jobs.collect, (request.out / "slurm").string()));
  return follow_to_the_end(request, campaign, folder, jobs);
}

int follow_on_slurm(const CampaignRequest& request) {
  const CheckedCampaign campaign = check_campaign(request);
  static_cast<void>(CampaignFolder(request.out));
  CampaignFolder folder(request.out, identity_of(campaign));
  const auto jobs = load_jobs(request.out);
  if (!jobs) {
    throw std::runtime_error(request.out.string() +
                             ": was not submitted to Slurm; use --slurm in place of --attach");
  }
  return follow_to_the_end(request, campaign, folder, *jobs);
}

}  // namespace castaway::testbed
