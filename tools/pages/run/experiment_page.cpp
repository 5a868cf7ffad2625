#include "tools/pages/run/experiment_page.hpp"

#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/bytes/json_number.hpp"
#include "tools/base/formats/html.hpp"
#include "tools/outputs/pictures/localizer_styles.hpp"
#include "tools/pages/html/html_page.hpp"
#include "tools/pages/html/plot_data.hpp"
#include "tools/run/metrics/discrimination.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;
using FigureOf = double (*)(const ErrorRow&);

constexpr std::size_t kMostDots = 2500;  // Per localizer.
constexpr std::size_t kMostOfRoc = 400;

double error_of(const ErrorRow& row) { return *row.error_m; }
double quality_of(const ErrorRow& row) { return row.quality; }
double sigma_of(const ErrorRow& row) { return row.sigma_m; }
double populations_of(const ErrorRow& row) { return row.populations; }

std::vector<double> stamps_of(const std::vector<ErrorRow>& rows) {
  std::vector<double> stamps;
  for (const ErrorRow& row : rows) stamps.push_back(row.stamp_s);
  return stamps;
}

/// Plot of one value of all localizers over the example run, where they have an output.
Json over_time(const ExperimentPage& page, const char* title, const char* unit, Json y_axis,
               FigureOf figure, const Json& times) {
  Json series = Json::array();
  for (const PooledRows& rows : page.rows) {
    const std::vector<ErrorRow>& run = rows.runs.at(page.example);
    PlotColumn values;
    for (const ErrorRow& row : run) {
      values.push_back(row.error_m ? std::optional(figure(row)) : std::nullopt);
    }
    series.push_back(time_series(rows.localizer, stamps_of(run), values, times));
  }
  return {{"title", title},
          {"unit", unit},
          {"y", std::move(y_axis)},
          {"series", std::move(series)},
          {"localizers", true}};
}

std::string curves(const ExperimentPage& page) {
  const Json times = time_axis(stamps_of(page.rows.front().runs.at(page.example)));
  const Json metres{{"log", {0.001, 100}}};
  const Json share{{"range", {0, 1}}};
  const Json plots{over_time(page, "Position error", "m", metres, error_of, times),
                   over_time(page, "Quality: how well the scan fits the map", "0 to 1", share,
                             quality_of, times),
                   over_time(page, "Uncertainty: root of the mean variance of x and y", "m", metres,
                             sigma_of, times),
                   over_time(page, "Hypotheses", "count", {{"least", 4}}, populations_of, times)};
  const Json& run = page.summary.at("runs").at(page.example);
  return html_section(
      "Curves over time",
      fmt::format(
          "<p class=\"soft\">Of one run: {}, seed {}. Drag to zoom, double-click for all of the "
          "run.</p>\n",
          escape_html(run.at("part").get<std::string>()), integer<std::uint64_t>(run.at("seed"))) +
          plots_html({{"x", times}, {"plots", plots}}, PlotLayout::kWide));
}

/// Scatter plot of one value against the error, over all runs.
Json scatter(const ExperimentPage& page, const char* title, Json y_axis, FigureOf figure) {
  Json series = Json::array();
  for (const PooledRows& rows : page.rows) {
    PlotPoints points;
    for (const std::vector<ErrorRow>& run : rows.runs) {
      for (const ErrorRow& row : run) {
        if (row.error_m) points.emplace_back(*row.error_m, figure(row));
      }
    }
    series.push_back(point_series(rows.localizer, "dots", every_few(points, kMostDots)));
  }
  return {{"title", title},         {"x", {{"label", "position error [m]"}, {"log", {0.001, 100}}}},
          {"y", std::move(y_axis)}, {"series", std::move(series)},
          {"localizers", true},     {"nothing", "No outputs."}};
}

/// ROC curves of one localizer for its three scores, in its colour.
Json roc(const PooledRows& rows, std::size_t style) {
  std::array<std::vector<ScoredOutput>, 3> scores;
  for (const std::vector<ErrorRow>& run : rows.runs) {
    for (const ErrorRow& row : run) {
      if (!row.error_m) continue;
      const bool right = *row.error_m < kWrongFrom;
      scores[0].push_back({row.quality, right});
      scores[1].push_back({row.probability, right});
      scores[2].push_back({-row.sigma_m, right});
    }
  }
  const char* const nothing = scores[0].empty()         ? "No outputs."
                              : scores[0].front().right ? "No output is wrong."
                                                        : "No output is right.";
  constexpr std::array<const char*, 3> kNames{"quality", "stated probability", "covariance"};
  Json series = Json::array();
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    Json curve =
        point_series(kNames[i], "", every_few(roc_curve(std::move(scores[i])), kMostOfRoc));
    curve["color"] = style;
    curve["dash"] = i;
    series.push_back(std::move(curve));
  }
  return {{"title", rows.localizer},
          {"x", {{"label", "wrong outputs passed, share"}, {"range", {0, 1}}}},
          {"y", {{"label", "right outputs passed, share"}, {"range", {0, 1}}}},
          {"series", std::move(series)},
          {"nothing", nothing}};
}

std::string right_from_wrong(const ExperimentPage& page) {
  const Json share{{"label", "quality, 0 to 1"}, {"range", {0, 1}}};
  const Json metres{{"label", "uncertainty [m]"}, {"log", {0.001, 10}}};
  const Json dots{scatter(page, "Quality against error", share, quality_of),
                  scatter(page, "Uncertainty against error", metres, sigma_of)};
  Json rocs = Json::array();
  std::vector<std::string> names;
  for (const PooledRows& rows : page.rows) names.push_back(rows.localizer);
  const std::vector<std::size_t> styles = localizer_styles(names);
  for (std::size_t i = 0; i < page.rows.size(); ++i) rocs.push_back(roc(page.rows[i], styles[i]));
  return html_section("Quality and uncertainty against error, all runs",
                      plots_html({{"plots", dots}}, PlotLayout::kPairs)) +
         html_section("ROC curves: which figure tells right outputs from wrong ones",
                      "<p class=\"soft\">Right: error below 0.5 m.</p>\n" +
                          plots_html({{"plots", rocs}}, PlotLayout::kPairs));
}

}  // namespace

std::size_t example_run(const std::vector<ExperimentOutcome>& outcomes) {
  std::size_t example = 0;
  double longest = 0.0;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    for (const auto& [name, figures] : outcomes[i].summary.at("localizers").items()) {
      const auto& time = figures.at("/recovery/time_s/max"_json_pointer);
      if (!time.is_number() || time.get<double>() <= longest) continue;
      longest = time.get<double>();
      example = i;
    }
  }
  return example;
}

std::string html_table(const TextTable& table) {
  std::string html = "<div class=\"wide\"><table class=\"stack\"><thead><tr>";
  for (const std::string& cell : table.head) html += "<th>" + escape_html(cell) + "</th>";
  html += "</tr></thead><tbody>";
  for (const auto& row : table.rows) {
    html += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      const bool named = i < table.head.size() && !table.head[i].empty();
      html += named ? fmt::format("<td data-head=\"{}\">", escape_html(table.head[i])) : "<td>";
      html += escape_html(row[i]) + "</td>";
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string render_experiment(const ExperimentPage& page) {
  const std::string title =
      fmt::format("Experiment {}, {}", page.experiment.number, page.experiment.title);
  std::string body =
      fmt::format("<h1>{}</h1>\n<p class=\"soft\">{} runs. <code>{}</code></p>\n",
                  escape_html(title), page.summary.at("runs").size(), escape_html(page.command));
  body += plots_notice() + html_section("The paper and this run", html_table(page.table));
  if (!page.rows.empty() && plots_bundle()) {
    body += curves(page);
    if (page.experiment.number == 2) body += right_from_wrong(page);
  }
  return html_page(
      {.title = title, .body = body, .body_class = "figures", .bundle = plots_bundle()});
}

}  // namespace castaway::testbed
