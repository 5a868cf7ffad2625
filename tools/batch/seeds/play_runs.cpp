#include "tools/batch/seeds/play_runs.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tools/base/output/exit_code.hpp"
#include "tools/base/output/say.hpp"
#include "tools/base/process/worker_pool.hpp"
#include "tools/batch/seeds/seeds_summary.hpp"
#include "tools/play/progress.hpp"
#include "tools/play/verdict_output.hpp"
#include "tools/run/metrics/void_run.hpp"

namespace castaway::testbed {

std::vector<int> play_runs(const RunsFolder& folder, int workers, const PlayRun& play_run) {
  const auto count = static_cast<int>(folder.runs().size());
  std::vector<int> codes(folder.runs().size(), kRunFailed);
  CampaignProgress progress(count, "runs");
  RecoveryTally tally;
  const auto name = [&](int index) {
    return folder.runs()[static_cast<std::size_t>(index)].folder;
  };
  JobOutcomes outcomes;
  outcomes.on_result = [&](int index, const std::string& code) {
    codes[static_cast<std::size_t>(index)] = std::stoi(code);
    const std::filesystem::path run = folder.path() / name(index);
    if (code == std::to_string(kDone) && !void_sentence_of(run)) {
      tally.add(load_judged_run(run).metrics);
    }
    progress.next(tally.text());
  };
  outcomes.on_failure = [&](int index, const std::string& reason) {
    say(fmt::format("{}: {}", name(index), reason));
    progress.next(tally.text());
  };
  SharedWorlds worlds;  // Each worker fills its own.
  const auto work = [&](int index) {
    const auto i = static_cast<std::size_t>(index);
    return std::to_string(folder.has_run(i) ? static_cast<int>(kDone) : play_run(i, worlds));
  };
  try {
    work_through(jobs_up_to(count), workers, work, outcomes);
  } catch (Interrupted& interrupted) {
    interrupted.kept =
        fmt::format("{} of {} runs are kept in {}; the same command resumes",
                    std::count(codes.begin(), codes.end(), kDone), count, folder.path().string());
    throw;
  }
  return codes;
}

RunsShare share_of(const BatchRequest& batch) {
  if (batch.collect) return RunsShare::kCollect;
  return batch.shard.is_all() ? RunsShare::kAll : RunsShare::kSome;
}

std::vector<int> make_runs(const RunsFolder& folder, const BatchRequest& batch,
                           const PlayRun& play_run) {
  if (!batch.collect) {
    return play_runs(folder, batch.workers, [&](std::size_t run, SharedWorlds& worlds) {
      return play_run(static_cast<std::size_t>(batch.shard.job(static_cast<int>(run))), worlds);
    });
  }
  std::vector<std::string> missing;
  for (std::size_t i = 0; i < folder.runs().size(); ++i) {
    if (!folder.has_run(i)) missing.push_back(folder.runs()[i].folder);
  }
  if (missing.empty()) return std::vector<int>(folder.runs().size(), kDone);
  throw std::runtime_error(fmt::format("{}: runs are missing: {}; run their shards again",
                                       folder.path().string(), fmt::join(missing, ", ")));
}

int end_shard(const Shard& shard, const std::vector<int>& codes) {
  const auto made = std::count(codes.begin(), codes.end(), kDone);
  print_out(
      "Shard {} of {}: {} runs made; the same command with --collect in place of --shard sums up "
      "when all are done\n",
      shard.index, shard.count, made);
  return made == static_cast<std::ptrdiff_t>(codes.size()) ? kDone : kRunFailed;
}

int follow_runs(const std::filesystem::path& out, const std::string& name,
                const std::vector<std::filesystem::path>& folders,
                const std::function<int()>& collect, const ClusterRequest& cluster) {
  const auto all = static_cast<int>(folders.size());
  const auto missing = [&] {
    std::vector<int> found = jobs_up_to(all);
    std::erase_if(found, [&](int i) {
      const auto record = load_record(folders[static_cast<std::size_t>(i)]);
      return record && record->finished;
    });
    return found;
  };
  return follow_on_cluster({folder_beside(out, ".slurm"), name, "runs", all, missing, collect},
                           cluster);
}

}  // namespace castaway::testbed
