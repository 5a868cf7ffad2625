#include "tools/report/curves_section.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "tools/report/html/html.hpp"
#include "tools/report/html/time_plot.hpp"

namespace castaway::testbed {
namespace {

using Figure = std::optional<double> ReportRow::*;

PlotCurve curve_of(const ReportCurve& source, std::size_t color, Figure figure) {
  PlotCurve curve{source.localizer, color, {{}}};
  for (const ReportRow& row : source.rows) {
    if (row.*figure) {
      curve.pieces.back().emplace_back(row.stamp_s, *(row.*figure));
    } else if (!curve.pieces.back().empty()) {
      curve.pieces.emplace_back();
    }
  }
  return curve;
}

/// `empty` with the curves of one figure of all localizers, the kidnaps marked.
TimePlot plot_of(const RunFolder& run, Figure figure, TimePlot empty) {
  TimePlot plot = std::move(empty);
  double first = 1e300;
  double last = -1e300;
  for (std::size_t i = 0; i < run.curves.size(); ++i) {
    const auto& rows = run.curves[i].rows;
    first = std::min(first, rows.front().stamp_s);
    last = std::max(last, rows.back().stamp_s);
    plot.curves.push_back(curve_of(run.curves[i], i, figure));
  }
  plot.begin_s = std::min(first, last);
  plot.end_s = std::max(last, plot.begin_s + 1e-3);
  for (const ReportEvent& event : run.events) {
    if (event.kind == "kidnap") plot.marks.push_back({event.stamp_s, event.kind});
  }
  return plot;
}

}  // namespace

std::string section(const std::string& title, const std::string& body) {
  return fmt::format("<section><h2>{}</h2>\n{}</section>\n", title, body);
}

std::string legend(const RunFolder& run, bool with_truth) {
  std::string html = "<div class=\"legend\">";
  if (with_truth) {
    html +=
        "<span><svg viewBox=\"0 0 26 10\"><line class=\"truth\" x1=\"1\" x2=\"25\" y1=\"5\" "
        "y2=\"5\"/></svg>truth</span>";
  }
  for (std::size_t i = 0; i < run.curves.size(); ++i) {
    html += fmt::format(
        "<span><svg viewBox=\"0 0 26 10\"><line class=\"c{}\" x1=\"1\" x2=\"25\" "
        "y1=\"5\" y2=\"5\"/></svg>{}</span>",
        i % 6, escape_html(run.curves[i].localizer));
  }
  return html + "</div>\n";
}

std::string curves_section(const RunFolder& run) {
  if (run.curves.empty()) return section("Error over time", "<p>There was no scan.</p>\n");
  const TimePlot position = plot_of(run, &ReportRow::position_error_m,
                                    {.title = "position error over time",
                                     .unit = "m",
                                     .low = 0.01,
                                     .high = 10.0,
                                     .logarithmic = true,
                                     .limit = 0.5});
  const TimePlot yaw = plot_of(run, &ReportRow::yaw_error_rad,
                               {.title = "yaw error over time",
                                .unit = "rad",
                                .low = 0.001,
                                .high = 10.0,
                                .logarithmic = true,
                                .limit = 0.35});
  const TimePlot quality = plot_of(run, &ReportRow::quality, {.title = "quality over time"});
  return section(
             "Position error over time",
             legend(run, false) + render_plot(position) +
                 "<p class=\"soft\">Logarithmic, clipped to 1 cm and 10 m. Dotted: 0.5 m, above "
                 "which an output is wrong.</p>\n") +
         section("Yaw error over time",
                 render_plot(yaw) + "<p class=\"soft\">Logarithmic. Dotted: 0.35 rad.</p>\n") +
         section("Quality over time", render_plot(quality) +
                                          "<p class=\"soft\">How well the scan fits the map at the "
                                          "localizer's pose, from 0 to 1.</p>\n");
}

}  // namespace castaway::testbed
