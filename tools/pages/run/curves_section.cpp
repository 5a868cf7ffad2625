#include "tools/pages/run/curves_section.hpp"

#include <numbers>

#include <fmt/format.h>

#include "tools/base/formats/html.hpp"
#include "tools/pages/html/html_page.hpp"
#include "tools/pages/html/plot_data.hpp"
#include "tools/run/metrics/recovery.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;
using Figure = std::optional<double> ReportRow::*;

constexpr double kDegrees = 180.0 / std::numbers::pi;

std::vector<double> stamps_of(const ReportCurve& curve) {
  std::vector<double> stamps;
  for (const ReportRow& row : curve.rows) stamps.push_back(row.stamp_s);
  return stamps;
}

/// Series of one value of all localizers, multiplied by `unit`.
Json series_of(const RunFolder& run, Figure figure, double unit, const Json& times) {
  Json series = Json::array();
  for (const ReportCurve& curve : run.curves) {
    PlotColumn values;
    for (const ReportRow& row : curve.rows) {
      values.push_back(row.*figure ? std::optional(unit * *(row.*figure)) : std::nullopt);
    }
    series.push_back(time_series(curve.localizer, stamps_of(curve), values, times));
  }
  return series;
}

Json kidnap_times(const RunFolder& run) {
  Json times = Json::array();
  for (const ReportEvent& event : run.events) {
    if (std::holds_alternative<KidnapEvent>(event.what)) times.push_back(event.stamp_s);
  }
  return times;
}

Json curves_json(const RunFolder& run) {
  const RecoveryConfig right;
  const Json times = time_axis(stamps_of(run.curves.front()));
  const Json kidnaps = kidnap_times(run);
  const Json position = series_of(run, &ReportRow::position_error_m, 1.0, times);
  const Json yaw = series_of(run, &ReportRow::yaw_error_rad, kDegrees, times);
  const Json quality = series_of(run, &ReportRow::quality, 1.0, times);
  const Json plots{{{"title", "Position error"},
                    {"unit", "m"},
                    {"y", {{"log", {0.001, 100}}}},
                    {"series", position},
                    {"limit", right.position_m},
                    {"marks", kidnaps},
                    {"localizers", true}},
                   {{"title", "Yaw error"},
                    {"unit", "°"},
                    {"y", {{"log", {0.01, 180}}}},
                    {"series", yaw},
                    {"limit", kDegrees * right.yaw_rad},
                    {"marks", kidnaps},
                    {"localizers", true}},
                   {{"title", "Quality: how well the scan fits the map"},
                    {"unit", "0 to 1"},
                    {"y", {{"range", {0, 1}}}},
                    {"series", quality},
                    {"marks", kidnaps},
                    {"localizers", true}}};
  return {{"x", times}, {"plots", plots}};
}

}  // namespace

std::string curves_section(const RunFolder& run) {
  if (run.curves.empty()) return html_section("Curves", "<p>There was no scan.</p>\n");
  if (!plots_bundle()) return "";
  return html_section("Curves",
                      "<p class=\"soft\">Dotted across: 0.5 m and 0.35 rad (20°), above which an "
                      "output is wrong. Dashed down: kidnaps. Drag to zoom, double-click for all "
                      "of the run.</p>\n" +
                          plots_html(curves_json(run), PlotLayout::kWide));
}

}  // namespace castaway::testbed
