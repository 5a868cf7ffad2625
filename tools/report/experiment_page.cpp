#include "tools/report/experiment_page.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "tools/formats/json_number.hpp"
#include "tools/metrics/discrimination.hpp"
#include "tools/report/curves_section.hpp"
#include "tools/report/html/html.hpp"
#include "tools/report/html/report_style.hpp"
#include "tools/report/html/time_plot.hpp"
#include "tools/report/html/xy_plot.hpp"

namespace castaway::testbed {
namespace {

using Points = std::vector<std::pair<double, double>>;
using ErrorOf = double (*)(const ErrorRow&);

/// Plots beside each other where there is room for two.
constexpr const char* kPlots =
    "<div class=\"pictures\" "
    "style=\"grid-template-columns:repeat(auto-fit,minmax(min(420px,100%),1fr))\">";

std::string legend(const std::vector<std::string>& names) {
  std::string html = "<div class=\"legend\">";
  for (std::size_t i = 0; i < names.size(); ++i) {
    html += fmt::format(
        "<span><svg viewBox=\"0 0 26 10\"><line class=\"c{}\" x1=\"1\" x2=\"25\" y1=\"5\" "
        "y2=\"5\"/></svg>{}</span>",
        i % 6, escape_html(names[i]));
  }
  return html + "</div>\n";
}

std::vector<std::string> names_of(const ExperimentPage& page) {
  std::vector<std::string> names;
  for (const PooledRows& rows : page.rows) names.push_back(rows.localizer);
  return names;
}

/// One figure of all localizers in the example run.
TimePlot over_time(const ExperimentPage& page, ErrorOf figure, TimePlot plot) {
  plot.begin_s = 1e300;
  plot.end_s = 0.0;
  for (std::size_t i = 0; i < page.rows.size(); ++i) {
    const std::vector<ErrorRow>& rows = page.rows[i].runs.at(page.example);
    PlotCurve curve{page.rows[i].localizer, i, {{}}};
    for (const ErrorRow& row : rows) {
      if (row.error_m) curve.pieces.back().emplace_back(row.stamp_s, figure(row));
    }
    if (!rows.empty()) {
      plot.begin_s = std::min(plot.begin_s, rows.front().stamp_s);
      plot.end_s = std::max(plot.end_s, rows.back().stamp_s);
    }
    plot.curves.push_back(std::move(curve));
  }
  plot.begin_s = std::min(plot.begin_s, plot.end_s);
  plot.end_s = std::max(plot.end_s, plot.begin_s + 1e-3);
  return plot;
}

double most(const ExperimentPage& page, ErrorOf figure) {
  double largest = 1.0;
  for (const PooledRows& rows : page.rows) {
    for (const ErrorRow& row : rows.runs.at(page.example)) {
      largest = std::max(largest, figure(row));
    }
  }
  return largest;
}

std::string curves(const ExperimentPage& page) {
  const ErrorOf error = [](const ErrorRow& row) { return *row.error_m; };
  const ErrorOf quality = [](const ErrorRow& row) { return row.quality; };
  const ErrorOf sigma = [](const ErrorRow& row) { return row.sigma_m; };
  const ErrorOf populations = [](const ErrorRow& row) { return row.populations; };
  const std::string key = legend(names_of(page));
  const auto logarithmic = [](const char* title) {
    return TimePlot{.title = title, .unit = "m", .low = 0.001, .high = 10.0, .logarithmic = true};
  };
  const TimePlot hypotheses{.title = "hypotheses over time",
                            .high = std::max(4.0, std::ceil(most(page, populations) / 4.0) * 4.0)};
  return section("Error over time",
                 key + render_plot(over_time(page, error, logarithmic("error over time")))) +
         section("Quality over time",
                 render_plot(over_time(page, quality, {.title = "quality over time"}))) +
         section("Uncertainty over time",
                 render_plot(over_time(page, sigma, logarithmic("uncertainty over time"))) +
                     "<p class=\"soft\">Root of the mean variance of x and y.</p>\n") +
         section("Hypotheses over time", render_plot(over_time(page, populations, hypotheses)));
}

Points error_against(const PooledRows& rows, ErrorOf figure) {
  Points points;
  for (const std::vector<ErrorRow>& run : rows.runs) {
    for (const ErrorRow& row : run) {
      if (row.error_m) points.emplace_back(*row.error_m, figure(row));
    }
  }
  return points;
}

std::string scatter(const ExperimentPage& page, ErrorOf figure, PlotAxis y) {
  XyPlot plot;
  plot.title = y.label + " against error";
  plot.x = {"error, m", 0.001, 100.0, true};
  plot.y = std::move(y);
  for (std::size_t i = 0; i < page.rows.size(); ++i) {
    plot.series.push_back({page.rows[i].localizer, i, false, error_against(page.rows[i], figure)});
  }
  return render_xy_plot(plot);
}

std::string roc(const PooledRows& rows) {
  std::vector<ScoredOutput> scores[3];
  for (const std::vector<ErrorRow>& run : rows.runs) {
    for (const ErrorRow& row : run) {
      if (!row.error_m) continue;
      const bool right = *row.error_m < kWrongFrom;
      scores[0].push_back({row.quality, right});
      scores[1].push_back({row.probability, right});
      scores[2].push_back({-row.sigma_m, right});
    }
  }
  XyPlot plot{"ROC curves", {"wrong outputs passed, share"}, {"right outputs passed, share"}, {}};
  plot.nothing = scores[0].empty()         ? "no outputs"
                 : scores[0].front().right ? "no output is wrong"
                                           : "no output is right";
  const char* const names[3] = {"quality", "stated probability", "covariance"};
  for (std::size_t i = 0; i < 3; ++i) {
    plot.series.push_back({names[i], i, true, every_few(roc_curve(std::move(scores[i])), 400)});
  }
  return fmt::format("<figure><figcaption>{}</figcaption>{}</figure>\n",
                     escape_html(rows.localizer), render_xy_plot(plot));
}

std::string right_from_wrong(const ExperimentPage& page) {
  const ErrorOf quality = [](const ErrorRow& row) { return row.quality; };
  const ErrorOf sigma = [](const ErrorRow& row) { return row.sigma_m; };
  std::string html = section(
      "Quality and uncertainty against error, all runs",
      legend(names_of(page)) + kPlots + scatter(page, quality, {"quality", 0.0, 1.0, false}) +
          scatter(page, sigma, {"uncertainty, m", 0.001, 10.0, true}) + "</div>\n");
  std::string curves = legend({"quality", "stated probability", "covariance"}) +
                       "<p class=\"soft\">Right: error below 0.5 m.</p>\n" + kPlots;
  for (const PooledRows& rows : page.rows) curves += roc(rows);
  return html + section("Who tells right from wrong: ROC curves", curves + "</div>\n");
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

std::string html_page(const std::string& title, const std::string& body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
      "<title>castaway: {0}</title><style>{1}</style></head>"
      "<body class=\"figures\">\n<h1>{0}</h1>\n{2}</body>"
      "</html>\n",
      escape_html(title), kReportStyle, body);
}

std::string render_experiment(const ExperimentPage& page) {
  const auto& runs = page.summary.at("runs");
  std::string body = fmt::format("<p class=\"soft\">{} runs. <code>{}</code></p>\n", runs.size(),
                                 escape_html(page.command));
  body += section("The paper and this run", html_table(page.table));
  if (!page.rows.empty()) {
    body += fmt::format("<p class=\"soft\">The curves over time show {}, seed {}.</p>\n",
                        escape_html(runs.at(page.example).at("part").get<std::string>()),
                        whole<std::uint64_t>(runs.at(page.example).at("seed")));
    body += curves(page);
    if (page.experiment.number == 2) body += right_from_wrong(page);
  }
  const std::string title =
      fmt::format("Experiment {}, {}", page.experiment.number, page.experiment.title);
  return html_page(title, body);
}

}  // namespace castaway::testbed
