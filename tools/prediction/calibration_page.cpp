#include "tools/prediction/calibration_page.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "tools/campaign/experiment_table.hpp"
#include "tools/prediction/building_plot.hpp"
#include "tools/prediction/calibration_lines.hpp"
#include "tools/report/experiment_page.hpp"
#include "tools/report/html/html.hpp"
#include "tools/report/html/html_page.hpp"
#include "tools/report/html/plot_data.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostOfCurve = 300;

/// The cumulative distribution of ascending samples.
PlotPoints cumulative(const std::vector<double>& samples) {
  PlotPoints points;
  const auto count = static_cast<double>(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    points.emplace_back(samples[i], static_cast<double>(i + 1) / count);
  }
  return every_few(points, kMostOfCurve);
}

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

Json noise_plot(const RangeNoiseFit& noise) {
  PlotPoints data;
  PlotPoints model;
  for (const RangeNoiseFit::Bin& bin : noise.bins) {
    data.emplace_back(bin.range_m, bin.sigma_m);
    model.emplace_back(bin.range_m, noise.sigma_m.value + noise.sigma_relative.value * bin.range_m);
  }
  return {
      {"title", "Noise of ranges"},
      {"x", {{"label", "range [m]"}}},
      {"y", {{"label", "standard deviation [m]"}}},
      {"series", {point_series("model", "reference", model), point_series("log", "dots", data)}},
      {"nothing", "Too few beams on straight walls."}};
}

/// Lost beams of the log, and of the model, among those at one range or incidence.
struct LossBin {
  double at = 0.0;
  double beams = 0.0;
  double lost = 0.0;
  double modelled = 0.0;
};

Json loss_plot(const LossFit& fit, const char* title, const char* label,
               double LossCell::*coordinate) {
  constexpr int kBins = 12;
  const LossShares shares{fit.dropout.value, fit.dropout_far.value, fit.dropout_grazing.value};
  std::vector<LossBin> bins(kBins);
  for (const LossCell& cell : fit.cells) {
    const int index = std::clamp(static_cast<int>(kBins * cell.*coordinate), 0, kBins - 1);
    LossBin& bin = bins[static_cast<std::size_t>(index)];
    bin.at += cell.beams * cell.*coordinate;
    bin.beams += cell.beams;
    bin.lost += cell.lost;
    bin.modelled += cell.beams * lost_share(shares, cell);
  }
  constexpr double kFewest = 50.0;  // Beams.
  PlotPoints data;
  PlotPoints model;
  for (const LossBin& bin : bins) {
    if (bin.beams < kFewest) continue;
    data.emplace_back(bin.at / bin.beams, bin.lost / bin.beams);
    model.emplace_back(bin.at / bin.beams, bin.modelled / bin.beams);
  }
  return {
      {"title", title},
      {"x", {{"label", label}, {"range", {0, 1}}}},
      {"y", {{"label", "share lost"}}},
      {"series", {point_series("model", "reference", model), point_series("log", "dots", data)}},
      {"nothing", "Too few beams on straight walls."}};
}

Json mixed_plot(const MixedFit& fit, double spacing_deg) {
  PlotPoints data;
  PlotPoints model;
  const double share = fit.divergence_deg.value / spacing_deg;
  for (const MixedFit::Bin& bin : fit.bins) {
    const double mixed = bin.step_m < fit.reach_m ? share : 0.0;
    data.emplace_back(bin.step_m, bin.mixed / bin.steps);
    model.emplace_back(bin.step_m, (mixed + fit.other) * bin.visible / bin.steps);
  }
  return {
      {"title", "Mixed pixels: depth steps with a beam in between"},
      {"x", {{"label", "step [m]"}, {"range", {0, 8}}}},
      {"y", {{"label", "share of steps"}}},
      {"series", {point_series("model", "reference", model), point_series("log", "dots", data)}}};
}

Json clock_plot(const ClockFit& clock) {
  constexpr std::size_t kMostDots = 1000;
  PlotPoints data;
  double widest = 0.0;
  for (const ClockFit::Sample& sample : clock.samples) {
    data.emplace_back(sample.change_rad_s, sample.miss_rad);
    widest = std::max(widest, std::abs(sample.change_rad_s));
  }
  const double end = clock.offset_s.value * widest;
  return {{"title", "Clock: turn that odometry measured too much"},
          {"x", {{"label", "change of the turn rate between two scans [rad/s]"}}},
          {"y", {{"label", "turn [rad]"}, {"range", {-0.05, 0.05}}}},
          {"series",
           {point_series("model", "reference", {{-widest, -end}, {widest, end}}),
            point_series("log", "dots", every_few(data, kMostDots))}}};
}

Json period_plot(const std::vector<Stamp>& stamps) {
  std::vector<double> periods;
  for (std::size_t i = 1; i < stamps.size(); ++i) {
    periods.push_back(seconds(stamps[i] - stamps[i - 1]));
  }
  std::sort(periods.begin(), periods.end());
  const double most = periods.empty() ? 1.0 : 1.5 * percentile(periods, 0.98);
  return {{"title", "Time between scans; the twin's are the same"},
          {"x", {{"label", "time [s]"}, {"range", {0, most}}}},
          {"y", {{"label", "share below"}, {"range", {0, 1}}}},
          {"series", {point_series("log", "", cumulative(periods))}}};
}

std::string model_section(const FittedLog& fitted) {
  Json plots = Json::array();
  if (fitted.fit.noise) plots.push_back(noise_plot(*fitted.fit.noise));
  if (fitted.fit.loss) {
    plots.push_back(loss_plot(*fitted.fit.loss, "Lost beams by range", "range / maximum range",
                              &LossCell::range_per_max));
    plots.push_back(loss_plot(*fitted.fit.loss, "Lost beams by incidence",
                              "cosine of the angle of incidence", &LossCell::cosine));
  }
  if (fitted.fit.mixed) {
    const double increment = std::abs(fitted.log.scans.front().scan.angle_increment);
    plots.push_back(mixed_plot(*fitted.fit.mixed, increment * 180.0 / std::numbers::pi));
  }
  if (fitted.fit.clock) plots.push_back(clock_plot(*fitted.fit.clock));
  plots.push_back(period_plot(fitted.log.stamps));
  return html_section("Data beside model", plots_html({{"plots", plots}}, PlotLayout::kPairs));
}

std::string figures_section(const Twin& twin) {
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
  body += plots_notice() + figures_section(twin);
  if (plots_bundle()) body += likeness_section(twin.likeness) + model_section(twin.fitted);
  body += html_section("The building against its map", building_plot(twin.fitted, map));
  body += untold_section(twin.fitted.fit);
  return html_page(
      {.title = title, .body = body, .body_class = "figures", .bundle = plots_bundle()});
}

}  // namespace castaway::testbed
