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
#include "tools/batch/campaign/campaign_hdf5.hpp"
#include "tools/batch/campaign/campaign_rank.hpp"
#include "tools/batch/campaign/campaign_tables.hpp"
#include "tools/batch/campaign/campaign_verdict.hpp"
#include "tools/batch/campaign/stopping_rule.hpp"
#include "tools/batch/cluster/slurm_batch.hpp"
#include "tools/batch/jobs/job_folder.hpp"
#include "tools/play/play.hpp"
#include "tools/play/verdict_output.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// What is shared among processes: cells, or with `until` combinations, since the process that
/// makes one decides how many cells it needs.
int shared_index(const CampaignSpec& spec, int cell) {
  return spec.until ? cell / spec.samples() : cell;
}

/// True if this process makes a cell.
bool is_own(const CampaignRequest& request, const CampaignSpec& spec, int cell) {
  return request.batch.shard.makes(shared_index(spec, cell));
}

/// Cells of this process that are needed and not there. `retry`: also those that failed.
std::vector<int> cells_to_make(const CampaignRequest& request, const CampaignSpec& spec,
                               bool retry) {
  CellRows rows(request.batch.out, spec.cells());
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
  std::vector<int> cells = cells_to_make(request, spec, request.batch.retry_failed);
  while (!cells.empty()) {
    make_cells(request, spec, cells);
    made += cells.size();
    cells = cells_to_make(request, spec, false);
  }
  return made;
}

bool has_failed_own(const CampaignRequest& request, const CampaignSpec& spec) {
  const CellRows rows(request.batch.out, spec.cells());
  for (const int cell : rows.jobs()) {
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
                                      CellRows& rows) {
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
               const std::vector<Check>& checks, CellRows& rows, const JobFolder& folder) {
  if (request.pages == nullptr) return;
  const FinishedCampaign finished{campaign.spec, request.overrides, campaign.localizers,
                                  checks,        folder.path(),     rows};
  for (const auto& [name, text] : request.pages(finished)) folder.put(name, text);
}

int finish_campaign(const CampaignRequest& request, const CheckedCampaign& campaign,
                    const JobFolder& folder) {
  constexpr std::size_t kMostNamed = 20;
  const CampaignSpec& spec = campaign.spec;
  CellRows rows(folder.path(), spec.cells());
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
  outputs.make([&] { folder.put("summary.json", text); });
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
  return "finished cells are kept in " + request.batch.out.string() + "; the same command goes on";
}

}  // namespace

int make_campaign(const CampaignRequest& request) {
  std::optional<KeptWork> kept;
  if (fs::exists(request.batch.out / "rows.jsonl")) kept.emplace(kept_cells(request));
  const CheckedCampaign campaign = check_campaign(request);
  const JobFolder folder(request.batch.out, identity_of(campaign));
  if (!kept) kept.emplace(kept_cells(request));
  const std::size_t made = make_all_cells(request, campaign.spec);
  const Shard& shard = request.batch.shard;
  if (shard.is_all()) return finish_campaign(request, campaign, folder);
  print_out(
      "Shard {} of {}: {} cells made; castaway campaign {} --collect --out {} makes the "
      "tables when all are done\n",
      shard.index, shard.count, made, request.spec.string(), folder.path().string());
  return has_failed_own(request, campaign.spec) ? kRunFailed : kDone;
}

int collect_campaign(const CampaignRequest& request) {
  const KeptWork kept(kept_cells(request));
  const CheckedCampaign campaign = check_campaign(request);
  require_job_folder(request.batch.out, "campaign");
  return finish_campaign(request, campaign, {request.batch.out, identity_of(campaign)});
}

int make_campaign_on_slurm(const CampaignRequest& request, const ClusterRequest& cluster) {
  const CheckedCampaign campaign = check_campaign(request);
  if (cluster.attach) require_job_folder(request.batch.out, "campaign");
  const JobFolder folder(request.batch.out, identity_of(campaign));
  const CampaignSpec& spec = campaign.spec;
  const auto missing = [&] {
    CellRows rows(folder.path(), spec.cells());
    std::vector<int> found = missing_cells(spec, rows, static_cast<std::size_t>(spec.cells()));
    for (int& cell : found) cell = shared_index(spec, cell);
    return found;
  };
  const auto done = [&] { return RowIndex(folder.path(), spec.cells()).jobs().size(); };
  return follow_on_cluster({folder.path(), spec.name, "cells", spec.cells(), missing,
                            [&] { return collect_campaign(request); }, done},
                           cluster);
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
  options.out = request.batch.out;
  options.inputs = {request.spec};
  options.json = request.json;
  options.report = request.report;
  return play(cell.loaded, options);
}

}  // namespace castaway::testbed
