// castaway campaign: many runs over the values of a grid.
#include <memory>
#include <stdexcept>

#include "tools/batch/campaign/campaign_run.hpp"
#include "tools/batch/campaign/slurm_campaign.hpp"
#include "tools/commands/arguments/localizer_arguments.hpp"
#include "tools/commands/commands.hpp"
#include "tools/pages/campaign/campaign_pages.hpp"
#include "tools/pages/run/report.hpp"

namespace castaway::testbed {
namespace {

/// Refuses options that do not go together.
void require_one_way(bool slurm, bool attach, bool collect, const std::string& shard, int only) {
  const int ways = (slurm ? 1 : 0) + (attach ? 1 : 0) + (collect ? 1 : 0) +
                   (shard.empty() ? 0 : 1) + (only >= 0 ? 1 : 0);
  if (ways > 1) {
    throw std::invalid_argument(
        "campaign: give one of --slurm, --attach, --shard, --collect and --only");
  }
}

/// Refuses options of Slurm where nothing is submitted.
void require_slurm(bool slurm, const SlurmOptions& cluster) {
  const SlurmOptions none;
  const bool given = !cluster.partition.empty() || !cluster.time.empty() ||
                     cluster.tasks != none.tasks || !cluster.extra.empty();
  if (slurm || !given) return;
  throw std::invalid_argument(
      "campaign: --partition, --time, --array-size and --sbatch go with --slurm");
}

void add_slurm_options(Command& command, bool& slurm, bool& attach, SlurmOptions& cluster) {
  command.add_flag("--slurm", slurm,
                   "Submit the cells to Slurm as an array of shards, and follow them");
  command.add_flag("--attach", attach, "Follow the jobs that --slurm submitted");
  command.add_option("--partition", cluster.partition, "Slurm's partition");
  command.add_option("--time", cluster.time, "Slurm's time limit of a task, such as 2:00:00");
  command.add_option("--array-size", cluster.tasks, "Tasks of the array, each with -j cores")
      .range(1, 100000)
      .show_default();
  command.add_option("--sbatch", cluster.extra, "Further option of sbatch, such as --mem=1G")
      .repeatable();
}

/// Arguments of the command.
struct CampaignArguments {
  CampaignRequest request;
  std::string spec;
  std::string out;
  std::string shard;
  int only = -1;
  bool collect = false;
  bool slurm = false;
  bool attach = false;
  SlurmOptions cluster;
  bool allow_programs = false;
};

int campaign(CampaignArguments arguments) {
  CampaignRequest& request = arguments.request;
  if (arguments.out.empty()) throw std::invalid_argument("campaign: say where with --out DIR");
  request.spec = arguments.spec;
  request.out = arguments.out;
  request.pages = render_campaign_pages;
  request.report = write_report;
  request.programs = file_programs(arguments.allow_programs);
  if (!arguments.shard.empty()) parse_shard(arguments.shard, request);
  require_one_way(arguments.slurm, arguments.attach, arguments.collect, arguments.shard,
                  arguments.only);
  require_slurm(arguments.slurm, arguments.cluster);
  request.rank = request.rank || !request.metrics.empty();
  if (request.rank && request.shards > 1) {
    throw std::invalid_argument("campaign: --rank goes with --collect, not with --shard");
  }
  if (arguments.only >= 0) return make_cell(request, arguments.only);
  if (arguments.attach) return follow_on_slurm(request);
  if (arguments.slurm) {
    arguments.cluster.cores = request.workers;
    return make_on_slurm(request, arguments.cluster);
  }
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
  add_slurm_options(command, a->slurm, a->attach, a->cluster);
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
