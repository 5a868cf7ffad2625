#include "tools/pages/run/calibration_section.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/bytes/json_number.hpp"
#include "tools/base/formats/html.hpp"
#include "tools/pages/html/plot_data.hpp"
#include "tools/pages/run/report_words.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

/// The calibration bins of a localizer; an empty list if it has none.
Json bins_of(const Json& figures) {
  const Json::json_pointer path("/calibration/bins");
  return figures.contains(path) ? figures.at(path) : Json::array();
}

/// The observed share of right outputs at each stated probability, with its confidence interval and
/// the number of scans.
Json observed_series(const std::string& name, const Json& bins) {
  Json series{{"name", name}, {"style", "sized"}};
  for (const char* key : {"x", "y", "low", "high", "weight"}) series[key] = Json::array();
  for (const Json& bin : bins) {
    if (bin.at("scans") == 0) continue;
    series["x"].push_back(bin.at("stated"));
    series["y"].push_back(bin.at("observed"));
    series["low"].push_back(bin.at("interval").at(0));
    series["high"].push_back(bin.at("interval").at(1));
    series["weight"].push_back(bin.at("scans"));
  }
  return series;
}

/// A step series: the share of the localizer's scans in each bin.
Json share_series(const std::string& name, const Json& bins) {
  double all = 0.0;
  for (const Json& bin : bins) all += bin.at("scans").get<double>();
  PlotPoints points;
  if (all > 0.0) {
    for (const Json& bin : bins)
      points.emplace_back(bin.at("from"), bin.at("scans").get<double>() / all);
    points.emplace_back(bins.back().at("to"), points.back().second);
  }
  return point_series(name, "steps", points);
}

/// The reliability diagram, and how often each probability was stated.
std::string reliability_plots(const Json& localizers) {
  Json observed =
      Json::array({point_series("stated = right", "reference", {{0.0, 0.0}, {1.0, 1.0}})});
  Json shares = Json::array();
  for (const auto& [name, figures] : localizers.items()) {
    observed.push_back(observed_series(name, bins_of(figures)));
    shares.push_back(share_series(name, bins_of(figures)));
  }
  const Json stated{{"label", "stated probability"}, {"range", {0, 1}}};
  const Json right{{"label", "share that is right"}, {"range", {0, 1}}};
  const Json share{{"label", "share of the scans"}, {"range", {0, 1}}};
  const Json plots{{{"title", "How often an output is right"},
                    {"x", stated},
                    {"y", right},
                    {"series", observed},
                    {"localizers", true}},
                   {{"title", "How often each probability is stated"},
                    {"x", stated},
                    {"y", share},
                    {"series", shares},
                    {"localizers", true}}};
  return plots_html({{"plots", plots}}, PlotLayout::kPairs);
}

std::string table_row(const Json& localizers, std::size_t index) {
  std::string label;
  std::string cells;
  for (const auto& [name, figures] : localizers.items()) {
    const Json bin = bins_of(figures).at(index);
    label = fmt::format("{:g} to {:g}", bin.at("from").get<double>(), bin.at("to").get<double>());
    const auto scans = integer<std::int64_t>(bin.at("scans"));
    cells += scans == 0
                 ? "<td>–</td>"
                 : fmt::format("<td>{} of {}</td>", integer<std::int64_t>(bin.at("right")), scans);
  }
  return fmt::format("<tr><td>{}</td>{}</tr>", label, cells);
}

/// Table of Brier scores and, for each tenth of the stated probability, the number of right
/// outputs.
std::string counts_table(const Json& localizers) {
  std::string head = "<th>stated</th>";
  std::string brier = "<tr><td>Brier score</td>";
  std::size_t bins = 0;
  for (const auto& [name, figures] : localizers.items()) {
    head += "<th>" + escape_html(name) + "</th>";
    brier += "<td>" + readable(figure_at(figures, "/calibration/brier")) + "</td>";
    bins = bins_of(figures).size();
  }
  std::string body = brier + "</tr>";
  for (std::size_t i = 0; i < bins; ++i) body += table_row(localizers, i);
  return fmt::format(
      "<div class=\"wide\"><table><thead><tr>{}</tr></thead><tbody>{}</tbody></table></div>\n",
      head, body);
}

}  // namespace

std::string calibration_html(const RunFolder& run) {
  const Json& localizers = run.summary["localizers"];
  const bool complete = std::none_of(localizers.begin(), localizers.end(),
                                     [](const Json& figures) { return bins_of(figures).empty(); });
  if (localizers.empty() || !complete) return "";
  return reliability_plots(localizers) +
         "<p class=\"soft\">Of the outputs with nearly the same stated probability, the share that "
         "is right, with its 95 % interval; the larger the dot, the more outputs. Below the dotted "
         "line the localizer is too sure, above "
         "it not sure enough. Brier score: mean square of the difference, 0 is perfect.</p>\n" +
         counts_table(localizers);
}

}  // namespace castaway::testbed
