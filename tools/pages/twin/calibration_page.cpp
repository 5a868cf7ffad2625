#include "tools/pages/twin/calibration_page.hpp"

#include <fmt/format.h>

#include "tools/base/formats/html.hpp"
#include "tools/batch/compare/experiment_table.hpp"
#include "tools/pages/html/html_page.hpp"
#include "tools/pages/html/plot_data.hpp"
#include "tools/pages/run/experiment_page.hpp"
#include "tools/pages/twin/building_plot.hpp"
#include "tools/pages/twin/model_plots.hpp"
#include "tools/twin/prediction/calibration_lines.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

std::string axis_label(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : name + " [" + unit + "]";
}

/// Both distributions of a quantity.
Json distributions(const LikeSamples& samples) {
  return {{"title", fmt::format("{}: Wasserstein distance {:.3g} {}", samples.name,
                                wasserstein_distance(samples.log, samples.twin), samples.unit)},
          {"x", {{"label", axis_label(samples.name, samples.unit)}}},
          {"y", {{"label", "share below"}, {"range", {0, 1}}}},
          {"series",
           {point_series("log", "", cumulative(samples.log)),
            point_series("twin", "", cumulative(samples.twin))}}};
}

Json drift_plot(const std::vector<DriftPoint>& drift) {
  PlotPoints log;
  PlotPoints twin;
  for (const DriftPoint& point : drift) {
    log.emplace_back(point.length_m, point.log_m);
    twin.emplace_back(point.length_m, point.twin_m);
  }
  return {{"title", "Error of odometry against distance"},
          {"x", {{"label", "distance [m]"}}},
          {"y", {{"label", "root mean square [m]"}}},
          {"series", {point_series("log", "marked", log), point_series("twin", "marked", twin)}},
          {"nothing", "The robot drove too little."}};
}

std::string likeness_section(const Likeness& likeness) {
  TextTable table{{"", "log: median", "90 %", "twin: median", "90 %", "Wasserstein distance"}, {}};
  Json plots = Json::array();
  for (const LikeSamples& s : likeness.samples) {
    const auto cell = [](double value) { return fmt::format("{:.3g}", value); };
    table.rows.push_back({axis_label(s.name, s.unit), cell(percentile(s.log, 0.5)),
                          cell(percentile(s.log, 0.9)), cell(percentile(s.twin, 0.5)),
                          cell(percentile(s.twin, 0.9)),
                          cell(wasserstein_distance(s.log, s.twin))});
    plots.push_back(distributions(s));
  }
  plots.push_back(drift_plot(likeness.drift));
  return html_section("How alike log and twin are",
                      html_table(table) + plots_html({{"plots", plots}}, PlotLayout::kPairs));
}

std::string model_section(const FittedLog& fitted) {
  const Json plots = {{"plots", model_plots(fitted)}};
  return html_section("Data beside model", plots_html(plots, PlotLayout::kPairs));
}

std::string calibration_figures(const Twin& twin) {
  TextTable table{{"", "value", "95 % interval"}, {}};
  for (const CalibrationGroup& group : calibration_groups(twin)) {
    table.rows.push_back({group.heading, "", ""});
    for (const CalibrationLine& line : group.lines) {
      table.rows.push_back({line.name, line.value, line.interval});
    }
  }
  return html_section("What was found", html_table(table));
}

std::string untold_section(const LogFit& fit) {
  std::string items;
  const auto add = [&](bool missing, const char* text) {
    if (missing) items += fmt::format("<li>{}</li>\n", text);
  };
  add(!fit.odometry, "Errors of odometry: the robot drove less than 100 m. The twin's is exact.");
  add(!fit.clock,
      "The clock of the lidar against that of odometry: odometry comes at less than 8 Hz, or the "
      "turn rate hardly changes. The twin's clocks agree.");
  add(!fit.noise, "Noise of ranges: too few beams hit straight walls. The twin's are exact.");
  add(!fit.loss, "Lost beams: too few beams hit straight walls. The twin loses none.");
  add(!fit.mixed, "Mixed pixels: too few depth steps. The twin's beams are lines.");
  add(!fit.dust, "Dust: too few beams hit straight walls. The twin's air is clear.");
  add(!fit.beam_bias, "Offsets of beams: too few straight surfaces. The twin's beams have none.");
  add(!fit.range_limit,
      "A limit of the lidar below its stated maximum range: it returned from as far as there were "
      "walls.");
  add(true,
      "The height of the lidar, unless a bag states it. The twin's is at 0.3 m, so that it sees "
      "legs.");
  add(true, "The reflectivity of walls.");
  add(true,
      "The distance between the wheels: any robot with the same errors of distance, turn and "
      "curvature drives the same.");
  return html_section("What the log does not tell", "<ul>\n" + items + "</ul>\n");
}

}  // namespace

std::string render_calibration(const Twin& twin, const RosMap& map) {
  const AlignedLog& log = twin.fitted.log;
  const std::string title = "Twin of " + log.name;
  std::string body = fmt::format(
      "<h1>{}</h1>\n<p class=\"soft\">{}. <code>castaway run scenario.yaml</code> "
      "plays the twin.</p>\n",
      escape_html(title), escape_html(alignment_sentence(log)));
  body += plots_notice() + calibration_figures(twin);
  if (plots_bundle()) body += likeness_section(twin.likeness) + model_section(twin.fitted);
  body += html_section("The building against its map", building_plot(twin.fitted, map));
  body += untold_section(twin.fitted.fit);
  return html_page(
      {.title = title, .body = body, .body_class = "figures", .bundle = plots_bundle()});
}

}  // namespace castaway::testbed
