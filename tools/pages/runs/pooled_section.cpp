#include "tools/pages/runs/pooled_section.hpp"

#include <map>

#include <fmt/format.h>

#include "tools/base/bytes/json_number.hpp"
#include "tools/base/formats/html.hpp"
#include "tools/batch/compare/aggregate.hpp"
#include "tools/outputs/pictures/localizer_styles.hpp"
#include "tools/pages/html/line_chart.hpp"
#include "tools/pages/runs/verdict_words.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kTrackingError = "tracking_error_m.mean";
constexpr const char* kWrongShare = "wrong_lock_share";

/// What the table shows: a value with its interval below it.
struct PooledValue {
  std::string unit;
  double factor = 1.0;

  [[nodiscard]] std::string text(const Json& value) const {
    if (!value.is_number()) return readable(std::nullopt);
    return readable(factor * value.get<double>(), unit);
  }
  [[nodiscard]] std::string below(const Json& ends) const {
    if (!ends.is_array()) return "";
    return fmt::format("<br><small>{} to {}</small>", readable(factor * ends.at(0).get<double>()),
                       text(ends.at(1)));
  }
};

std::string pooled_cell(const std::string& head, const std::string& html) {
  return fmt::format("<td data-head=\"{}\"><span>{}</span></td>", escape_html(head), html);
}

std::string recovered_text(const Json& recovery) {
  const auto events = integer<int>(recovery.at("events"));
  if (events == 0) return "no kidnap";
  return fmt::format("{} of {}{}", integer<int>(recovery.at("recovered")), events,
                     PooledValue{"%", 100.0}.below(recovery.at("success_interval")));
}

/// The mean of a metric over the runs.
std::string mean_text(const Json& figures, const std::string& metric, const PooledValue& value) {
  if (!figures.contains(metric)) return readable(std::nullopt);
  const Json& figure = figures.at(metric);
  return value.text(figure.at("mean")) + value.below(figure.at("mean_interval"));
}

/// Means over the runs of the metrics that the table shows.
Json means_of(const RunSet& set, const std::vector<Json>& summaries) {
  std::vector<MetricTable> tables;
  for (const Json& summary : summaries) {
    const MetricTable all = metric_table(summary);
    MetricTable& shown = tables.emplace_back();
    for (const std::string& name : set.localizers) {
      for (const char* metric : {kTrackingError, kWrongShare}) {
        const auto found = all.find(fmt::format("{}.{}", name, metric));
        if (found != all.end()) shown.insert(*found);
      }
    }
  }
  return aggregate_figures(tables);
}

std::string pooled_row(const std::string& name, std::size_t style, const Json& recovery,
                       const Json& means, const std::string& verdict) {
  const Json& time = recovery.at("time_s");
  const PooledValue seconds{"s"};
  return "<tr>" + pooled_cell("", line_sample(style) + escape_html(name)) +
         pooled_cell("recovered", recovered_text(recovery)) +
         pooled_cell("time to recovery",
                     seconds.text(time.at("mean")) + seconds.below(time.at("mean_interval"))) +
         pooled_cell("slowest", seconds.text(time.at("max"))) +
         pooled_cell("wrong, and says right",
                     mean_text(means, name + "." + kWrongShare, {"%", 100.0})) +
         pooled_cell("error while tracking", mean_text(means, name + "." + kTrackingError, {"m"})) +
         (verdict.empty() ? "" : pooled_cell("verdict", escape_html(verdict))) + "</tr>\n";
}

}  // namespace

std::string pooled_table(const RunSet& set) {
  if (set.localizers.empty()) return "<p>There is no localizer.</p>\n";
  const std::vector<Json> summaries = set.scored_summaries();
  const Json pooled = pooled_recoveries(summaries);
  const Json means = means_of(set, summaries);
  const std::map<std::string, std::string> verdicts = recovery_verdicts(set);
  const std::vector<std::size_t> styles = localizer_styles(set.localizers);
  std::string rows;
  for (std::size_t i = 0; i < set.localizers.size(); ++i) {
    const std::string& name = set.localizers[i];
    if (!pooled.contains(name)) continue;
    const auto verdict = verdicts.find(name);
    rows += pooled_row(name, styles[i], pooled.at(name).at("recovery"), means,
                       verdict == verdicts.end() ? "" : verdict->second);
  }
  return fmt::format(
      "<div class=\"wide\"><table class=\"stack pooled\"><thead><tr><th>localizer</th>"
      "<th>recovered</th><th>time to recovery, mean</th><th>slowest</th>"
      "<th>wrong, and says right</th><th>error while tracking, mean</th>{}</tr></thead>"
      "<tbody>\n{}</tbody></table></div>\n",
      verdicts.empty() ? "" : "<th>verdict</th>", rows);
}

}  // namespace castaway::testbed
