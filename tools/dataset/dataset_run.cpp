#include "tools/dataset/dataset_run.hpp"

#include <sys/resource.h>

#include <fmt/format.h>

#include "tools/dataset/dataset_finish.hpp"
#include "tools/dataset/dataset_folder.hpp"
#include "tools/dataset/dataset_sequence.hpp"
#include "tools/files/file_error.hpp"
#include "tools/output/exit_code.hpp"
#include "tools/play/progress.hpp"
#include "tools/run/cpu_clock.hpp"
#include "tools/workers/worker_notes.hpp"
#include "tools/workers/worker_pool.hpp"

namespace castaway::testbed {
namespace {

constexpr int kTold = 4;            // Exit code of a worker that left a note about its failure.
constexpr char kDiskTrouble = '!';  // First character of a note about a disk error, which would
                                    // also stop the other workers.

/// Draws every sequence and builds every world, so that errors are found before anything is made.
void check_all(const DatasetSpec& spec, int count, DatasetWorlds& worlds) {
  for (int i = 0; i < count; ++i) {
    const SampledSequence sequence = sample_sequence(spec, i);
    try {
      worlds.check(sequence.loaded.scenario);
    } catch (const std::exception& error) {
      throw std::runtime_error(sequence_trouble(spec, sequence, error.what()));
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

/// Makes one sequence; runs in its own process.
int work_on(const DatasetSpec& spec, const DatasetWorlds& worlds, const DatasetFolder& folder,
            const WorkerNotes& notes, int index) {
  try {
    const std::string name = sequence_name(index);
    make_sequence(spec, worlds, sample_sequence(spec, index), folder.draft(name));
    folder.commit_sequence(name);
    return kDone;
  } catch (const FileError& error) {
    throw_if_interrupted();
    notes.leave(kDiskTrouble + std::string(error.what()));
  } catch (const std::exception& error) {
    throw_if_interrupted();
    notes.leave(error.what());
  }
  return kTold;
}

/// Result of a pass over the missing sequences.
struct Pass {
  int made = 0;
  int failed = 0;
  std::string disk_trouble{};  ///< The first disk error; empty if there was none.
};

/// Prints the notes; a disk error is kept and reported once, at the end.
void take_notes(const std::vector<std::string>& notes, Pass& pass) {
  for (const std::string& note : notes) {
    if (note.front() != kDiskTrouble) {
      fmt::print(stderr, "castaway: {}\n", note);
    } else if (pass.disk_trouble.empty()) {
      pass.disk_trouble = note.substr(1);
    }
  }
}

Pass make_sequences(const DatasetSpec& spec, const DatasetWorlds& worlds,
                    const DatasetFolder& folder, const DatasetRequest& request,
                    const std::vector<int>& missing) {
  const auto count = static_cast<int>(missing.size());
  CampaignProgress progress(count, "sequences");
  WorkerNotes notes;
  Pass pass;
  const auto index_of = [&](int job) { return missing[static_cast<std::size_t>(job)]; };
  run_jobs(
      count, request.workers,
      [&](int job) { return work_on(spec, worlds, folder, notes, index_of(job)); },
      [&](int job, int code) {
        take_notes(notes.take(), pass);
        if (code != kDone && code != kTold) {
          fmt::print(stderr, "castaway: sequence {}: its process was killed\n", index_of(job));
        }
        ++(code == kDone ? pass.made : pass.failed);
        progress.next("");
      },
      [&] { return !pass.disk_trouble.empty(); });
  return pass;
}

int incomplete(const DatasetFolder& folder, const DatasetRequest& request, const Pass& pass) {
  folder.clear_work();
  const std::size_t missing = missing_sequences(folder, request.sequences).size();
  fmt::print(
      stderr,
      "castaway: {}: {} of {} sequences are finished; the same command resumes with the rest\n",
      pass.disk_trouble.empty() ? folder.path().string() : pass.disk_trouble,
      static_cast<std::size_t>(request.sequences) - missing, request.sequences);
  return kRunFailed;
}

/// CPU time and peak memory of all workers that have ended.
DatasetMaking workers_cost() {
  rusage used{};
  getrusage(RUSAGE_CHILDREN, &used);
  const auto seconds_of = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  DatasetMaking making;
  making.cpu_s = seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
  making.largest_mb = static_cast<double>(used.ru_maxrss) / 1024.0;
  return making;
}

std::vector<std::string> names_of(int count) {
  std::vector<std::string> names;
  for (int i = 0; i < count; ++i) names.push_back(sequence_name(i));
  return names;
}

/// Clears the drafts and reports what is kept after an interruption.
[[noreturn]] void tell_kept(Interrupted interrupted, const DatasetFolder& folder,
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
  const std::vector<int> missing = missing_sequences(folder, request.sequences);
  for (const int index : missing) worlds.ask_scores(sample_sequence(spec, index).loaded.scenario);
  worlds.find_scores(request.workers, folder.path() / ".work");
  const std::chrono::nanoseconds begin = wall_time();
  const double cpu_before = workers_cost().cpu_s;
  const Pass pass = make_sequences(spec, worlds, folder, request, missing);
  if (pass.failed > 0) return incomplete(folder, request, pass);
  DatasetMaking making = workers_cost();
  making.cpu_s -= cpu_before;
  making.made = pass.made;
  making.workers = request.workers;
  making.wall_s = seconds(wall_time() - begin);
  const DatasetContents contents =
      load_contents(folder, spec, names_of(request.sequences), worlds.maps());
  finish_dataset(folder, contents);
  fmt::print("{}", request.json ? dataset_json(folder, contents, making)
                                : describe_dataset(folder, contents, making));
  return kDone;
}

}  // namespace

int make_dataset(const DatasetRequest& request) {
  const DatasetSpec spec = load_dataset_spec(request.spec, request.overrides);
  const DatasetIdentity identity{CASTAWAY_VERSION, spec.seed, request.sequences, spec.effective};
  check_identity(request.out, identity);
  DatasetWorlds worlds(spec.base);
  check_all(spec, request.sequences, worlds);
  try {
    const DatasetFolder folder(request.out, identity);
    if (!folder.is_finished()) {
      try {
        return make_in(folder, spec, worlds, request);
      } catch (const Interrupted& interrupted) {
        tell_kept(interrupted, folder, request);
      }
    }
    if (!request.json) {
      fmt::print("{}: all {} sequences are already finished\n", request.out.string(),
                 request.sequences);
      return kDone;
    }
    const DatasetContents contents =
        load_contents(folder, spec, names_of(request.sequences), worlds.maps());
    fmt::print("{}", dataset_json(folder, contents, {}));
    return kDone;
  } catch (const FileError& error) {
    fmt::print(stderr, "castaway: {}\n", error.what());
    return kRunFailed;
  }
}

}  // namespace castaway::testbed
