#include "tools/pages/twin/prediction_page.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/formats/html.hpp"
#include "tools/pages/html/html_page.hpp"
#include "tools/pages/html/plot_data.hpp"
#include "tools/pages/run/experiment_page.hpp"
#include "tools/pages/twin/place_picture.hpp"
#include "tools/twin/prediction/prediction_tables.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> localizers_of(const std::vector<PredictionRow>& rows) {
  std::vector<std::string> names;
  for (const LocalizerAgreement& a : by_localizer(rows)) names.push_back(a.localizer);
  return names;
}

std::vector<std::string> logs_of(const std::vector<PredictionRow>& rows) {
  std::vector<std::string> names;
  for (const PredictionRow& row : rows) {
    if (std::find(names.begin(), names.end(), row.log.log) == names.end()) {
      names.push_back(row.log.log);
    }
  }
  return names;
}

/// A figure of a row; nothing where it is unknown.
using FigureOfRow = std::optional<double> (*)(const EvaluationRow&);

/// Dots of all localizers, one for each log, above the diagonal.
Json against_measured(const std::vector<PredictionRow>& rows, const char* title, const Json& axis,
                      FigureOfRow figure, double diagonal) {
  Json series = Json::array();
  series.push_back(point_series("equal", "reference", {{0.0, 0.0}, {diagonal, diagonal}}));
  for (const std::string& name : localizers_of(rows)) {
    PlotPoints points;
    for (const PredictionRow& row : rows) {
      const auto x = figure(row.log);
      const auto y = figure(row.twin);
      if (row.log.localizer == name && x && y) points.emplace_back(*x, *y);
    }
    series.push_back(point_series(name, "dots", points));
  }
  Json x = axis;
  Json y = axis;
  x["label"] = "log";
  y["label"] = "twin";
  return {{"title", title},         {"x", x}, {"y", y}, {"series", series}, {"localizers", true},
          {"nothing", "No trials."}};
}

std::string plots_section(const std::vector<PredictionRow>& rows) {
  constexpr double kMostTracking = 0.2;  // [m] Localizers that track.
  const Json success = against_measured(
      rows, "Success", {{"range", {0, 1}}},
      [](const EvaluationRow& row) { return std::optional(success_of(row)); }, 1.0);
  const Json tracking = against_measured(
      rows, "Tracking error up to 0.2 m [m]", {{"range", {0, kMostTracking}}},
      [](const EvaluationRow& row) { return row.tracking_no_alarm_m; }, kMostTracking);
  return html_section("Twin against log, a dot for each log",
                      plots_html({{"plots", {success, tracking}}}, PlotLayout::kPairs));
}

std::string place_html(const DifferingPlace& place) {
  std::string localizers;
  for (const std::string& name : place.localizers) {
    localizers += (localizers.empty() ? "" : ", ") + name;
  }
  return fmt::format(
      "<figure>{}<figcaption>{}: {} {} at ({:.1f}, {:.1f}) m. Log and twin differ for {}."
      "</figcaption></figure>\n",
      place.picture, escape_html(place.log), place.kidnap ? "kidnap to" : "start", place.index + 1,
      place.T_map_base.x, place.T_map_base.y, escape_html(localizers));
}

std::string places_section(const std::vector<DifferingPlace>& places) {
  if (places.empty()) return "";
  std::string html = fmt::format(
      "<p class=\"legend\"><span><span style=\"color:{}\">&#9632;</span> scan of the log</span>"
      "<span><span style=\"color:{}\">&#9632;</span> of the twin</span></p>\n"
      "<div class=\"pictures\">\n",
      kLogColor, kTwinColor);
  for (const DifferingPlace& place : places) html += place_html(place);
  return html_section("Where log and twin differ most", html + "</div>\n");
}

/// A name as part of a link.
std::string in_link(const std::string& name) {
  std::string link;
  for (const char c : name) {
    const bool reserved = c == '%' || c == '#' || c == '?';
    link += reserved ? fmt::format("%{:02X}", static_cast<int>(c)) : std::string(1, c);
  }
  return escape_html(link);
}

std::string twins_section(const std::vector<PredictionRow>& rows) {
  std::string items;
  for (const std::string& log : logs_of(rows)) {
    items += fmt::format("<li><a href=\"twins/{}/calibration.html\">{}</a></li>\n", in_link(log),
                         escape_html(log));
  }
  return html_section("The twins", "<ul>\n" + items + "</ul>\n");
}

}  // namespace

std::string render_prediction(const std::vector<PredictionRow>& rows,
                              const std::vector<DifferingPlace>& places) {
  const std::string title = "Twins against logs";
  std::string body = fmt::format(
      "<h1>{}</h1>\n<p class=\"soft\">Starts and kidnaps of recorded logs, and the same in the "
      "logs' twins. Tracking: mean error of the scans without the alarm. Wrong: share of scans "
      "that "
      "are wrong without the alarm.</p>\n<p>{}.</p>\n",
      title, escape_html(agreement_sentence(rows)));
  body += plots_notice() + html_section("By localizer", html_table(agreement_table(rows)));
  if (plots_bundle()) body += plots_section(rows);
  body += html_section("By log", html_table(results_table(rows))) + places_section(places) +
          twins_section(rows);
  return html_page(
      {.title = title, .body = body, .body_class = "figures", .bundle = plots_bundle()});
}

}  // namespace castaway::testbed
