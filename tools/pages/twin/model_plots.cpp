#include "tools/pages/twin/model_plots.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "tools/pages/html/plot_data.hpp"
#include "tools/pages/twin/lidar_plots.hpp"

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

Json slip_plot(const SlipFit& slip) {
  PlotPoints data;
  PlotPoints model;
  for (const SlipFit::Tail& tail : slip.tail) {
    if (tail.measured > 0.0) data.emplace_back(tail.sigmas, tail.measured);
    model.emplace_back(tail.sigmas, tail.model);
  }
  return {
      {"title", "Slips: errors of the yaw over 1 m, against noise and slips"},
      {"x", {{"label", "error / standard deviation of the noise"}}},
      {"y", {{"label", "share above"}, {"log", {1e-5, 1.0}}}},
      {"series", {point_series("model", "reference", model), point_series("log", "dots", data)}},
      {"nothing", "The robot drove too little."}};
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

Json model_plots(const FittedLog& fitted) {
  Json plots = Json::array();
  if (fitted.fit.odometry) {
    constexpr double kDegrees = 180.0 / std::numbers::pi;
    const OdometryFit& odometry = *fitted.fit.odometry;
    plots.push_back(miss_plot(odometry.yaw_by_turn, "Error of the yaw over 1 m", "turned [rad]",
                              "standard deviation [deg]", kDegrees));
    plots.push_back(miss_plot(odometry.along_by_speed, "Error of the distance over 1 m",
                              "speed at the scans [m/s]", "standard deviation [m]", 1.0));
    plots.push_back(slip_plot(odometry.slip));
  }
  for (Json& plot : lidar_plots(fitted)) plots.push_back(std::move(plot));
  if (fitted.fit.clock) plots.push_back(clock_plot(*fitted.fit.clock));
  plots.push_back(period_plot(fitted.log.stamps));
  return plots;
}

}  // namespace castaway::testbed
