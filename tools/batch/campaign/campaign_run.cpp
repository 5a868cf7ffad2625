#include "tools/batch/campaign/campaign_run.hpp"

#include <filesystem>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "tools/base/files/attempts.hpp"
#include "tools/base/files/file.hpp"
#include "tools/base/files/json_text.hpp"
#include "tools/base/output/exit_code.hpp"
#include "tools/base/output/interruption.hpp"
#include "tools/base/output/say.hpp"
#include "tools/batch/campaign/campaign_cell.hpp"
#include "tools/batch/campaign/campaign_cells.hpp"
#include "tools/batch/campaign/campaign_check.hpp"
#include "tools/batch/campaign/campaign_folder.hpp"
#include "tools/batch/campaign/campaign_hdf5.hpp"
#include "tools/batch/campaign/campaign_rank.hpp"
#include "tools/batch/campaign/campaign_tables.hpp"
#include "tools/batch/campaign/campaign_verdict.hpp"
#include "tools/batch/campaign/stopping_rule.hpp"
#include "tools/play/play.hpp"
#include "tools/play/verdict_output.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// True if this process makes a cell.
bool is_own(const CampaignRequest& request, const CampaignSpec& spec, int cell) {
  return shard_of(spec, cell, request.shards) == request.shard;
}

/// Cells of this process that are needed and not there. `retry`: also those that failed.
std::vector<int> cells_to_make(const CampaignRequest& request, const CampaignSpec& spec,
                               bool retry) {
  RowIndex rows(request.out, spec.cells());
  std::vector<int> cells;
  for (int c = 0; c < spec.combinations(); ++c) {
    const int begin = c * spec.samples();
    if (spec.until && !is_own(request, spec, begin)) continue;
    const int end = begin + cells_needed(spec, rows, c);
    for (int cell = begin; cell < end; ++cell) {
      const bool wanted = !rows.has(cell) || (retry && rows.has_failed(cell));
      if (wanted && is_own(request, spec, cell)) cells.push_back(cell);
    }
  }
  return cells;
}

/// Makes all cells of this process, as many rounds as `until` asks for; their number.
std::size_t make_all_cells(const CampaignRequest& request, const CampaignSpec& spec) {
  std::size_t made = 0;
  std::vector<int> cells = cells_to_make(request, spec, request.retry_failed);
  while (!cells.empty()) {
    make_cells(request, spec, cells);
    made += cells.size();
    cells = cells_to_make(request, spec, false);
  }
  return made;
}

bool has_failed_own(const CampaignRequest& request, const CampaignSpec& spec) {
  const RowIndex rows(request.out, spec.cells());
  for (const int cell : rows.cells()) {
    if (is_own(request, spec, cell) && rows.has_failed(cell)) return true;
  }
  return false;
}

int failed_cells(const Json& summary) {
  int failed = 0;
  for (const Json& combination : summary.at("combinations")) {
    failed += combination.at("failed").get<int>();
  }
  return failed;
}

std::vector<MetricRank> rank_campaign(const CampaignRequest& request, const CampaignSpec& spec,
                                      RowIndex& rows) {
  std::vector<MetricRank> ranks;
  if (!request.rank) return ranks;
  for (const std::string& metric :
       request.metrics.empty() ? ranked_metrics(rows) : request.metrics) {
    MetricRank rank = rank_keys(spec, rows, metric);
    if (rank.seeds > 0) {
      ranks.push_back(std::move(rank));
    } else if (!request.metrics.empty()) {
      throw std::runtime_error(
          fmt::format("--metric {}: no seed has it in all combinations; results.csv has the "
                      "metrics",
                      metric));
    }
  }
  return ranks;
}

void put_pages(const CampaignRequest& request, const CheckedCampaign& campaign,
               const std::vector<Check>& checks, RowIndex& rows, CampaignFolder& folder) {
  if (request.pages == nullptr) return;
  const FinishedCampaign finished{campaign.spec, request.overrides, campaign.localizers,
                                  checks,        folder.path(),     rows};
  for (const auto& [name, text] : request.pages(finished)) {
    const std::string& contents = text;
    folder.put(name, [&](const fs::path& file) { write_file(file, contents); });
  }
}

int finish_campaign(const CampaignRequest& request, const CheckedCampaign& campaign,
                    CampaignFolder& folder) {
  constexpr std::size_t kMostNamed = 20;
  const CampaignSpec& spec = campaign.spec;
  RowIndex rows(folder.path(), spec.cells());
  const std::vector<int> missing = missing_cells(spec, rows, kMostNamed + 1);
  if (!missing.empty()) {
    const bool more = missing.size() > kMostNamed;
    say(fmt::format("{}: cells are missing: {}{}; run their shards again", folder.path().string(),
                    fmt::join(missing, ", "), more ? " and more" : ""));
    return kRunFailed;
  }
  Attempts outputs;
  const auto put = [&](const char* name, const auto& write) {
    outputs.make([&] { folder.put(name, write); });
  };
  put("results.csv", [&](const fs::path& file) { write_results(spec, rows, file); });
  put("kidnaps.csv", [&](const fs::path& file) { write_kidnaps(spec, rows, file); });
  put("results.h5", [&](const fs::path& file) { write_hdf5(spec, rows, file); });
  put("costs.csv", [&](const fs::path& file) { write_costs(rows, file); });
  const Json summary = campaign_summary(spec, rows);
  const std::string text = json_text(summary, 1) + "\n";
  put("summary.json", [&](const fs::path& file) { write_file(file, text); });
  const std::vector<MetricRank> ranks = rank_campaign(request, spec, rows);
  if (request.rank) {
    put("ranks.csv", [&](const fs::path& file) { write_ranks(ranks, file); });
  }
  const std::vector<Check> checks = judge_cells(campaign, rows);
  outputs.make([&] { put_pages(request, campaign, checks, rows, folder); });
  print_out("{}", request.json ? text : campaign_text(summary));
  for (const MetricRank& rank : ranks) {
    fmt::print(request.json ? stderr : stdout, "{}", rank_text(rank));
  }
  if (!request.json) print_out("Folder: {}\n", folder.path().string());
  fmt::print(request.json ? stderr : stdout, "{}", describe_checks(checks));
  outputs.rethrow();
  return failed_cells(summary) > 0 ? kRunFailed : exit_code_of(checks);
}

std::string kept_cells(const CampaignRequest& request) {
  return "finished cells are kept in " + request.out.string() + "; the same command goes on";
}

}  // namespace

int make_campaign(const CampaignRequest& request) {
  std::optional<KeptWork> kept;
  if (fs::exists(request.out / "rows.jsonl")) kept.emplace(kept_cells(request));
  const CheckedCampaign campaign = check_campaign(request);
  CampaignFolder folder(request.out, identity_of(campaign));
  if (!kept) kept.emplace(kept_cells(request));
  const std::size_t made = make_all_cells(request, campaign.spec);
  if (request.shards == 1) return finish_campaign(request, campaign, folder);
  print_out(
      "Shard {} of {}: {} cells made; castaway campaign {} --collect --out {} makes the "
      "tables when all are done\n",
      request.shard, request.shards, made, request.spec.string(), request.out.string());
  return has_failed_own(request, campaign.spec) ? kRunFailed : kDone;
}

int collect_campaign(const CampaignRequest& request) {
  const KeptWork kept(kept_cells(request));
  const CheckedCampaign campaign = check_campaign(request);
  static_cast<void>(CampaignFolder(request.out));
  CampaignFolder folder(request.out, identity_of(campaign));
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
  options.report = request.report;
  return play(cell.loaded, options);
}

}  // namespace castaway::testbed
