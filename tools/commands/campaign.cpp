// castaway campaign: many runs over the values of a grid.
#include <memory>
#include <stdexcept>

#include "tools/batch/campaign/campaign_run.hpp"
#include "tools/commands/arguments/batch_arguments.hpp"
#include "tools/commands/arguments/localizer_arguments.hpp"
#include "tools/commands/commands.hpp"
#include "tools/pages/campaign/campaign_pages.hpp"
#include "tools/pages/run/report.hpp"

namespace castaway::testbed {
namespace {

/// Arguments of the command.
struct CampaignArguments {
  CampaignRequest request;
  BatchArguments batch;
  std::string spec;
  int only = -1;
  bool allow_programs = false;
};

int campaign(CampaignArguments arguments) {
  CampaignRequest& request = arguments.request;
  BatchArguments& batch = arguments.batch;
  if (batch.out.empty()) throw std::invalid_argument("campaign: say where with --out DIR");
  batch.check();
  request.spec = arguments.spec;
  request.batch = batch.request;
  request.pages = render_campaign_pages;
  request.report = write_report;
  request.programs = file_programs(arguments.allow_programs);
  request.rank = request.rank || !request.metrics.empty();
  if (arguments.only >= 0 && batch.is_shared()) {
    throw std::invalid_argument(
        "campaign: --only does not go with --slurm, --attach, --shard and --collect");
  }
  if (request.rank && !request.batch.shard.is_all()) {
    throw std::invalid_argument("campaign: --rank goes with --collect, not with --shard");
  }
  if (arguments.only >= 0) return make_cell(request, arguments.only);
  if (batch.cluster.slurm || batch.cluster.attach) {
    return make_campaign_on_slurm(request, batch.cluster);
  }
  return request.batch.collect ? collect_campaign(request) : make_campaign(request);
}

}  // namespace

void add_campaign_command(Command& app) {
  auto a = std::make_shared<CampaignArguments>();
  Command command = app.add_command(
      "campaign", "A scenario over a grid of values and seeds, as tables with intervals");
  command.add_option("spec", a->spec, "Specification (YAML): docs/campaigns.md").required();
  add_allow_programs(command, a->allow_programs);
  add_batch_options(command, a->batch, "cells");
  command
      .add_option("--set", a->request.overrides, "key=value override of the scenario of all cells")
      .repeatable();
  command.add_flag("--rank", a->request.rank,
                   "Say which keys matter: their shares of each metric's variance, also as "
                   "ranks.csv");
  command
      .add_option("--metric", a->request.metrics,
                  "Metric to rank by, such as mh_amcl.recovery.success")
      .repeatable();
  command.add_option("--only", a->only, "Play this cell again, in full, as the run folder --out")
      .range(0, kMostCells);
  command.add_flag("--json", a->request.json, "Print summary.json instead of words");
  command.footer(
      "Repeat a stopped command to go on.\n"
      "Exit codes: 0 done, 1 a cell failed, 2 bad usage or input, 3 an expectation was not met.\n"
      "Examples:\n"
      "  castaway campaign range.yaml --out range -j 4\n"
      "  castaway campaign range.yaml --out range --shard 3/8\n"
      "  castaway campaign range.yaml --out range --collect --rank\n"
      "  castaway campaign range.yaml --out /shared/range --slurm --array-size 64 --time 1:00:00\n"
      "  castaway campaign range.yaml --only 17 --out again");
  command.action([a] { return campaign(*a); });
}

}  // namespace castaway::testbed
