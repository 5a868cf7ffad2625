// castaway campaign: many runs over the values of a grid.
#include <memory>
#include <stdexcept>

#include "tools/cells/campaign_run.hpp"
#include "tools/commands/arguments/localizer_arguments.hpp"
#include "tools/commands/commands.hpp"

namespace castaway::testbed {
namespace {

/// Arguments of the command.
struct CampaignArguments {
  CampaignRequest request;
  std::string spec;
  std::string out;
  std::string shard;
  int only = -1;
  bool collect = false;
  bool allow_programs = false;
};

int campaign(CampaignArguments arguments) {
  CampaignRequest& request = arguments.request;
  if (arguments.out.empty()) throw std::invalid_argument("campaign: say where with --out DIR");
  request.spec = arguments.spec;
  request.out = arguments.out;
  request.programs = file_programs(arguments.allow_programs);
  if (!arguments.shard.empty()) parse_shard(arguments.shard, request);
  if (arguments.only >= 0) return make_cell(request, arguments.only);
  return arguments.collect ? collect_campaign(request) : make_campaign(request);
}

}  // namespace

void add_campaign_command(Command& app) {
  auto a = std::make_shared<CampaignArguments>();
  Command command = app.add_command(
      "campaign", "A scenario over a grid of values and seeds, as tables with intervals");
  command.add_option("spec", a->spec, "Specification (YAML): docs/campaigns.md").required();
  add_allow_programs(command, a->allow_programs);
  command.add_option("-j,--jobs", a->request.workers, "Cells at a time")
      .range(1, 1024)
      .show_default();
  command.add_option("--out", a->out, "Folder to create or to go on in");
  command
      .add_option("--set", a->request.overrides, "key=value override of the scenario of all cells")
      .repeatable();
  command.add_flag("--retry-failed", a->request.retry_failed, "Make failed cells again");
  command.add_option("--shard", a->shard,
                     "I/N: make every N-th cell, from the I-th on; the other processes make the "
                     "rest in the same folder");
  command.add_flag("--collect", a->collect,
                   "Make the tables when all shards are done; names the cells that are missing");
  command.add_option("--only", a->only, "Play this cell again, in full, as the run folder --out")
      .range(0, kMostCells);
  command.add_flag("--json", a->request.json, "Print summary.json instead of words");
  command.footer(
      "Repeat a stopped command to go on.\n"
      "Exit codes: 0 done, 1 a cell failed, 2 bad usage or input, 3 an expectation was not met.\n"
      "Examples:\n"
      "  castaway campaign range.yaml --out range -j 4\n"
      "  castaway campaign range.yaml --out range --shard 3/8\n"
      "  castaway campaign range.yaml --out range --collect\n"
      "  castaway campaign range.yaml --only 17 --out again");
  command.action([a] { return campaign(*a); });
}

}  // namespace castaway::testbed
