#include "tools/prediction/model_plots.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

/// `scale` converts misses to the unit shown.
Json miss_plot(const std::vector<MissBin>& bins, const char* title, const char* x, const char* y,
               double scale) {
  PlotPoints data;
  PlotPoints model;
  for (const MissBin& bin : bins) {
    data.emplace_back(bin.at, scale * bin.measured);
    model.emplace_back(bin.at, scale * bin.model);
  }
  return {
      {"title", title},
      {"x", {{"label", x}}},
      {"y", {{"label", y}}},
      {"series", {point_series("model", "reference", model), point_series("log", "dots", data)}},
      {"nothing", "The robot drove too little."}};
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

}  // namespace

PlotPoints cumulative(const std::vector<double>& samples) {
  PlotPoints points;
  const auto count = static_cast<double>(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    points.emplace_back(samples[i], static_cast<double>(i + 1) / count);
  }
  constexpr std::size_t kMostOfCurve = 300;
  return every_few(points, kMostOfCurve);
}

Json model_plots(const FittedLog& fitted) {
  Json plots = Json::array();
  if (fitted.fit.odometry) {
    constexpr double kDegrees = 180.0 / std::numbers::pi;
    const OdometryFit& odometry = *fitted.fit.odometry;
    plots.push_back(miss_plot(odometry.yaw_by_turn, "Error of the yaw over 1 m", "turned [rad]",
                              "standard deviation [deg]", kDegrees));
    plots.push_back(miss_plot(odometry.along_by_speed, "Error of the distance over 1 m",
                              "speed at the scans [m/s]", "standard deviation [m]", 1.0));
  }
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
  return plots;
}

}  // namespace castaway::testbed
