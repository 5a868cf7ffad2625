#include "tools/run/metrics/metrics_json.hpp"

#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "tools/run/event_names.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

Json figure(double value) { return json_figure(value); }

Json figure(const std::optional<double>& value) { return json_figure(value); }

Json interval(const std::optional<Interval>& ends) {
  return ends ? Json{figure(ends->low), figure(ends->high)} : Json();
}

Json error_figures(const std::optional<Statistics>& s) {
  if (!s) {
    return {{"mean", nullptr},           {"median", nullptr}, {"p95", nullptr},
            {"rmse", nullptr},           {"max", nullptr},    {"mean_interval", nullptr},
            {"median_interval", nullptr}};
  }
  return {{"mean", figure(s->mean)},
          {"median", figure(s->median)},
          {"p95", figure(s->p95)},
          {"rmse", figure(s->rmse)},
          {"max", figure(s->max)},
          {"mean_interval", interval(s->mean_interval)},
          {"median_interval", interval(s->median_interval)}};
}

Json rate_interval(int successes, int trials) {
  if (trials == 0) return nullptr;
  const RateInterval ends = wilson_interval(successes, trials);
  return {figure(ends.low), figure(ends.high)};
}

Json jump_figures(const OutputJumps& jumps, bool has_truth) {
  return {{"count", jumps.count},
          {"while_tracking", has_truth ? Json(jumps.while_tracking) : Json()},
          {"largest_m", figure(jumps.largest_m)}};
}

Json roc_figures(const Discrimination& areas) {
  return {{"right", areas.right},
          {"wrong", areas.wrong},
          {"quality_auc", figure(areas.quality)},
          {"probability_auc", figure(areas.probability)},
          {"covariance_auc", figure(areas.covariance)}};
}

Json ape_figures(const std::optional<Ape>& ape) {
  const auto of = [&](double Ape::*value) { return ape ? figure((*ape).*value) : Json(); };
  return {{"pairs", ape ? ape->pairs : 0}, {"mean", of(&Ape::mean)}, {"median", of(&Ape::median)},
          {"rmse", of(&Ape::rmse)},        {"std", of(&Ape::std)},   {"min", of(&Ape::min)},
          {"max", of(&Ape::max)}};
}

Json event_figures(const std::optional<Statistics>& s) {
  Json figures = error_figures(s);
  figures.erase("rmse");
  return figures;
}

/// Figures of the outputs that state a probability in [from, to].
Json bin_figures(const CalibrationBin& bin, double from, double to) {
  const RateInterval rate = bin.interval();
  return {{"from", figure(from)},
          {"to", figure(to)},
          {"scans", bin.scans},
          {"right", bin.right},
          {"stated", figure(bin.stated())},
          {"observed", figure(bin.observed())},
          {"interval", bin.scans > 0 ? Json{figure(rate.low), figure(rate.high)} : Json()}};
}

Json window_figures(const RecoveryWindow& window) {
  return {{"kind", part_name(window.cause)},
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
  for (const RecoveryWindow& window : windows) {
    if (window.has_truth) list.push_back(window_figures(window));
  }
  return list;
}

}  // namespace

Json json_figure(double value) { return std::round(value * 1e9) / 1e9; }

Json json_figure(const std::optional<double>& value) {
  return value ? json_figure(*value) : Json();
}

Json to_json(const Calibration& calibration) {
  Json json = {{"brier", figure(calibration.brier())},
               {"scans", calibration.scans()},
               {"bins", Json::array()},
               {"sure", bin_figures(calibration.sure, kSure, 1.0)}};
  const auto count = static_cast<double>(calibration.bins.size());
  for (std::size_t i = 0; i < calibration.bins.size(); ++i) {
    const auto index = static_cast<double>(i);
    json["bins"].push_back(bin_figures(calibration.bins[i], index / count, (index + 1.0) / count));
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
  const auto scored = [&](Json value) { return metrics.has_truth ? std::move(value) : Json(); };
  return {{"position_error_m", error_figures(metrics.position_error_m)},
          {"yaw_error_rad", error_figures(metrics.yaw_error_rad)},
          {"tracking_error_m", error_figures(metrics.tracking_error_m)},
          {"recovery",
           {{"events", metrics.events},
            {"recovered", metrics.recovered},
            {"success", figure(metrics.success)},
            {"success_interval", rate_interval(metrics.recovered, metrics.events)},
            {"time_s", event_figures(metrics.recovery_time_s)},
            {"distance_m", event_figures(metrics.recovery_distance_m)},
            {"each", each_window(metrics.windows)}}},
          {"wrong_lock_share", figure(metrics.wrong_lock_share)},
          {"wrong_lock_s",
           {{"total", scored(figure(metrics.wrong_lock_s))},
            {"longest", scored(figure(metrics.longest_wrong_lock_s))}}},
          {"availability", figure(metrics.availability)},
          {"jumps", jump_figures(metrics.jumps, metrics.has_truth)},
          {"ape_m", ape_figures(metrics.ape)},
          {"alarm",
           {{"detection_delay_s",
             {{"mean", delay ? figure(delay->mean) : Json()},
              {"max", delay ? figure(delay->max) : Json()}}},
            {"undetected", scored(metrics.undetected)},
            {"false_per_h", figure(metrics.false_alarms_per_h)}}},
          {"discrimination", roc_figures(metrics.discrimination)},
          {"calibration", to_json(metrics.calibration)}};
}

}  // namespace castaway::testbed
