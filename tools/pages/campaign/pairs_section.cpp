#include "tools/pages/campaign/pairs_section.hpp"

#include <cmath>

#include <fmt/format.h>

#include "tools/pages/html/data_table.hpp"
#include "tools/pages/html/html_page.hpp"

namespace castaway::testbed {
namespace {

DataCell p_cell(double p) {
  return {p < 0.001 ? std::string("< 0.001") : fmt::format("{:.3f}", p), p};
}

std::vector<DataCell> test_row(const CampaignFigures& figures, const PairedTest& test) {
  std::string interval = "–";
  if (test.interval) {
    interval = fmt::format("{:+.3g} to {:+.3g}", test.interval->low, test.interval->high);
  }
  constexpr double kLevel = 0.05;
  return {figures.series[test.first].label,
          figures.series[test.second].label,
          test.figure,
          count_cell(test.pairs),
          count_cell(test.seeds),
          {fmt::format("{:+.3g}", test.difference), test.difference},
          interval,
          test.counts.empty() ? DataCell("–") : DataCell(test.counts),
          p_cell(test.p_value),
          p_cell(test.corrected),
          test.corrected < kLevel ? "yes" : "not seen"};
}

}  // namespace

std::string pairs_section(const CampaignFigures& figures) {
  DataTable table{"pairs",
                  {"first", "second", "figure", "pairs", "seeds", "first minus second", "95 %",
                   "only first to only second", "p", "p, corrected", "differs"},
                  {}};
  for (const PairedTest& test : paired_tests(figures.pairs)) {
    table.rows.push_back(test_row(figures, test));
  }
  return html_section(
      "Localizers in the same cells",
      "<p class=\"soft\">Pairs are kidnaps (tracking error: cells) of the same scenario and seed. "
      "Recovered: exact McNemar test and interval of Agresti and Min, which take pairs as "
      "independent. All other rows take seeds as independent, as the cells of a seed have the same "
      "places: sign-flip test of the seeds' totals (Student's for more than 2000 seeds), Student's "
      "interval with the variance between seeds. Time to recovery: kidnaps that both recovered "
      "from; "
      "time lost: all kidnaps, to the recovery or else to the end of observation. Corrected: Holm, "
      "over all rows; below 0.05 a difference is called one.</p>\n" +
          data_table_html(table, "No two localizers were in the same cells."));
}

}  // namespace castaway::testbed
