#include "tools/batch/seeds/play_runs.hpp"

#include <algorithm>

#include <fmt/format.h>

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

}  // namespace castaway::testbed
