// castaway campaign: its pages.
#include <cmath>
#include <map>
#include <regex>

#include "tests/program/campaign_files.hpp"
#include "tools/base/formats/csv.hpp"

namespace castaway::test {
namespace {

using testbed::CsvTable;

/// The small campaign with a second kidnap.
std::string spec_with_two_kidnaps() {
  std::string text = kGrid;
  text.replace(text.find("draw:"), text.find("seeds:") - text.find("draw:"), "");
  const std::size_t grid = text.find("grid:");
  return text.insert(grid, "    - kidnap: {kind: teleport, at_s: 9, min_distance_m: 2}\n");
}

/// A square of the page's table: localizer, x, y.
using Square = std::tuple<std::string, int, int>;
/// Kidnaps, and those without recovery.
using Counts = std::pair<int, int>;

std::map<Square, Counts> counts_of_page(const std::string& html) {
  const std::regex row(
      "<td data-head=\"localizer\">(\\w+)</td><td data-head=\"from x \\[m\\]\" "
      "data-value=\"(-?\\d+)\">[^<]*</td><td data-head=\"from y \\[m\\]\" "
      "data-value=\"(-?\\d+)\">[^<]*</td><td data-head=\"kidnaps\" "
      "data-value=\"(\\d+)\">[^<]*</td><td data-head=\"without recovery\" data-value=\"(\\d+)\">");
  std::map<Square, Counts> counts;
  for (auto it = std::sregex_iterator(html.begin(), html.end(), row); it != std::sregex_iterator();
       ++it) {
    const std::smatch& m = *it;
    counts[{m[1], std::stoi(m[2]), std::stoi(m[3])}] = {std::stoi(m[4]), std::stoi(m[5])};
  }
  return counts;
}

std::map<Square, Counts> counts_of_table(const fs::path& folder) {
  const CsvTable results = testbed::read_csv(folder / "results.csv");
  std::map<std::string, std::string> states;
  for (const auto& row : results.rows) states[row[0]] = row[results.column("state")];
  const CsvTable kidnaps = testbed::read_csv(folder / "kidnaps.csv");
  std::map<Square, Counts> counts;
  for (const auto& row : kidnaps.rows) {
    if (row[kidnaps.column("scored")] != "1" || states.at(row[0]) != "done") continue;
    const auto square_of = [&](const char* column) {
      return static_cast<int>(std::floor(std::stod(row[kidnaps.column(column)])));
    };
    auto& [all, failed] =
        counts[{row[kidnaps.column("localizer")], square_of("to_x_m"), square_of("to_y_m")}];
    ++all;
    failed += row[kidnaps.column("recovered")] == "1" ? 0 : 1;
  }
  return counts;
}

TEST(CampaignPage, ItsHeatMapIsAPlainCountOfTheKidnaps) {
  const fs::path folder = folder_with_spec(spec_with_two_kidnaps());
  ASSERT_EQ(castaway(folder, "campaign s.yaml --out c -j 2").exit_code, 0);
  const auto counts = counts_of_page(text_of(folder / "c/campaign.html"));
  EXPECT_GT(counts.size(), 6U);
  EXPECT_EQ(counts, counts_of_table(folder / "c"));
  EXPECT_NE(text_of(folder / "c/campaign.html").find("<image"), std::string::npos);
  EXPECT_NE(text_of(folder / "c/costs.html").find("simulated second"), std::string::npos);
}

TEST(CampaignPage, LinksTheReportsThatAreKept) {
  const std::string spec = std::string(spec_with_two_kidnaps()) + "keep: failures\n";
  const fs::path folder = folder_with_spec(
      std::regex_replace(spec, std::regex("  duration_s: 16"),
                         "  duration_s: 16\n  outputs: {report: true, player: true}"));
  ASSERT_EQ(castaway(folder, "campaign s.yaml --out c -j 2").exit_code, 0);
  const std::string html = text_of(folder / "c/campaign.html");
  const std::regex link("href=\"(cells/[^\"]*/report.html)#t=");
  std::smatch match;
  ASSERT_TRUE(std::regex_search(html, match, link));
  EXPECT_TRUE(fs::exists(folder / "c" / match[1].str()));
}

TEST(CampaignPage, OfCellsThatFailIsMade) {
  const fs::path folder = folder_with_spec(R"(name: failing
scenario:
  world: room.yaml
  duration_s: 2
  physics: kinematic
  events: []
  localizers: [{name: mine, program: [sh, -c, exit 7]}]
)");
  EXPECT_EQ(castaway(folder, "campaign s.yaml --out c --allow-programs").exit_code, 1);
  const std::string html = text_of(folder / "c/campaign.html");
  EXPECT_NE(html.find("1 cells: 0 done, 0 void, 1 failed"), std::string::npos);
  EXPECT_NE(html.find("Cells that are not scored"), std::string::npos);
}

TEST(CampaignPage, OfRunsWithoutKidnapsIsMade) {
  const fs::path folder = folder_with_spec(R"(name: calm
scenario: {world: room.yaml, duration_s: 3, physics: kinematic, events: [], localizers: [amcl]}
seeds: 2
)");
  ASSERT_EQ(castaway(folder, "campaign s.yaml --out c").exit_code, 0);
  const std::string html = text_of(folder / "c/campaign.html");
  EXPECT_NE(html.find("<strong>amcl</strong>: no kidnap."), std::string::npos);
  EXPECT_NE(html.find("No targets."), std::string::npos);
  EXPECT_NE(html.find("No two localizers"), std::string::npos);
}

}  // namespace
}  // namespace castaway::test
