#include "tools/pages/run/repeat_section.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "tools/base/formats/html.hpp"
#include "tools/pages/html/html_page.hpp"
#include "tools/run/metrics/metric_paths.hpp"
#include "tools/run/metrics/void_run.hpp"
#include "tools/scenario/sections/expect_yaml.hpp"
#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {
namespace {

/// Of a recorded log: its settings name one.
bool is_replay(const YamlNode& settings) { return settings.find("log") != nullptr; }

std::vector<Expectation> expectations_of(const RunFolder& run) {
  if (run.settings.empty()) return {};
  YamlDocument document = YamlDocument::parse(run.settings, "scenario.yaml");
  YamlReader root = document.root();
  std::vector<std::string> localizers;
  for (const auto& [name, figures] : run.summary["localizers"].items()) localizers.push_back(name);
  return read_expectations(root, localizers);
}

std::string expectation_row(const Expectation& expectation, const MetricTable& metrics) {
  const auto found = metrics.find(expectation.metric);
  const std::optional<double> value = found == metrics.end() ? std::nullopt : found->second;
  const bool met = value && holds(expectation.condition, *value);
  const bool alone = expectation.over == SeedRule::kAllSeeds;
  return fmt::format("<tr><td>{}</td><td>{}{}</td><td>{}</td><td>{}</td></tr>\n",
                     escape_html(expectation.metric), escape_html(to_string(expectation.condition)),
                     alone ? "" : " (" + to_string(expectation.over) + " of the seeds)",
                     readable(value),
                     !alone ? "–"
                     : met  ? "met"
                            : "<strong>not met</strong>");
}

}  // namespace

std::string repeat_section(const RunFolder& run) {
  if (run.settings.empty()) return "";
  const bool replay = is_replay(parse_yaml(run.settings, "scenario.yaml"));
  return html_section(
      "Repeat it",
      fmt::format("<p>Made by castaway {}. In the run's folder, this command makes the same run "
                  "again, to the byte:</p>\n<pre>castaway {} scenario.yaml --out again</pre>\n"
                  "<details><summary>Settings: scenario.yaml</summary>\n<pre>{}</pre></details>\n",
                  escape_html(run.summary.value("castaway", "")), replay ? "replay" : "run",
                  escape_html(run.settings)));
}

std::string expectations_section(const RunFolder& run) {
  std::vector<Expectation> expectations = expectations_of(run);
  std::erase_if(expectations, [](const Expectation& expectation) {
    return expectation.metric.starts_with("timing.");
  });
  if (expectations.empty() || void_sentence(run.summary)) return "";
  const MetricTable metrics = metric_table(run.summary);
  std::string rows;
  for (const Expectation& expectation : expectations) rows += expectation_row(expectation, metrics);
  return html_section("Expectations",
                      "<div class=\"wide\"><table><thead><tr><th>figure</th><th>expected</th>"
                      "<th>is</th><th>verdict</th></tr></thead><tbody>\n" +
                          rows + "</tbody></table></div>\n");
}

}  // namespace castaway::testbed
