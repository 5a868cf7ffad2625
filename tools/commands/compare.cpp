// castaway compare: compares two sets of runs pair by pair.
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/bytes/sha256.hpp"
#include "tools/base/files/file.hpp"
#include "tools/base/files/json_text.hpp"
#include "tools/base/output/default_folder.hpp"
#include "tools/base/output/progress_line.hpp"
#include "tools/base/output/say.hpp"
#include "tools/batch/compare/comparison.hpp"
#include "tools/commands/commands.hpp"
#include "tools/pages/run/comparison_page.hpp"

namespace castaway::testbed {
namespace {

/// Arguments of the command.
struct CompareArguments {
  std::vector<std::string> folders;
  std::string out;
  bool force = false;
  bool json = false;
};

/// Output of the comparison. The default folder depends on the compared folders.
OutputRequest output_request(const CompareArguments& arguments) {
  std::string compared;
  OutputRequest request{arguments.out, "compare", {}, {}, arguments.force};
  for (const std::string& folder : arguments.folders) {
    compared += std::filesystem::absolute(folder).lexically_normal().string() + "\n";
    request.inputs.emplace_back(folder);
  }
  request.settings = sha256(compared);
  if (!arguments.out.empty()) return request;
  request.target = std::filesystem::path("runs") / "comparison";
  request.target = announced_free_folder(request);
  return request;
}

int compare_folders(const CompareArguments& arguments) {
  const OutputRequest request = output_request(arguments);
  check_output(request);
  std::vector<Comparison> comparisons;
  for (std::size_t i = 1; i < arguments.folders.size(); ++i) {
    comparisons.push_back(compare_runs(arguments.folders.front(), arguments.folders[i]));
  }
  auto json = nlohmann::ordered_json::array();
  for (const Comparison& comparison : comparisons) {
    json.push_back(to_json(comparison));
    if (arguments.json) continue;
    print_out("{} against {}: {} pairs, {} runs without a counterpart{}\n\n{}\n",
              comparison.other.string(), comparison.baseline.string(), comparison.pairs,
              comparison.unpaired,
              comparison.voids > 0 ? fmt::format(", {} void runs left out", comparison.voids) : "",
              as_text(comparison_table(comparison), columns_of(stdout)));
  }
  OutputFolder output(request);
  write_file(output.folder() / "comparison.json", json_text(json, 2) + "\n");
  write_file(output.folder() / "comparison.html", render_comparison(comparisons));
  output.commit();
  if (arguments.json) {
    print_out("{}\n", json_text(json, 2));
  } else {
    print_out("Page: {}\n", (request.target / "comparison.html").string());
  }
  return kDone;
}

}  // namespace

void add_compare_command(Command& app) {
  auto a = std::make_shared<CompareArguments>();
  Command command = app.add_command("compare", "Compare sets of runs, paired by scenario and seed");
  command
      .add_option("folders", a->folders,
                  "Run folders, or folders of runs; the others against the first")
      .required()
      .at_least(2);
  command.add_option("--out", a->out,
                     "Where comparison.json and comparison.html go (default: runs/comparison)");
  command.add_flag("--force", a->force,
                   "Use a folder that holds other files, too; replaces only castaway's own");
  command.add_flag("--json", a->json, "Print JSON instead of a table");
  command.footer(
      "Refuses what is not comparable: another scenario, other metrics, no seed in common. A "
      "localizer's settings may differ: that is what is compared.\n"
      "Example:\n"
      "  castaway run my.yaml --seeds 20 --out before\n"
      "  castaway run my.yaml --seeds 20 --out after --set localizers.0.mh_amcl.max_beams=30\n"
      "  castaway compare before after");
  command.action([a] { return compare_folders(*a); });
}

}  // namespace castaway::testbed
