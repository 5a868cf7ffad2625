#include "tools/pages/run/report_tables.hpp"

#include <array>
#include <numbers>
#include <span>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/formats/html.hpp"
#include "tools/pages/run/report_words.hpp"
#include "tools/run/event_names.hpp"
#include "tools/run/metrics/void_run.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;
using nlohmann::json_literals::operator""_json_pointer;

constexpr double kToDegrees = 180.0 / std::numbers::pi;

/// A row of the metrics table; without a pointer, a heading. A count is an integer; `of` is the
/// pointer of its total.
struct MetricLine {
  const char* label;
  const char* pointer = "";
  const char* unit = "";
  double factor = 1.0;
  bool is_count = false;
  const char* of = "";
};

constexpr std::array<MetricLine, 24> kMetricLines{{
    {"Position error"},
    {"mean", "/position_error_m/mean", "m"},
    {"median", "/position_error_m/median", "m"},
    {"95 % below", "/position_error_m/p95", "m"},
    {"largest", "/position_error_m/max", "m"},
    {"Yaw error"},
    {"mean", "/yaw_error_rad/mean", "°", kToDegrees},
    {"95 % below", "/yaw_error_rad/p95", "°", kToDegrees},
    {"Position error while tracking"},
    {"mean", "/tracking_error_m/mean", "m"},
    {"95 % below", "/tracking_error_m/p95", "m"},
    {"largest", "/tracking_error_m/max", "m"},
    {"Recovery"},
    {.label = "recovered",
     .pointer = "/recovery/recovered",
     .is_count = true,
     .of = "/recovery/events"},
    {"time, median", "/recovery/time_s/median", "s"},
    {"time, largest", "/recovery/time_s/max", "s"},
    {"distance, median", "/recovery/distance_m/median", "m"},
    {"Honesty"},
    {"right claimed while wrong", "/wrong_lock_share", "%", 100.0},
    {"kidnap noticed after, mean", "/alarm/detection_delay_s/mean", "s"},
    {"kidnap noticed after, largest", "/alarm/detection_delay_s/max", "s"},
    {.label = "kidnaps not noticed", .pointer = "/alarm/undetected", .is_count = true},
    {"false alarms per hour", "/alarm/false_per_h"},
    {"Brier score of the stated probability", "/calibration/brier"},
}};

/// What localizers state themselves, for runs without true poses.
constexpr std::array<MetricLine, 10> kStatedLines{{
    {"scans answered", "/stated/answered_share", "%", 100.0},
    {"Stated probability"},
    {"mean", "/stated/probability_mean"},
    {"at least 0.99 in", "/stated/sure_share", "%", 100.0},
    {"Alarm"},
    {.label = "raised", .pointer = "/stated/alarms", .is_count = true},
    {"share of the scans", "/stated/alarm_share", "%", 100.0},
    {"longest", "/stated/longest_alarm_s", "s"},
    {"Output from scan to scan"},
    {"as odometry moves it, to 0.2 m and 0.2 rad", "/stated/steady_share", "%", 100.0},
}};

std::string table(const std::string& head, const std::string& body) {
  return fmt::format(
      "<div class=\"wide\"><table><thead><tr>{}</tr></thead><tbody>{}</tbody></table></div>\n",
      head, body);
}

std::string cell(const std::string& text) { return "<td>" + text + "</td>"; }

std::string heading(const std::string& text) { return "<th>" + escape_html(text) + "</th>"; }

std::string localizer_headings(const Json& localizers) {
  std::string head = "<td></td>";
  for (const auto& [name, figures] : localizers.items()) head += heading(name);
  return head;
}

std::string count_at(const Json& figures, const char* pointer) {
  const auto value = figure_at(figures, pointer);
  return value ? fmt::format("{:.0f}", *value) : readable(std::nullopt);
}

std::string metric(const Json& figures, const MetricLine& line) {
  if (line.of[0] != '\0') {
    if (figure_at(figures, line.of).value_or(0.0) == 0.0) return readable(std::nullopt);
    return fmt::format("{} of {}", count_at(figures, line.pointer), count_at(figures, line.of));
  }
  if (line.is_count) return count_at(figures, line.pointer);
  auto value = figure_at(figures, line.pointer);
  if (value) *value *= line.factor;
  return readable(value, line.unit);
}

std::string metric_row(const Json& localizers, const MetricLine& line) {
  if (line.pointer[0] == '\0') {
    return fmt::format("<tr class=\"group\"><th colspan=\"{}\">{}</th></tr>", localizers.size() + 1,
                       line.label);
  }
  std::string row = "<tr>" + cell(line.label);
  for (const auto& [name, figures] : localizers.items()) row += cell(metric(figures, line));
  return row + "</tr>";
}

/// How often localizers answer as another one does.
std::string agreement_rows(const Json& localizers) {
  if (localizers.size() < 2) return "";
  std::string rows = metric_row(localizers, {"Same answer, to 0.5 m and 0.35 rad, as"});
  for (const auto& [other, ignored] : localizers.items()) {
    rows += "<tr>" + cell(escape_html(other));
    for (const auto& [name, figures] : localizers.items()) {
      const Json agreement = figures.value("/stated/agreement"_json_pointer, Json::object());
      auto share = agreement.contains(other) && agreement.at(other).is_number()
                       ? std::optional(100.0 * agreement.at(other).get<double>())
                       : std::nullopt;
      rows += cell(name == other ? "" : readable(share, "%"));
    }
    rows += "</tr>";
  }
  return rows;
}

}  // namespace

std::string metric_table(const RunFolder& run) {
  const Json& localizers = run.summary["localizers"];
  const bool scored = !is_without_truth(run.summary);
  std::string body;
  for (const MetricLine& line : scored ? std::span<const MetricLine>(kMetricLines) : kStatedLines) {
    body += metric_row(localizers, line);
  }
  if (!scored) body += agreement_rows(localizers);
  return table(localizer_headings(localizers), body);
}

std::string event_table(const RunFolder& run) {
  std::string body;
  for (const ReportEvent& event : run.events) {
    if (std::holds_alternative<AlarmEvent>(event.what)) continue;
    const EventNames names = names_of(event.what);
    body += fmt::format("<tr data-time=\"{:.3f}\">", event.stamp_s) +
            cell(readable(event.stamp_s, "s")) + cell(escape_html(names.kind)) +
            cell(escape_html(names.detail)) + cell(escape_html(event.localizer)) +
            cell(event.time_s ? readable(event.time_s, "s") : "") + "</tr>";
  }
  if (body.empty()) return "<p>Nothing happened to the robot.</p>\n";
  return table("<th>time</th><th>what</th><th>more</th><th>localizer</th><th>took</th>", body);
}

std::string timing_tables(const RunFolder& run) {
  const Json& timing = run.timing;
  std::string html = fmt::format("<p>{} of wall-clock time, {} times real time.</p>\n",
                                 readable(figure_at(timing, "/wall_s"), "s"),
                                 readable(figure_at(timing, "/realtime_factor")));
  std::string stages;
  const Json cpu = timing.value("cpu_s", Json::object());
  for (const auto& [stage, cpu_s] : cpu.items()) {
    stages +=
        "<tr>" + cell(escape_html(stage)) + cell(readable(cpu_s.get<double>(), "s")) + "</tr>";
  }
  html += table("<th>stage</th><th>CPU time</th>", stages);
  std::string updates;
  const Json localizers = timing.value("localizers", Json::object());
  for (const auto& [name, figures] : localizers.items()) {
    updates += "<tr>" + cell(escape_html(name));
    for (const char* figure : {"mean", "median", "p99", "max"}) {
      updates += cell(readable(figure_at(figures, std::string("/update_ms/") + figure), "ms"));
    }
    updates += "</tr>";
  }
  return html + table(
                    "<th>CPU time of an update</th><th>mean</th><th>median</th><th>99 % below</th>"
                    "<th>largest</th>",
                    updates);
}

}  // namespace castaway::testbed
