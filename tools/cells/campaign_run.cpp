#include "tools/cells/campaign_run.hpp"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "tools/cells/campaign_folder.hpp"
#include "tools/cells/campaign_tables.hpp"
#include "tools/cells/cell_play.hpp"
#include "tools/files/file.hpp"
#include "tools/files/file_error.hpp"
#include "tools/files/sha256.hpp"
#include "tools/metrics/verdict.hpp"
#include "tools/output/exit_code.hpp"
#include "tools/output/interruption.hpp"
#include "tools/output/runs_folder.hpp"
#include "tools/play/play.hpp"
#include "tools/play/progress.hpp"
#include "tools/play/verdict_output.hpp"
#include "tools/workers/lasting_workers.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr char kNoSpace = '!';  // Begins an answer about a disk error, which ends the campaign.

/// A campaign whose combinations have all been read.
struct CheckedCampaign {
  CampaignSpec spec;
  std::vector<std::string> localizers;  ///< Of all cells.
  std::string data;                     ///< As in CampaignIdentity.
};

/// A file that a cell reads, and the image if it is a ROS map.
std::vector<fs::path> with_image(const fs::path& file) {
  std::vector<fs::path> files{file};
  if (file.extension() != ".yaml") return files;
  const YamlNode root = parse_yaml(read_file(file), file.string());
  const YamlNode* image = root.find("image");
  if (image != nullptr) files.push_back(file.parent_path() / image->scalar);
  return files;
}

void add_localizers(const Scenario& scenario, std::vector<std::string>& names) {
  for (const std::string& name : names_of(scenario.localizers)) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
}

/// Reads the first cell of every combination, so that errors are found before anything is made.
CheckedCampaign check_campaign_of(const CampaignRequest& request) {
  CheckedCampaign checked;
  checked.spec = load_campaign_spec(request.spec, request.programs, request.overrides);
  std::map<fs::path, std::string> inputs;
  for (int k = 0; k < checked.spec.combinations(); ++k) {
    const CampaignCell cell = campaign_cell(checked.spec, k * checked.spec.seeds);
    add_localizers(cell.loaded.scenario, checked.localizers);
    for (const fs::path& input : inputs_of(cell.loaded.scenario, checked.spec.base / "none")) {
      if (!fs::is_regular_file(input) || inputs.contains(input)) continue;
      for (const fs::path& file : with_image(input)) {
        if (fs::is_regular_file(file)) inputs[file] = sha256_of_file(file);
      }
    }
  }
  std::string hashes;
  for (const auto& [file, hash] : inputs) hashes += hash + "\n";
  checked.data = sha256(hashes);
  static_cast<void>(expectations_of(checked.spec, checked.localizers));
  return checked;
}

/// The row of a cell without an answer.
CellRow lost_row(const CampaignSpec& spec, int index, const std::string& reason) {
  try {
    return failed_row(campaign_cell(spec, index), reason);
  } catch (const std::runtime_error&) {
    CampaignCell cell;
    cell.index = index;
    cell.seed = spec.first_seed + static_cast<std::uint64_t>(index % spec.seeds);
    cell.values = combination_values(spec, index / spec.seeds);
    for (const DrawnKey& key : spec.drawn) cell.values.emplace_back(key.path, "");
    return failed_row(cell, reason);
  }
}

std::string work_on_cell(const CampaignSpec& spec, const fs::path& folder, const fs::path& drafts,
                         PartsOfCells& parts, int index) {
  const CampaignCell cell = campaign_cell(spec, index);
  const fs::path kept = folder / "cells" / fmt::format("{:06d}-{}", index, cell.name);
  try {
    return row_text(play_cell(spec, cell, drafts / std::to_string(getpid()), kept, parts));
  } catch (const FileError& error) {
    return kNoSpace + std::string(error.what());
  }
}

std::vector<int> cells_to_make(const CampaignRequest& request, const CampaignSpec& spec) {
  const RowIndex rows(request.out, spec.cells());
  std::vector<int> cells;
  for (int i = request.shard - 1; i < spec.cells(); i += request.shards) {
    if (!rows.has(i) || (request.retry_failed && rows.has_failed(i))) cells.push_back(i);
  }
  return cells;
}

void report_failure(const CampaignRequest& request, const CellRow& row) {
  fmt::print(stderr,
             "castaway: cell {} failed: {}; castaway campaign {} --only {} --out again plays it\n",
             row.index, row.reason, request.spec.string(), row.index);
}

/// Recoveries so far, for the progress line.
class Tally {
 public:
  void add(const CellRow& row) {
    for (const CellKidnap& kidnap : row.kidnaps) {
      if (!kidnap.scored) continue;
      ++events_;
      recovered_ += kidnap.recovered ? 1 : 0;
    }
  }
  [[nodiscard]] std::string text() const {
    return events_ == 0 ? "" : fmt::format("{} of {} recovered", recovered_, events_);
  }

 private:
  int events_ = 0;
  int recovered_ = 0;
};

/// Makes the cells and adds their rows as they end.
void make_cells(const CampaignRequest& request, const CampaignSpec& spec,
                const std::vector<int>& cells) {
  const std::string name = rows_name(request.shard, request.shards);
  const RowsFile rows(request.out / name);
  const fs::path drafts = request.out / (".work-" + name);
  fs::remove_all(drafts);
  CampaignProgress progress(static_cast<int>(cells.size()), "cells");
  Tally tally;
  std::size_t made = 0;
  const auto take = [&](const CellRow& row) {
    rows.add(row);
    ++made;
    if (row.state == CellOutcome::kFailed) report_failure(request, row);
    tally.add(row);
    progress.next(tally.text());
  };
  JobOutcomes outcomes;
  outcomes.on_result = [&](int, const std::string& text) {
    if (text.starts_with(kNoSpace)) throw FileError(text.substr(1));
    take(parse_row(text));
  };
  outcomes.on_failure = [&](int index, const std::string& reason) {
    take(lost_row(spec, index, reason));
  };
  PartsOfCells parts;  // Each worker fills its own.
  const auto work = [&](int index) {
    return work_on_cell(spec, request.out, drafts, parts, index);
  };
  try {
    work_through(cells, request.workers, work, outcomes, spec.timeout_s);
  } catch (Interrupted& interrupted) {
    fs::remove_all(drafts);
    interrupted.kept = fmt::format("{} of {} cells are kept in {}; the same command goes on", made,
                                   cells.size(), request.out.string());
    throw;
  }
  fs::remove_all(drafts);
}

/// The cells as runs to be checked, with the metrics that expectations name. Void and failed ones
/// are left out, and so are cells without the localizer of an expectation. Where no cell is left,
/// there is nothing to measure, and the expectation is not met.
std::vector<JudgedRun> judged_cells(const CampaignSpec& spec, RowIndex& rows,
                                    const Expectation& expectation) {
  std::vector<JudgedRun> runs;
  for (int i = 0; i < spec.cells(); ++i) {
    const CellRow row = rows.row(i);
    const auto found = row.metrics.find(expectation.metric);
    if (row.state != CellOutcome::kDone || found == row.metrics.end()) continue;
    JudgedRun run;
    run.seed = row.seed;
    run.folder = fmt::format("cell {}", i);
    run.metrics[expectation.metric] = found->second;
    runs.push_back(std::move(run));
  }
  return runs;
}

std::vector<Check> judge_cells(const CheckedCampaign& campaign, RowIndex& rows) {
  std::vector<Check> checks;
  for (const Expectation& each : expectations_of(campaign.spec, campaign.localizers)) {
    const std::vector<JudgedRun> cells = judged_cells(campaign.spec, rows, each);
    if (cells.empty()) {
      checks.push_back({each, std::nullopt, std::nullopt, false, "results.csv"});
      continue;
    }
    for (Check& check : judge({each}, cells)) checks.push_back(std::move(check));
  }
  return checks;
}

int failed_cells(const Json& summary) {
  int failed = 0;
  for (const Json& combination : summary.at("combinations")) {
    failed += combination.at("failed").get<int>();
  }
  return failed;
}

int finish_campaign(const CampaignRequest& request, const CheckedCampaign& campaign,
                    CampaignFolder& folder) {
  constexpr std::size_t kMostNamed = 20;
  const CampaignSpec& spec = campaign.spec;
  RowIndex rows(folder.path(), spec.cells());
  const std::vector<int> missing = rows.missing(kMostNamed + 1);
  if (!missing.empty()) {
    const bool more = missing.size() > kMostNamed;
    fmt::print(stderr, "castaway: {}: cells are missing: {}{}; run their shards again\n",
               folder.path().string(), fmt::join(missing, ", "), more ? " and more" : "");
    return kRunFailed;
  }
  folder.put("results.csv", [&](const fs::path& file) { write_results(spec, rows, file); });
  folder.put("kidnaps.csv", [&](const fs::path& file) { write_kidnaps(spec, rows, file); });
  folder.put("costs.csv", [&](const fs::path& file) { write_costs(spec, rows, file); });
  const Json summary = campaign_summary(spec, rows);
  const std::string text = summary.dump(1) + "\n";
  folder.put("summary.json", [&](const fs::path& file) { write_file(file, text); });
  const std::vector<Check> checks = judge_cells(campaign, rows);
  fmt::print("{}", request.json ? text : campaign_text(summary));
  if (!request.json) fmt::print("Folder: {}\n", folder.path().string());
  fmt::print(request.json ? stderr : stdout, "{}", describe_checks(checks));
  return failed_cells(summary) > 0 ? kRunFailed : exit_code_of(checks);
}

int shard_number(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() ? value : 0;
}

}  // namespace

void parse_shard(const std::string& text, CampaignRequest& request) {
  const std::size_t slash = text.find('/');
  const std::string_view all = text;
  if (slash != std::string::npos) {
    request.shard = shard_number(all.substr(0, slash));
    request.shards = shard_number(all.substr(slash + 1));
    if (request.shard >= 1 && request.shard <= request.shards && request.shards <= 100000) return;
  }
  throw std::invalid_argument("--shard needs I/N, from 1/N to N/N, such as 3/8, not " + text);
}

int make_campaign(const CampaignRequest& request) {
  const CheckedCampaign campaign = check_campaign_of(request);
  CampaignFolder folder(request.out,
                        {CASTAWAY_VERSION, program_hash(), campaign.data, campaign.spec.effective});
  const std::vector<int> cells = cells_to_make(request, campaign.spec);
  if (!cells.empty()) make_cells(request, campaign.spec, cells);
  if (request.shards == 1) return finish_campaign(request, campaign, folder);
  fmt::print(
      "Shard {} of {}: {} cells made; castaway campaign {} --collect --out {} makes the "
      "tables when all are done\n",
      request.shard, request.shards, cells.size(), request.spec.string(), request.out.string());
  RowIndex rows(request.out, campaign.spec.cells());
  for (const int cell : cells) {
    if (rows.has_failed(cell)) return kRunFailed;
  }
  return kDone;
}

int collect_campaign(const CampaignRequest& request) {
  const CheckedCampaign campaign = check_campaign_of(request);
  static_cast<void>(CampaignFolder(request.out));
  CampaignFolder folder(request.out,
                        {CASTAWAY_VERSION, program_hash(), campaign.data, campaign.spec.effective});
  return finish_campaign(request, campaign, folder);
}

int make_cell(const CampaignRequest& request, int index) {
  CampaignSpec spec = load_campaign_spec(request.spec, request.programs, request.overrides);
  if (index >= spec.cells()) {
    throw std::invalid_argument(
        fmt::format("--only {}: the campaign has cells 0 to {}", index, spec.cells() - 1));
  }
  for (const char* output : {"report", "player", "snapshots"}) {
    put_value(spec.scenario, std::string("outputs.") + output, write_yaml(true), "");
  }
  const CampaignCell cell = campaign_cell(spec, index);
  PlayOptions options;
  options.base = spec.base;
  options.out = request.out;
  options.inputs = {request.spec};
  options.json = request.json;
  return play(cell.loaded, options);
}

}  // namespace castaway::testbed
