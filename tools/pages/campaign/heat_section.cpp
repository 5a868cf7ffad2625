#include "tools/pages/campaign/heat_section.hpp"

#include <array>
#include <limits>

#include <fmt/format.h>

#include "tools/base/formats/html.hpp"
#include "tools/pages/html/data_table.hpp"
#include "tools/pages/html/html_page.hpp"
#include "tools/pages/run/map_svg.hpp"

namespace castaway::testbed {
namespace {

using Steps = std::array<double, 5>;  // Upper ends, included; the sixth step is open.

constexpr Steps kShareSteps{0.0, 0.2, 0.4, 0.6, 0.8};
constexpr Steps kTimeSteps{1.0, 2.0, 5.0, 10.0, 20.0};  // [s]
constexpr Steps kCountSteps{1.0, 2.0, 5.0, 10.0, 20.0};

int step_of(double value, const Steps& steps) {
  int step = 0;
  for (const double end : steps) step += value > end ? 1 : 0;
  return step;
}

std::string bin_words(const BinNumber& at, const HeatBin& bin) {
  return fmt::format(
      "x {:g} to {:g} m, y {:g} to {:g} m: {} kidnaps, {} without recovery, median {}",
      at.first * kBinEdge, (at.first + 1) * kBinEdge, at.second * kBinEdge,
      (at.second + 1) * kBinEdge, bin.kidnaps, bin.failures, readable(bin.median_s(), "s"));
}

/// A square with its count. Its classes say which colour it has by share, time and count.
std::string bin_svg(const RosMap& map, const BinNumber& at, const HeatBin& bin) {
  std::string corners;
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
    const Eigen::Vector2d p_map(kBinEdge * (at.first + x), kBinEdge * (at.second + y));
    const Eigen::Vector2d p = map_pixel(map, p_map);
    corners += fmt::format("{:.1f},{:.1f} ", p.x(), p.y());
  }
  const Eigen::Vector2d middle =
      map_pixel(map, kBinEdge * Eigen::Vector2d(at.first + 0.5, at.second + 0.5));
  const double edge = kBinEdge / map.resolution;
  const double time = bin.median_s().value_or(std::numeric_limits<double>::infinity());
  return fmt::format(
      "<g class=\"f{} t{} n{}\"><title>{}</title><polygon points=\"{}\"/><text x=\"{:.1f}\" "
      "y=\"{:.1f}\" style=\"font-size:{:.1f}px\">{}</text></g>\n",
      step_of(bin.failure_share(), kShareSteps), step_of(time, kTimeSteps),
      step_of(bin.kidnaps, kCountSteps), bin_words(at, bin), corners, middle.x(),
      middle.y() + 0.15 * edge, 0.45 * edge, bin.kidnaps);
}

/// An empty grid around all bins of a world.
RosMap grid_around(const CampaignFigures& figures, const std::string& world) {
  int low_x = 0;
  int low_y = 0;
  int high_x = 1;
  int high_y = 1;
  bool first = true;
  for (std::size_t k = 0; k < figures.series.size(); ++k) {
    for (const auto& [at, bin] : figures.heat.bins(world, k)) {
      low_x = first ? at.first : std::min(low_x, at.first);
      low_y = first ? at.second : std::min(low_y, at.second);
      high_x = first ? at.first + 1 : std::max(high_x, at.first + 1);
      high_y = first ? at.second + 1 : std::max(high_y, at.second + 1);
      first = false;
    }
  }
  RosMap grid;
  grid.origin_x = kBinEdge * low_x;
  grid.origin_y = kBinEdge * low_y;
  grid.width = static_cast<int>(kBinEdge * (high_x - low_x) / grid.resolution);
  grid.height = static_cast<int>(kBinEdge * (high_y - low_y) / grid.resolution);
  return grid;
}

/// Swatches of the six steps. `style`: "f", "t" or "n", as the classes of bins.
std::string legend_of(const char* style, const char* title,
                      const std::array<const char*, 6>& words) {
  std::string html =
      fmt::format("<p class=\"legend heat-legend of-{}\"><span>{}</span>", style, title);
  for (std::size_t i = 0; i < words.size(); ++i) {
    html += fmt::format("<span><i class=\"h{}\"></i> {}</span>", i, words[i]);
  }
  return html + "</p>\n";
}

std::string heat_legends() {
  return legend_of("f", "Without recovery:",
                   {"none", "up to 20 %", "up to 40 %", "up to 60 %", "up to 80 %", "more"}) +
         legend_of("t", "Median time to recovery:",
                   {"up to 1 s", "up to 2 s", "up to 5 s", "up to 10 s", "up to 20 s",
                    "longer or never"}) +
         legend_of("n", "Kidnaps:", {"1", "2", "up to 5", "up to 10", "up to 20", "more"});
}

/// Selects a localizer and what the colours show; hidden unless the page's script runs.
std::string heat_choices(const CampaignFigures& figures) {
  std::string options;
  for (std::size_t k = 0; k < figures.series.size(); ++k) {
    options +=
        fmt::format("<option value=\"{}\">{}</option>", k, escape_html(figures.series[k].label));
  }
  return fmt::format(
      "<p class=\"choices\" hidden><label>Localizer <select class=\"heat-series\">{}</select>"
      "</label> <label>Colour <select class=\"heat-measure\"><option value=\"f\">without "
      "recovery</option><option value=\"t\">median time</option><option value=\"n\">number"
      "</option></select></label></p>\n",
      options);
}

DataTable places_table(const CampaignFigures& figures) {
  DataTable table{"places",
                  {"world", "localizer", "from x [m]", "from y [m]", "kidnaps", "without recovery",
                   "share", "median time [s]"},
                  {}};
  for (const std::string& world : figures.heat.worlds()) {
    for (std::size_t k = 0; k < figures.series.size(); ++k) {
      for (const auto& [at, bin] : figures.heat.bins(world, k)) {
        table.rows.push_back({world, figures.series[k].label, number_cell(at.first * kBinEdge),
                              number_cell(at.second * kBinEdge), count_cell(bin.kidnaps),
                              count_cell(bin.failures), number_cell(bin.failure_share()),
                              number_cell(bin.median_s())});
      }
    }
  }
  return table;
}

}  // namespace

std::string heat_svg(const CampaignFigures& figures, const std::string& world,
                     const std::optional<RosMap>& map) {
  const RosMap around = map ? RosMap{} : grid_around(figures, world);
  const RosMap& grid = map ? *map : around;
  std::string layers;
  for (std::size_t k = 0; k < figures.series.size(); ++k) {
    layers += fmt::format("<g class=\"heat\" data-series=\"{}\"{}>\n", k,
                          k == 0 ? "" : " style=\"display:none\"");
    for (const auto& [at, bin] : figures.heat.bins(world, k)) layers += bin_svg(grid, at, bin);
    layers += "</g>\n";
  }
  return map_svg(grid, map.has_value(), layers, "kidnap targets on the map of " + world);
}

std::string heat_section(const FinishedCampaign& campaign, const CampaignFigures& figures,
                         MapOfWorld map_of_world) {
  std::string html = fmt::format(
      "<p class=\"soft\">Where kidnaps ended, in squares of {:g} m, with their number. Counted are "
      "the scored rows of kidnaps.csv whose cell is done. {} kidnaps and unknown starts have no "
      "target. A median counts kidnaps without recovery as longer than observed.</p>\n",
      kBinEdge, figures.heat.without_target());
  if (figures.heat.worlds().empty()) {
    return html_section("Where kidnaps fail", html + "<p class=\"soft\">No targets.</p>\n");
  }
  html += "<div class=\"heat-maps by-f\">" + heat_choices(figures) + heat_legends();
  for (const std::string& world : figures.heat.worlds()) {
    const std::optional<RosMap> map = map_of_world(campaign.spec, figures.worlds.at(world));
    html += fmt::format("<h3>{}</h3>\n{}", escape_html(world), heat_svg(figures, world, map));
  }
  html += "</div>\n<details><summary>The squares as a table</summary>\n" +
          data_table_html(places_table(figures), "") + "</details>\n";
  return html_section("Where kidnaps fail", html);
}

}  // namespace castaway::testbed
