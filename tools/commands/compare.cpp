// castaway compare: runs against runs, pair by pair.
#include <memory>

#include <fmt/format.h>

#include "tools/campaign/comparison.hpp"
#include "tools/commands/commands.hpp"
#include "tools/formats/file.hpp"
#include "tools/report/comparison_page.hpp"

namespace castaway::testbed {
namespace {

/// What the command line says.
struct CompareArguments {
  std::vector<std::string> folders;
  std::string out;
  bool json = false;
};

int compare_folders(const CompareArguments& arguments) {
  std::vector<Comparison> comparisons;
  for (std::size_t i = 1; i < arguments.folders.size(); ++i) {
    comparisons.push_back(compare_runs(arguments.folders.front(), arguments.folders[i]));
  }
  auto json = nlohmann::ordered_json::array();
  for (const Comparison& comparison : comparisons) {
    json.push_back(to_json(comparison));
    if (arguments.json) continue;
    fmt::print("{} against {}: {} pairs, {} runs without a counterpart\n\n{}\n",
               comparison.other.string(), comparison.baseline.string(), comparison.pairs,
               comparison.unpaired, as_text(comparison_table(comparison)));
  }
  const std::filesystem::path out = arguments.out;
  write_file(out / "comparison.json", json.dump(2) + "\n");
  write_file(out / "comparison.html", render_comparison(comparisons));
  if (arguments.json) {
    fmt::print("{}\n", json.dump(2));
  } else {
    fmt::print("Page: {}\n", (out / "comparison.html").string());
  }
  return kDone;
}

}  // namespace

void add_compare_command(CLI::App& app, std::function<int()>& chosen) {
  auto a = std::make_shared<CompareArguments>();
  a->out = "runs/comparison";
  CLI::App* command = app.add_subcommand(
      "compare", "Runs against runs: paired by scenario and seed, differences with intervals");
  command
      ->add_option("folders", a->folders,
                   "Run folders, or folders of runs; the others against the first")
      ->required()
      ->expected(2, -1);
  command->add_option("--out", a->out, "Where comparison.json and comparison.html go")
      ->capture_default_str();
  command->add_flag("--json", a->json, "Print JSON instead of a table");
  command->footer(
      "Refuses what is not comparable: another scenario, other metrics, no seed in common. A "
      "localizer's settings may differ: that is what is compared.\n"
      "Example:\n"
      "  castaway run my.yaml --seeds 20 --out before\n"
      "  castaway run my.yaml --seeds 20 --out after --set localizers.0.mh_amcl.max_beams=30\n"
      "  castaway compare before after");
  command->callback([&chosen, a] { chosen = [a] { return compare_folders(*a); }; });
}

}  // namespace castaway::testbed
