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

}  // namespace

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
            {"distance_m", event_figures(metrics.recovery_distance_m)}}},
          {"wrong_lock_share", figure(metrics.wrong_lock_share)},
          {"alarm",
           {{"detection_delay_s",
             {{"mean", delay ? figure(delay->mean) : Json()},
              {"max", delay ? figure(delay->max) : Json()}}},
            {"undetected", metrics.undetected},
            {"false_per_h", figure(metrics.false_alarms_per_h)}}}};
}

}  // namespace castaway::testbed
