#include "tools/pages/runs/run_set.hpp"

#include <algorithm>

#include "tools/base/bytes/json_number.hpp"
#include "tools/base/formats/json_file.hpp"
#include "tools/outputs/records/summary_kidnaps.hpp"
#include "tools/run/metrics/void_run.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

SetRun load_set_run(const std::filesystem::path& folder) {
  SetRun run{folder, read_json(folder / "summary.json"), {}, 0, false};
  read_fields(folder / "summary.json", [&] {
    run.scenario = run.summary.value("scenario", "run");
    run.seed = integer_or(run.summary, "seed", std::uint64_t{0});
    run.is_void = void_sentence(run.summary).has_value();
    summary_localizers(run.summary);
  });
  return run;
}

}  // namespace

std::vector<Json> RunSet::scored_summaries() const {
  std::vector<Json> summaries;
  for (const SetRun& run : runs) {
    if (!run.is_void) summaries.push_back(run.summary);
  }
  return summaries;
}

bool RunSet::is_one_scenario() const {
  return std::all_of(runs.begin(), runs.end(),
                     [&](const SetRun& run) { return run.scenario == runs.front().scenario; });
}

RunSet load_run_set(const std::vector<std::filesystem::path>& folders) {
  RunSet set;
  for (const std::filesystem::path& folder : folders) {
    set.runs.push_back(load_set_run(folder));
    for (const std::string& name : summary_localizers(set.runs.back().summary)) {
      if (std::find(set.localizers.begin(), set.localizers.end(), name) == set.localizers.end()) {
        set.localizers.push_back(name);
      }
    }
  }
  return set;
}

}  // namespace castaway::testbed
