// castaway dataset: makes a data set of many runs drawn from a specification.
#include <memory>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/files/json_text.hpp"
#include "tools/base/output/say.hpp"
#include "tools/batch/dataset/dataset_manifest.hpp"
#include "tools/batch/dataset/dataset_only.hpp"
#include "tools/commands/arguments/batch_arguments.hpp"
#include "tools/commands/arguments/localizer_arguments.hpp"
#include "tools/commands/commands.hpp"
#include "tools/pages/dataset/dataset_pages.hpp"
#include "tools/pages/run/report.hpp"

namespace castaway::testbed {
namespace {

/// Arguments of the command.
struct DatasetArguments {
  DatasetRequest request;
  std::string spec;
  bool allow_programs = false;
  BatchArguments batch;
  std::string verify;
  std::uint64_t seed = 1;
  int only = -1;
};

int verify(const std::string& folder, bool json) {
  const std::vector<std::string> troubles = verify_dataset(folder);
  if (json) {
    const nlohmann::ordered_json root{
        {"kind", "dataset-verify"}, {"folder", folder}, {"troubles", troubles}};
    print_out("{}\n", json_text(root, 2));
    return troubles.empty() ? kDone : kRunFailed;
  }
  for (const std::string& trouble : troubles) print_out("{}\n", trouble);
  if (!troubles.empty()) {
    say(fmt::format("{}: {} of its files differ from its manifest.json", folder, troubles.size()));
    return kRunFailed;
  }
  print_out("{}: every file matches its manifest.json\n", folder);
  return kDone;
}

int dataset(DatasetArguments arguments, bool seeded) {
  if (!arguments.verify.empty()) return verify(arguments.verify, arguments.request.json);
  if (arguments.spec.empty()) {
    throw std::invalid_argument("dataset: give a specification (datasets/*.yaml), or --verify DIR");
  }
  BatchArguments& batch = arguments.batch;
  if (batch.out.empty()) throw std::invalid_argument("dataset: say where with --out DIR");
  batch.check();
  DatasetRequest& request = arguments.request;
  request.spec = arguments.spec;
  request.batch = batch.request;
  request.pages = dataset_pages;
  request.report = write_report;
  if (seeded) request.overrides.seed = arguments.seed;
  request.overrides.programs = file_programs(arguments.allow_programs);
  if (arguments.only >= 0) return make_only(request, arguments.only);
  if (batch.cluster.slurm || batch.cluster.attach) {
    return make_dataset_on_slurm(request, batch.cluster);
  }
  return make_dataset(request);
}

}  // namespace

void add_dataset_command(Command& app) {
  auto a = std::make_shared<DatasetArguments>();
  Command command = app.add_command(
      "dataset", "Many runs drawn from a specification, as a data set with labels and a card");
  command.add_option("spec", a->spec, "Specification (YAML): docs/datasets.md");
  add_allow_programs(command, a->allow_programs);
  command.add_option("-n", a->request.sequences, "Sequences").show_default().range(1, 999999);
  BatchRequest& batch = a->batch.request;
  command.add_option("-j,--jobs", batch.workers, "At a time").show_default().range(1, 1024);
  command.add_option("--out", a->batch.out, "Folder to create or to resume");
  add_sharing_options(command, a->batch, "sequences");
  const Option seed =
      command.add_option("--seed", a->seed, "Root seed; overrides the specification's");
  command
      .add_option("--set", a->request.overrides.scenario,
                  "key=value override of the scenario of all sequences")
      .repeatable();
  command.add_option("--only", a->only, "Make only this sequence again, as folder --out")
      .range(0, 999999);
  command.add_option("--verify", a->verify,
                     "Compare a data set's files with its manifest; make nothing");
  command.add_flag("--json", a->request.json, "Print JSON instead of words");
  command.footer(
      "Repeat a stopped command to resume it.\n"
      "Examples:\n"
      "  castaway dataset datasets/office-people.yaml -n 100 -j 2 --out data/office\n"
      "  castaway dataset --verify data/office\n"
      "  castaway dataset data/office/dataset.yaml --only 42 --out again");
  command.action([a, seed] { return dataset(*a, seed.given()); });
}

}  // namespace castaway::testbed
