#include "tools/batch/dataset/dataset_run.hpp"

#include <sys/resource.h>

#include <chrono>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "tools/base/files/file_error.hpp"
#include "tools/base/output/any_error.hpp"
#include "tools/base/output/exit_code.hpp"
#include "tools/base/output/interruption.hpp"
#include "tools/base/output/say.hpp"
#include "tools/base/process/cpu_clock.hpp"
#include "tools/base/process/worker_pool.hpp"
#include "tools/batch/dataset/dataset_finish.hpp"
#include "tools/batch/dataset/dataset_folder.hpp"
#include "tools/batch/dataset/dataset_sequence.hpp"
#include "tools/batch/jobs/job_folder.hpp"
#include "tools/play/progress.hpp"

namespace castaway::testbed {
namespace {

// First characters of what a worker answers for a sequence that it could not make.
constexpr char kFailed = '?';
constexpr char kDiskError = '!';  // It would stop the other workers, too.

/// Draws every sequence and builds every world, so that errors are found before anything is made.
void check_all(const DatasetSpec& spec, int count, DatasetWorlds& worlds) {
  for (int i = 0; i < count; ++i) {
    const SampledSequence sequence = sample_sequence(spec, i);
    try {
      worlds.check(sequence.loaded.scenario);
    } catch (...) {
      throw std::runtime_error(sequence_error(spec, sequence, current_error_text()));
    }
  }
}

std::vector<int> missing_sequences(const DatasetFolder& folder, int count) {
  std::vector<int> missing;
  for (int i = 0; i < count; ++i) {
    if (!folder.has_sequence(sequence_name(i))) missing.push_back(i);
  }
  return missing;
}

/// Those of the missing ones that this process makes.
std::vector<int> sequences_to_make(const DatasetFolder& folder, const DatasetRequest& request) {
  std::vector<int> own = missing_sequences(folder, request.sequences);
  std::erase_if(own, [&](int i) { return request.batch.collect || !request.batch.shard.makes(i); });
  return own;
}

/// Makes one sequence, in a worker. Returns nothing, or why it failed.
std::string make_one(const DatasetSpec& spec, const DatasetWorlds& worlds,
                     const DatasetFolder& folder, PartsOfSequences& parts, int index) {
  try {
    const std::string name = sequence_name(index);
    make_sequence(spec, worlds, sample_sequence(spec, index), folder.draft(name), parts);
    folder.commit_sequence(name);
    return "";
  } catch (const FileError& error) {
    throw_if_interrupted();
    return kDiskError + std::string(error.what());
  } catch (...) {
    throw_if_interrupted();
    return kFailed + current_error_text();
  }
}

/// Result of a pass over the missing sequences.
struct Pass {
  int made = 0;
  int failed = 0;
  std::string disk_error{};  ///< The first disk error; empty if there was none.
};

/// Counts a sequence. Prints why it failed; a disk error is kept and reported once, at the end.
void count_in(const std::string& answer, Pass& pass) {
  ++(answer.empty() ? pass.made : pass.failed);
  if (answer.empty()) return;
  if (answer.front() == kFailed) {
    say(answer.substr(1));
  } else if (pass.disk_error.empty()) {
    pass.disk_error = answer.substr(1);
  }
}

Pass make_sequences(const DatasetSpec& spec, const DatasetWorlds& worlds,
                    const DatasetFolder& folder, const DatasetRequest& request,
                    const std::vector<int>& missing) {
  CampaignProgress progress(static_cast<int>(missing.size()), "sequences");
  Pass pass;
  JobOutcomes outcomes;
  outcomes.on_result = [&](int, const std::string& answer) {
    count_in(answer, pass);
    progress.next("");
  };
  outcomes.on_failure = [&](int index, const std::string& reason) {
    outcomes.on_result(index, kFailed + sequence_error(spec, sample_sequence(spec, index), reason));
  };
  outcomes.stopped = [&] { return !pass.disk_error.empty(); };
  PartsOfSequences parts{request.report};  // Each worker fills its own.
  const auto work = [&](int index) { return make_one(spec, worlds, folder, parts, index); };
  work_through(missing, request.batch.workers, work, outcomes);
  return pass;
}

int incomplete(const DatasetFolder& folder, const DatasetRequest& request, const Pass& pass) {
  folder.clear_work();
  const std::size_t missing = missing_sequences(folder, request.sequences).size();
  say(fmt::format("{}: {} of {} sequences are finished; {}",
                  pass.disk_error.empty() ? folder.path().string() : pass.disk_error,
                  static_cast<std::size_t>(request.sequences) - missing, request.sequences,
                  request.batch.collect ? "run the shards of the rest again"
                                        : "the same command resumes with the rest"));
  return kRunFailed;
}

int end_shard(const DatasetFolder& folder, const DatasetRequest& request, const Pass& pass) {
  folder.clear_work();
  print_out(
      "Shard {} of {}: {} sequences made; the same command with --collect in place of --shard "
      "finishes the data set when all are done\n",
      request.batch.shard.index, request.batch.shard.count, pass.made);
  return kDone;
}

/// CPU time and peak memory of all workers that have ended.
DatasetInvocation workers_cost() {
  rusage used{};
  getrusage(RUSAGE_CHILDREN, &used);
  const auto seconds_of = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  DatasetInvocation invocation;
  invocation.cpu_s = seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
  invocation.largest_mb = static_cast<double>(used.ru_maxrss) / 1024.0;
  return invocation;
}

std::vector<std::string> sequence_names(int count) {
  std::vector<std::string> names;
  for (int i = 0; i < count; ++i) names.push_back(sequence_name(i));
  return names;
}

/// Clears the drafts and reports what is kept after an interruption.
[[noreturn]] void report_kept(Interrupted interrupted, const DatasetFolder& folder,
                              const DatasetRequest& request) {
  folder.clear_work();
  const std::size_t missing = missing_sequences(folder, request.sequences).size();
  interrupted.kept = fmt::format(
      "{}: {} of {} sequences are finished; the same command resumes", folder.path().string(),
      static_cast<std::size_t>(request.sequences) - missing, request.sequences);
  throw interrupted;
}

int make_in(const DatasetFolder& folder, const DatasetSpec& spec, DatasetWorlds& worlds,
            const DatasetRequest& request) {
  const std::vector<int> missing = sequences_to_make(folder, request);
  for (const int index : missing)
    worlds.request_scores(sample_sequence(spec, index).loaded.scenario);
  worlds.compute_scores(request.batch.workers);
  const std::chrono::nanoseconds begin = wall_time();
  const double cpu_before = workers_cost().cpu_s;
  const Pass pass = make_sequences(spec, worlds, folder, request, missing);
  if (pass.failed > 0) return incomplete(folder, request, pass);
  if (!request.batch.shard.is_all()) return end_shard(folder, request, pass);
  if (!missing_sequences(folder, request.sequences).empty()) {
    return incomplete(folder, request, pass);
  }
  DatasetInvocation invocation = workers_cost();
  invocation.cpu_s -= cpu_before;
  invocation.made = pass.made;
  invocation.workers = request.batch.workers;
  invocation.wall_s = seconds(wall_time() - begin);
  const DatasetContents contents =
      load_contents(folder, spec, sequence_names(request.sequences), worlds.maps());
  finish_dataset(folder, contents, request.pages);
  print_out("{}", request.json ? dataset_json(folder, contents, invocation)
                               : describe_dataset(folder, contents, invocation));
  return kDone;
}

DatasetIdentity identity_of(const DatasetSpec& spec, const DatasetRequest& request) {
  return {CASTAWAY_VERSION, spec.seed, request.sequences, spec.effective};
}

}  // namespace

int make_dataset(const DatasetRequest& request) {
  const DatasetSpec spec = load_dataset_spec(request.spec, request.overrides);
  const DatasetIdentity identity = identity_of(spec, request);
  check_identity(request.batch.out, identity);
  if (request.batch.collect) require_job_folder(request.batch.out, "dataset");
  std::optional<KeptWork> kept;
  if (std::filesystem::exists(request.batch.out / "dataset.json")) {
    kept.emplace("finished sequences are kept in " + request.batch.out.string() +
                 "; the same command resumes");
  }
  DatasetWorlds worlds(spec.base);
  check_all(spec, request.sequences, worlds);
  try {
    const DatasetFolder folder(request.batch.out, identity, request.batch.shard);
    if (!folder.is_finished()) {
      try {
        return make_in(folder, spec, worlds, request);
      } catch (const Interrupted& interrupted) {
        report_kept(interrupted, folder, request);
      }
    }
    if (!request.json) {
      print_out("{}: all {} sequences are already finished\n", request.batch.out.string(),
                request.sequences);
      return kDone;
    }
    const DatasetContents contents =
        load_contents(folder, spec, sequence_names(request.sequences), worlds.maps());
    print_out("{}", dataset_json(folder, contents, {}));
    return kDone;
  } catch (const FileError& error) {
    say(error.what());
    return kRunFailed;
  }
}

int make_dataset_on_slurm(DatasetRequest request, const ClusterRequest& cluster) {
  const DatasetSpec spec = load_dataset_spec(request.spec, request.overrides);
  const DatasetIdentity identity = identity_of(spec, request);
  check_identity(request.batch.out, identity);
  if (cluster.attach) require_job_folder(request.batch.out, "dataset");
  static_cast<void>(DatasetFolder(request.batch.out, identity));
  const auto missing = [&] {
    std::vector<int> found = jobs_up_to(request.sequences);
    std::erase_if(found, [&](int i) {
      return std::filesystem::exists(request.batch.out / "sequences" / sequence_name(i));
    });
    return found;
  };
  request.batch.collect = true;
  return follow_on_cluster({folder_beside(request.batch.out, ".slurm"), spec.name, "sequences",
                            request.sequences, missing, [&] { return make_dataset(request); }},
                           cluster);
}

}  // namespace castaway::testbed
