#include "tools/pages/campaign/figures_section.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/pages/html/html_page.hpp"
#include "tools/pages/html/plot_data.hpp"
#include "tools/pages/html/web_bundle.hpp"

namespace castaway::testbed {
namespace {

DataCell interval_cell(const std::optional<Interval>& interval) {
  if (!interval) return "–";
  return fmt::format("{:.3g} to {:.3g}", interval->low, interval->high);
}

std::vector<DataCell> figure_cells(const PooledFigure* figure) {
  if (figure == nullptr) return {number_cell(std::nullopt), "–"};
  return {number_cell(figure->mean.mean()), interval_cell(figure->interval())};
}

std::vector<DataCell> figures_row(std::vector<DataCell> row, const Survival& times,
                                  const PooledFigure* recovered, const PooledFigure* tracking) {
  row.push_back(count_cell(times.size()));
  for (DataCell& cell : figure_cells(recovered)) row.push_back(std::move(cell));
  row.push_back(number_cell(times.median_s()));
  for (DataCell& cell : figure_cells(tracking)) row.push_back(std::move(cell));
  return row;
}

/// Share that has recovered by a time, with its interval. Dashes if nothing was observed for as
/// long and some had not recovered; no interval of none and of all, for which Greenwood's has no
/// width.
std::vector<DataCell> recovered_by(const Survival& times, double time_s) {
  SurvivalStep last;
  for (const SurvivalStep& step : times.steps()) {
    if (step.time_s <= time_s) last = step;
  }
  const bool known = times.longest_s() >= time_s || last.survival == 0.0;
  if (times.size() == 0 || !known) return {number_cell(std::nullopt), "–"};
  if (last.survival == 0.0 || last.survival == 1.0) {
    return {number_cell(1.0 - last.survival), "–"};
  }
  return {number_cell(1.0 - last.survival),
          interval_cell(Interval{1.0 - last.interval.high, 1.0 - last.interval.low})};
}

DataTable recovery_table(const CampaignFigures& figures) {
  DataTable table{"recovery",
                  {"localizer", "kidnaps", "recovered", "run ended before", "median [s]",
                   "within 2 s", "within 2 s, 95 %", "within 10 s", "within 10 s, 95 %"},
                  {}};
  for (std::size_t k = 0; k < figures.series.size(); ++k) {
    const Survival& times = figures.recoveries.overall(k);
    std::vector<DataCell> row{figures.series[k].label, count_cell(times.size()),
                              count_cell(times.events()), count_cell(times.censored()),
                              number_cell(times.median_s())};
    for (const double time_s : {2.0, 10.0}) {
      for (DataCell& cell : recovered_by(times, time_s)) row.push_back(std::move(cell));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// An empty element of a class with the data that the page's script draws in it.
std::string drawn_html(const char* style, const nlohmann::ordered_json& data) {
  if (!campaign_bundle()) return "";
  return fmt::format("<div class=\"{}\"></div><script type=\"application/json\">{}</script>\n",
                     style, script_json(data));
}

}  // namespace

DataTable figures_table(const CampaignFigures& figures) {
  DataTable table{"figures",
                  {"key", "value", "localizer", "kidnaps", "recovered", "recovered, 95 %",
                   "median time [s]", "tracking error [m]", "error, 95 %"},
                  {}};
  for (std::size_t k = 0; k < figures.series.size(); ++k) {
    const std::string label = figures.series[k].label;
    table.rows.push_back(figures_row({"all", "", label}, figures.recoveries.overall(k),
                                     figures.figures.overall(k, kRecovered),
                                     figures.figures.overall(k, kTracking)));
  }
  const std::vector<KeyAxis>& axes = figures.figures.axes();
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    for (std::size_t place = 0; place < axes[axis].places().size(); ++place) {
      for (std::size_t k = 0; k < figures.series.size(); ++k) {
        const std::string& value = axes[axis].places()[place].label;
        const DataCell sorted(value, axes[axis].is_numeric()
                                         ? std::optional(axes[axis].places()[place].x)
                                         : std::nullopt);
        table.rows.push_back(figures_row({axes[axis].key(), sorted, figures.series[k].label},
                                         figures.recoveries.at(axis, place, k),
                                         figures.figures.find(axis, place, k, kRecovered),
                                         figures.figures.find(axis, place, k, kTracking)));
      }
    }
  }
  return table;
}

std::string figures_section(const CampaignFigures& figures) {
  std::string html =
      "<p class=\"soft\">Means over the cells that are done; all keys but that of the axis are "
      "pooled. recovery.success is the share of kidnaps, with Wilson's 95 % interval, which takes "
      "kidnaps as independent. All other intervals are Student's with the variance between seeds, "
      "as "
      "the cells of a seed have the same places. Drawn numbers are divided into ranges with "
      "equally "
      "many seeds.</p>\n";
  if (!figures.figures.axes().empty()) {
    html += drawn_html("campaign-curves", key_figures_json(figures.figures, figures.labels(),
                                                           series_styles(figures.series)));
  }
  return html_section("Figures over the keys",
                      html + data_table_html(figures_table(figures), "No figures."));
}

std::string recovery_section(const CampaignFigures& figures) {
  std::string html =
      "<p class=\"soft\">Share of kidnaps not yet recovered (Kaplan-Meier). A kidnap without "
      "recovery is observed until the next kidnap or the end of its run. Intervals: Greenwood, "
      "log-log.</p>\n";
  std::vector<std::string> labels = figures.labels();
  labels.pop_back();
  if (!labels.empty()) {
    html += drawn_html("campaign-recovery", recovery_curves_json(figures.recoveries, labels,
                                                                 series_styles(figures.series)));
  }
  return html_section("Time to recovery",
                      html + data_table_html(recovery_table(figures), "No kidnaps."));
}

}  // namespace castaway::testbed
