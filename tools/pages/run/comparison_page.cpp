#include "tools/pages/run/comparison_page.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

#include <fmt/format.h>

#include "tools/base/formats/html.hpp"
#include "tools/outputs/pictures/localizer_styles.hpp"
#include "tools/pages/html/html_page.hpp"
#include "tools/pages/run/experiment_page.hpp"

namespace castaway::testbed {
namespace {

constexpr double kChangeWidth = 900.0;
constexpr double kRow = 24.0;
constexpr double kChangeLeft = 330.0;
constexpr double kChangeRight = 34.0;
constexpr double kChangeTop = 10.0;
constexpr double kMostChange = 100.0;  // [%] Larger differences are clipped at the border.

std::string verdict_of(const MetricComparison& row) {
  if (row.clock) return "clock, not judged";
  if (row.pairs_needed) return fmt::format("too few pairs: takes {}", *row.pairs_needed);
  const int verdict = row.verdict();
  if (verdict == 0) return "no difference seen";
  return verdict > 0 ? "better" : "worse";
}

double x_of(double percent) {
  const double clipped = std::clamp(percent, -kMostChange, kMostChange);
  return kChangeLeft + (clipped + kMostChange) / (2.0 * kMostChange) *
                           (kChangeWidth - kChangeLeft - kChangeRight);
}

using Styles = std::map<std::string, std::size_t>;  // By localizer.

/// The localizer of a metric, if it is one that all localizers have.
std::string localizer_of(const std::string& metric) {
  constexpr std::string_view kOfEach = ".availability";
  return metric.ends_with(kOfEach) ? metric.substr(0, metric.size() - kOfEach.size()) : "";
}

Styles styles_of(const Comparison& comparison) {
  std::vector<std::string> names;
  for (const MetricComparison& row : comparison.metrics) {
    const std::string name = localizer_of(row.metric);
    if (!name.empty()) names.push_back(name);
  }
  const std::vector<std::size_t> styles = localizer_styles(names);
  Styles by_name;
  for (std::size_t i = 0; i < names.size(); ++i) by_name[names[i]] = styles[i];
  return by_name;
}

/// The name of a metric, and a square in its localizer's colour.
std::string metric_text(const std::string& metric, const Styles& styles, double y) {
  std::string square;
  for (const auto& [name, style] : styles) {
    if (!metric.starts_with(name + ".")) continue;
    square = fmt::format(
        "<rect style=\"fill:var(--c{})\" x=\"{:.0f}\" y=\"{:.1f}\" width=\"9\" height=\"9\"/>",
        style, kChangeLeft - 16, y - 4.5);
  }
  return fmt::format("{}<text x=\"{:.0f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>", square,
                     kChangeLeft - 22, y + 4, escape_html(metric));
}

/// Draws the difference and its interval in percent of the baseline.
std::string bar(const MetricComparison& row, const Styles& styles, double y) {
  const double scale = 100.0 / std::abs(row.baseline);
  const int verdict = row.verdict();
  const char* color = verdict == 0 ? "even" : (verdict > 0 ? "better" : "worse");
  std::string svg = metric_text(row.metric, styles, y);
  if (row.interval) {
    svg += fmt::format(
        "<line class=\"bar {}\" stroke-width=\"4\" x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{:.1f}\" "
        "y2=\"{:.1f}\"/>",
        color, x_of(scale * row.interval->low), x_of(scale * row.interval->high), y, y);
  }
  return svg + fmt::format(
                   "<circle class=\"bar {}\" stroke-width=\"3\" cx=\"{:.1f}\" "
                   "cy=\"{:.1f}\" r=\"4\"/>",
                   color, x_of(scale * row.difference), y);
}

/// Draws the differences of all metrics whose baseline is not zero.
std::string differences(const Comparison& comparison) {
  const Styles styles = styles_of(comparison);
  std::string bars;
  double y = kChangeTop + 0.5 * kRow;
  for (const MetricComparison& row : comparison.metrics) {
    if (row.baseline == 0.0) continue;
    bars += bar(row, styles, y);
    y += kRow;
  }
  const double bottom = y - 0.5 * kRow;
  std::string grid;
  for (const double percent : {-100.0, -50.0, 0.0, 50.0, 100.0}) {
    grid += fmt::format(
        "<line class=\"grid\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:.0f}\" y2=\"{2:.0f}\"/>"
        "<text x=\"{0:.1f}\" y=\"{3:.0f}\" text-anchor=\"middle\">{4:+.0f} %</text>",
        x_of(percent), kChangeTop, bottom, bottom + 16, percent);
  }
  return fmt::format(
      "<svg class=\"plot bars\" viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" "
      "aria-label=\"differences in "
      "percent of the baseline\">{}{}</svg>\n",
      kChangeWidth, bottom + 24, grid, bars);
}

}  // namespace

TextTable comparison_table(const Comparison& comparison) {
  TextTable table;
  table.head = {"", "pairs", "baseline", "other", "difference", "95 %", "p", ""};
  for (const MetricComparison& row : comparison.metrics) {
    const std::string interval =
        row.interval ? fmt::format("[{:.4g}, {:.4g}]", row.interval->low, row.interval->high) : "-";
    table.rows.push_back(
        {row.metric, std::to_string(row.pairs), fmt::format("{:.4g}", row.baseline),
         fmt::format("{:.4g}", row.other), fmt::format("{:+.4g}", row.difference), interval,
         row.p_value ? fmt::format("{:.3f}", *row.p_value) : "-", verdict_of(row)});
  }
  return table;
}

std::string render_comparison(const std::vector<Comparison>& comparisons) {
  std::string body = "<h1>Comparison</h1>\n";
  for (const Comparison& comparison : comparisons) {
    body += fmt::format(
        "<section><h2>{} against {}</h2>\n<p class=\"soft\">{} pairs of the same scenario and "
        "seed, "
        "{} runs without a counterpart left out. Intervals: bootstrap over the pairs, 95 % each. "
        "p: sign-flip test of the mean difference, corrected for the number of metrics (Holm): "
        "below 0.05 it is called better or worse. Too few pairs: even if all differed in the same "
        "direction, p would be no less than 0.05.</p>\n",
        escape_html(comparison.other.string()), escape_html(comparison.baseline.string()),
        comparison.pairs, comparison.unpaired);
    body += html_table(comparison_table(comparison));
    body +=
        "<p class=\"soft\">Differences in percent of the baseline, with their intervals; filled "
        "dots: better (green) or worse (red), hollow ones: neither.</p>\n";
    body += differences(comparison) + "</section>\n";
  }
  return html_page({.title = "Comparison", .body = body, .body_class = "figures"});
}

}  // namespace castaway::testbed
