#include "tools/report/report.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "tools/formats/file.hpp"
#include "tools/report/calibration_section.hpp"
#include "tools/report/html.hpp"
#include "tools/report/map_plot.hpp"
#include "tools/report/report_style.hpp"
#include "tools/report/report_tables.hpp"
#include "tools/report/report_words.hpp"
#include "tools/report/time_plot.hpp"

namespace castaway::testbed {
namespace {

constexpr std::size_t kMaxPictures = 60;  // A page of some 5 MB.

using Figure = std::optional<double> ReportRow::*;

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

bool is_by_time(const ReportPicture& picture) {
  return picture.name.find("-time-") != std::string::npos;
}

/// "t0032.100-kidnap-1-map.png": "32.100 s, kidnap 1, map".
std::string caption(const std::string& name) {
  const std::size_t first = name.find('-');
  const std::size_t last = name.rfind('-');
  const std::size_t digit = name.find_first_of("123456789.");
  if (name[0] != 't' || last <= first || digit >= first) return escape_html(name);
  const std::size_t begin = name[digit] == '.' ? digit - 1 : digit;
  std::string what = name.substr(first + 1, last - first - 1);
  std::replace(what.begin(), what.end(), '-', ' ');
  const std::string view = name.substr(last + 1, name.rfind('.') - last - 1);
  return escape_html(fmt::format("{} s, {}, {}", name.substr(begin, first - begin), what, view));
}

std::string pictures_section(const RunFolder& run) {
  if (run.pictures.empty()) {
    const std::string reason = run.pictures_missing.value_or("none was asked for");
    return section("Pictures",
                   fmt::format("<p>There are no pictures: {}</p>\n", escape_html(reason)));
  }
  std::string html =
      "<p class=\"soft\">On the map: the truth in black, each localizer in its colour, its "
      "particles "
      "in one colour a population. In the room: lidar hits in red.</p>\n<div class=\"pictures\">";
  const bool drop_by_time = run.pictures.size() > kMaxPictures;
  std::size_t shown = 0;
  for (const ReportPicture& picture : run.pictures) {
    if (shown == kMaxPictures || (drop_by_time && is_by_time(picture))) continue;
    ++shown;
    html +=
        fmt::format("<figure><img alt=\"{0}\" src=\"{1}\"><figcaption>{0}</figcaption></figure>\n",
                    caption(picture.name), png_data_uri(picture.png));
  }
  html += "</div>\n";
  if (shown < run.pictures.size()) {
    html += fmt::format("<p class=\"soft\">{} more in the folder snapshots.</p>\n",
                        run.pictures.size() - shown);
  }
  return section("Pictures", html);
}

std::string lead(const RunFolder& run) {
  std::string html = "<div class=\"lead\">\n";
  for (const auto& [name, figures] : run.summary["localizers"].items()) {
    html += fmt::format("<p>{}</p>\n", describe_localizer(run, name));
  }
  return html + fmt::format("</div>\n<p class=\"soft\">{}</p>\n", describe_run(run));
}

std::string calibration_section(const RunFolder& run) {
  const std::string html = calibration_html(run);
  return html.empty() ? "" : section("Stated probability", legend(run, false) + html);
}

std::string timing_section(const RunFolder& run) {
  if (run.timing.is_null()) return "";
  const std::string body = fmt::format(
      "<p class=\"soft\">Measured by a clock: the only part that differs from one repetition to "
      "the "
      "next.</p>\n{}",
      timing_tables(run));
  return fmt::format("<!-- timing: begin -->\n{}<!-- timing: end -->\n", section("Timing", body));
}

}  // namespace

std::string render_report(const RunFolder& run, const std::optional<RosMap>& map) {
  const std::string title = escape_html(run.summary.value("scenario", "run"));
  return fmt::format(
             "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
             "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
             "<title>castaway: {0}</title><style>{1}</style></head><body>\n<h1>{0}</h1>\n",
             title, kReportStyle) +
         lead(run) + section("Figures", metric_table(run)) + curves_section(run) +
         calibration_section(run) +
         section("Path on the map", legend(run, true) + render_map_plot(run, map)) +
         section("Events", event_table(run)) + pictures_section(run) + timing_section(run) +
         "</body></html>\n";
}

void write_report(const std::filesystem::path& run_folder, const std::optional<RosMap>& map) {
  write_file(run_folder / "report.html", render_report(load_run_folder(run_folder), map));
}

}  // namespace castaway::testbed
