#include "tools/metrics/metrics_json.hpp"

#include <cmath>

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

/// Nine digits after the point: far below what is measured, and the same text everywhere.
Json figure(double value) { return std::round(value * 1e9) / 1e9; }

Json figure(const std::optional<double>& value) { return value ? figure(*value) : Json(); }

Json error_figures(const std::optional<Statistics>& s) {
  if (!s) {
    return {{"mean", nullptr},
            {"median", nullptr},
            {"p95", nullptr},
            {"rmse", nullptr},
            {"max", nullptr}};
  }
  return {{"mean", figure(s->mean)},
          {"median", figure(s->median)},
          {"p95", figure(s->p95)},
          {"rmse", figure(s->rmse)},
          {"max", figure(s->max)}};
}

Json event_figures(const std::optional<Statistics>& s) {
  Json figures = error_figures(s);
  figures.erase("rmse");
  return figures;
}

Json bin_figures(const Calibration& calibration, std::size_t index) {
  const CalibrationBin& bin = calibration.bins[index];
  const auto count = static_cast<double>(calibration.bins.size());
  const RateInterval interval = bin.interval();
  return {{"from", figure(static_cast<double>(index) / count)},
          {"to", figure(static_cast<double>(index + 1) / count)},
          {"scans", bin.scans},
          {"right", bin.right},
          {"stated", figure(bin.stated())},
          {"observed", figure(bin.observed())},
          {"interval", {figure(interval.low), figure(interval.high)}}};
}

Json window_figures(const RecoveryWindow& window) {
  return {{"kind", window.kind},
          {"taken_s", figure(seconds(window.taken))},
          {"at_s", figure(seconds(window.begin))},
          {"scored", window.scored},
          {"recovered", window.recovered.has_value()},
          {"time_s", window.recovered ? figure(seconds(*window.recovered - window.begin)) : Json()},
          {"distance_m", window.recovered ? figure(window.distance_m) : Json()},
          {"detection_delay_s", figure(window.detection_delay_s())},
          {"wrong_lock_s", figure(window.wrong_lock_s)}};
}

Json each_window(const std::vector<RecoveryWindow>& windows) {
  Json list = Json::array();
  for (const RecoveryWindow& window : windows) list.push_back(window_figures(window));
  return list;
}

}  // namespace

Json to_json(const Calibration& calibration) {
  Json json = {{"brier", figure(calibration.brier())},
               {"scans", calibration.scans()},
               {"bins", Json::array()}};
  for (std::size_t i = 0; i < calibration.bins.size(); ++i) {
    json["bins"].push_back(bin_figures(calibration, i));
  }
  return json;
}

Json to_json(const FaultMetrics& metrics) {
  return {{"mean_error_m", figure(metrics.mean_error_m)},
          {"wrong_confident_share", figure(metrics.wrong_confident_share)},
          {"alarm", metrics.alarm}};
}

Json to_json(const LocalizerMetrics& metrics) {
  const auto& delay = metrics.detection_delay_s;
  return {{"position_error_m", error_figures(metrics.position_error_m)},
          {"yaw_error_rad", error_figures(metrics.yaw_error_rad)},
          {"tracking_error_m", error_figures(metrics.tracking_error_m)},
          {"recovery",
           {{"events", metrics.events},
            {"recovered", metrics.recovered},
            {"success", figure(metrics.success)},
            {"time_s", event_figures(metrics.recovery_time_s)},
            {"distance_m", event_figures(metrics.recovery_distance_m)},
            {"each", each_window(metrics.windows)}}},
          {"wrong_lock_share", figure(metrics.wrong_lock_share)},
          {"alarm",
           {{"detection_delay_s",
             {{"mean", delay ? figure(delay->mean) : Json()},
              {"max", delay ? figure(delay->max) : Json()}}},
            {"undetected", metrics.undetected},
            {"false_per_h", figure(metrics.false_alarms_per_h)}}},
          {"calibration", to_json(metrics.calibration)}};
}

}  // namespace castaway::testbed
