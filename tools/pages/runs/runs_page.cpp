#include "tools/pages/runs/runs_page.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "tools/base/formats/html.hpp"
#include "tools/pages/html/html_page.hpp"
#include "tools/pages/run/report_words.hpp"
#include "tools/pages/runs/expectation_list.hpp"
#include "tools/pages/runs/pooled_section.hpp"
#include "tools/pages/runs/recoveries_section.hpp"
#include "tools/pages/runs/runs_table.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

std::string title_of(const RunSet& set) {
  const std::string count =
      fmt::format("{} run{}", set.runs.size(), set.runs.size() == 1 ? "" : "s");
  return set.runs.empty() || !set.is_one_scenario() ? count
                                                    : set.runs.front().scenario + ": " + count;
}

/// "seeds 1 to 4", "seeds 1, 7"
std::string seeds_text(const std::vector<std::uint64_t>& seeds) {
  const auto gap =
      std::adjacent_find(seeds.begin(), seeds.end(), [](auto a, auto b) { return b != a + 1; });
  if (seeds.size() > 2 && gap == seeds.end()) {
    return fmt::format("seeds {} to {}", seeds.front(), seeds.back());
  }
  return fmt::format("seed{} {}", seeds.size() == 1 ? "" : "s", fmt::join(seeds, ", "));
}

/// One line: where, with what, which seeds, and which of them do not count.
std::string head_line(const RunSet& set, const std::vector<std::uint64_t>& failed_seeds) {
  if (set.runs.empty()) return "";
  std::vector<std::uint64_t> seeds;
  std::vector<std::uint64_t> voids;
  for (const SetRun& run : set.runs) (run.is_void ? voids : seeds).push_back(run.seed);
  const Json& first = set.runs.front().summary;
  std::string line;
  if (set.is_one_scenario()) {
    line = fmt::format("World {}, robot {}, {} each; ", escape_html(first.value("world", "?")),
                       escape_html(first.value("robot", "?")),
                       readable(figure_at(first, "/duration_s"), "s"));
  }
  line += seeds.empty() ? "no seed that counts" : seeds_text(seeds);
  if (!voids.empty()) line += fmt::format("; void and left out: {}", seeds_text(voids));
  if (!failed_seeds.empty()) line += fmt::format("; failed: {}", seeds_text(failed_seeds));
  return fmt::format("<p class=\"soft\">{}. castaway {}.</p>\n", line,
                     escape_html(first.value("castaway", "?")));
}

/// The notes of all runs in one line; empty if there are none.
std::string notes_line(const RunSet& set) {
  std::vector<std::string> notes;
  for (const SetRun& run : set.runs) {
    for (const Json& note : run.summary.value("notes", Json::array())) {
      const auto text = note.get<std::string>();
      if (std::find(notes.begin(), notes.end(), text) == notes.end()) notes.push_back(text);
    }
  }
  if (notes.empty()) return "";
  return fmt::format("<p class=\"soft\">Notes: {}.</p>\n",
                     escape_html(fmt::format("{}", fmt::join(notes, "; "))));
}

std::string result_section(const RunSet& set, std::vector<Check> checks) {
  std::erase_if(checks,
                [](const Check& check) { return check.expectation.metric.starts_with("timing."); });
  return html_section(
      "Result",
      pooled_table(set) +
          "<p class=\"soft\">Below each figure its 95 % interval: Wilson's for recoveries, "
          "bootstrap "
          "for means; void runs do not count. Verdict: McNemar's exact test over the same kidnaps, "
          "corrected for all pairs of localizers (Holm).</p>\n" +
          expectation_list(checks));
}

std::string recoveries_section(const RunSet& set) {
  const std::string chart = recoveries_chart(set);
  if (chart.empty()) return "";
  return html_section(
      "Recoveries", chart +
                        "<p class=\"soft\">Share of the kidnaps that a localizer has recovered "
                        "from (Kaplan-Meier), with its 95 % interval. A kidnap without recovery is "
                        "observed until the next one or the end of its run.</p>\n");
}

}  // namespace

std::string render_runs_page(const ShownRuns& page) {
  const RunSet set = load_run_set(page.folders);
  const std::string title = title_of(set);
  const std::string body =
      fmt::format("<h1>{}</h1>\n", escape_html(title)) + head_line(set, page.failed_seeds) +
      notes_line(set) + result_section(set, page.checks) + recoveries_section(set) +
      html_section("Runs", data_table_html(runs_table(set, page.failed_seeds, page.page),
                                           "There is no run."));
  return html_page(
      {.title = title, .body = body, .body_class = "figures", .bundle = campaign_bundle()});
}

}  // namespace castaway::testbed
