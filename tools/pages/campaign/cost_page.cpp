#include "tools/pages/campaign/cost_page.hpp"

#include <algorithm>
#include <set>
#include <tuple>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/formats/html.hpp"
#include "tools/pages/campaign/figures/cell_groups.hpp"
#include "tools/pages/campaign/figures/key_figures.hpp"
#include "tools/pages/html/data_table.hpp"
#include "tools/pages/html/html_page.hpp"
#include "tools/pages/html/plot_data.hpp"

namespace castaway::testbed {
namespace {

constexpr std::size_t kMostExpensive = 50;
constexpr const char* kCpu = "CPU time of a cell [s]";
constexpr const char* kCpuShare = "CPU time of a simulated second [s]";
constexpr const char* kMemory = "peak memory of the process [MB]";

/// A cell with its costs; the most expensive one comes first.
struct CellCost {
  int cell = 0;
  double cpu_s = 0.0;
  double wall_s = 0.0;
  double memory_mb = 0.0;

  bool operator<(const CellCost& other) const {
    return std::tuple(-cpu_s, cell) < std::tuple(-other.cpu_s, other.cell);
  }
};

/// Totals over all cells, failed ones included.
struct CampaignCosts {
  explicit CampaignCosts(const std::vector<KeyAxis>& axes) : figures(axes, 1) {}

  double cpu_s = 0.0;
  double wall_s = 0.0;
  double simulated_s = 0.0;
  double memory_mb = 0.0;  ///< Largest.
  KeyFigures figures;
  std::set<CellCost> expensive;

  void add(const CellRow& row) {
    cpu_s += row.cpu_s;
    wall_s += row.wall_s;
    memory_mb = std::max(memory_mb, row.memory_mb);
    expensive.insert({row.index, row.cpu_s, row.wall_s, row.memory_mb});
    if (expensive.size() > kMostExpensive) expensive.erase(std::prev(expensive.end()));
    figures.add(row, 0, kCpu, row.cpu_s);
    figures.add(row, 0, kMemory, row.memory_mb);
    const auto duration = row.metrics.find("duration_s");
    if (duration == row.metrics.end() || !duration->second || *duration->second <= 0.0) return;
    simulated_s += *duration->second;
    figures.add(row, 0, kCpuShare, row.cpu_s / *duration->second);
  }
};

DataTable totals_table(std::size_t count, const CampaignCosts& costs) {
  const auto cells = static_cast<double>(count);
  DataTable table{"totals", {"figure", "value"}, {}};
  table.rows = {{"cells", count_cell(static_cast<long long>(count))},
                {"CPU time [s]", number_cell(costs.cpu_s)},
                {"wall time of all cells [s]", number_cell(costs.wall_s)},
                {"simulated time [s]", number_cell(costs.simulated_s)},
                {"CPU time of a cell [s]", number_cell(costs.cpu_s / cells)},
                {"largest peak memory [MB]", number_cell(costs.memory_mb)}};
  if (costs.simulated_s > 0.0) {
    table.rows.push_back(
        {"CPU time of a simulated second [s]", number_cell(costs.cpu_s / costs.simulated_s)});
  }
  return table;
}

DataTable costs_by_key(const KeyFigures& figures) {
  DataTable table{"costs-by-key", {"key", "value", "figure", "cells", "mean", "95 %"}, {}};
  for (std::size_t axis = 0; axis < figures.axes().size(); ++axis) {
    const KeyAxis& key = figures.axes()[axis];
    for (std::size_t place = 0; place < key.places().size(); ++place) {
      for (const char* name : {kCpu, kCpuShare, kMemory}) {
        const PooledFigure* figure = figures.find(axis, place, 0, name);
        if (figure == nullptr) continue;
        const auto ends = figure->interval();
        table.rows.push_back({key.key(), key.places()[place].label, name,
                              count_cell(figure->mean.count()), number_cell(figure->mean.mean()),
                              ends ? fmt::format("{:.3g} to {:.3g}", ends->low, ends->high) : "–"});
      }
    }
  }
  return table;
}

DataTable expensive_cells(const CampaignCosts& costs) {
  DataTable table{"expensive", {"cell", "CPU time [s]", "wall time [s]", "peak memory [MB]"}, {}};
  for (const CellCost& each : costs.expensive) {
    table.rows.push_back({count_cell(each.cell), number_cell(each.cpu_s), number_cell(each.wall_s),
                          number_cell(each.memory_mb)});
  }
  return table;
}

std::string cost_curves(const KeyFigures& figures) {
  if (!campaign_bundle() || figures.axes().empty()) return "";
  return fmt::format(
      "<div class=\"campaign-curves\"></div><script type=\"application/json\">{}</script>\n",
      script_json(key_figures_json(figures, {"cells"}, {-1})));
}

}  // namespace

std::string render_cost_page(const FinishedCampaign& campaign, const std::vector<KeyAxis>& axes) {
  CampaignCosts costs(axes);
  each_cell_group(campaign.spec, campaign.rows, [&](const std::vector<int>& cells) {
    for (const int cell : cells) costs.add(campaign.rows.row(cell));
  });
  const std::string title = "Costs of campaign " + campaign.spec.name;
  const std::string body =
      fmt::format(
          "<h1>{}</h1>\n<p class=\"soft\">From costs.csv; these figures differ in every "
          "repetition. "
          "Memory: the largest use of the process up to the end of a cell, which may have played "
          "others before. <a href=\"campaign.html\">Results</a></p>\n",
          escape_html(title)) +
      plots_notice() +
      html_section("Totals",
                   data_table_html(totals_table(campaign.rows.jobs().size(), costs), "")) +
      html_section("Over the keys", cost_curves(costs.figures) +
                                        data_table_html(costs_by_key(costs.figures), "No key.")) +
      html_section("Most expensive cells", data_table_html(expensive_cells(costs), "No cells."));
  return html_page(
      {.title = title, .body = body, .body_class = "figures", .bundle = campaign_bundle()});
}

}  // namespace castaway::testbed
