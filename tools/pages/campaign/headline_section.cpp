#include "tools/pages/campaign/headline_section.hpp"

#include <fmt/format.h>

#include "tools/base/formats/html.hpp"
#include "tools/pages/html/data_table.hpp"
#include "tools/pages/html/html_page.hpp"
#include "tools/pages/runs/expectation_list.hpp"
#include "tools/run/metrics/statistics/intervals.hpp"

namespace castaway::testbed {
namespace {

std::string localizer_sentence(const CampaignFigures& figures, std::size_t k) {
  const Survival& times = figures.recoveries.overall(k);
  const std::string name = escape_html(figures.series[k].label);
  if (times.size() == 0) return fmt::format("<p><strong>{}</strong>: no kidnap.</p>\n", name);
  const RateInterval interval = wilson_interval(times.events(), times.size());
  const auto median = times.median_s();
  return fmt::format(
      "<p><strong>{}</strong>: recovered from {} of {} kidnaps ({:.1f} %, 95 % interval {:.1f} to "
      "{:.1f} %), {}.</p>\n",
      name, times.events(), times.size(), 100.0 * times.events() / times.size(),
      100.0 * interval.low, 100.0 * interval.high,
      median ? "half of them within " + readable(median, "s") : "the median time was not reached");
}

std::string seeds_text(const CampaignSpec& spec) {
  return fmt::format("{}{} seeds", spec.until ? "up to " : "", spec.design.seeds());
}

}  // namespace

std::string headline_html(const FinishedCampaign& campaign, const CampaignFigures& figures) {
  int kidnaps = 0;
  int recovered = 0;
  std::string sentences;
  for (std::size_t k = 0; k < figures.series.size(); ++k) {
    kidnaps += figures.recoveries.overall(k).size();
    recovered += figures.recoveries.overall(k).events();
    sentences += localizer_sentence(figures, k);
  }
  if (figures.series.empty()) sentences = "<p>No cell has figures of a localizer.</p>\n";
  const CampaignSpec& spec = campaign.spec;
  return fmt::format(
             "<h1>Campaign {}</h1>\n<p>{} cells: {} done, {} void, {} failed. {} combinations, {} "
             "of each. Kidnaps of all localizers: {}, recoveries: {}.</p>\n<div "
             "class=\"lead\">\n{}</div>\n",
             escape_html(spec.name), campaign.rows.jobs().size(), figures.cells(CellOutcome::kDone),
             figures.cells(CellOutcome::kVoid), figures.cells(CellOutcome::kFailed),
             spec.combinations(), seeds_text(spec), kidnaps, recovered, sentences) +
         expectation_list(campaign.checks);
}

std::string unscored_section(const CampaignFigures& figures) {
  DataTable table{"not-scored", {"reason", "state", "cells", "first cell"}, {}};
  for (const auto& [reason, cells] : figures.reasons) {
    table.rows.push_back({reason.empty() ? "-" : reason, to_string(cells.state),
                          count_cell(cells.cells), count_cell(cells.first)});
  }
  if (table.rows.empty()) return "";
  return html_section("Cells that are not scored", data_table_html(table, ""));
}

}  // namespace castaway::testbed
