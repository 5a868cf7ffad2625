#include "tools/pages/html/line_chart.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "tools/base/formats/html.hpp"

namespace castaway::testbed {
namespace {

constexpr double kWidth = 720.0;
constexpr double kHeight = 320.0;
constexpr double kLeft = 64.0;
constexpr double kRight = 16.0;
constexpr double kTop = 12.0;
constexpr double kBottom = 52.0;

/// Pixels of the chart's values.
struct ChartFrame {
  double most_x;
  double most_y;

  [[nodiscard]] double x(double value) const {
    return kLeft + std::clamp(value / most_x, 0.0, 1.0) * (kWidth - kLeft - kRight);
  }
  [[nodiscard]] double y(double value) const {
    return kHeight - kBottom - std::clamp(value / most_y, 0.0, 1.0) * (kHeight - kTop - kBottom);
  }
};

std::string vertical_grid(const ChartFrame& frame) {
  std::string svg;
  for (const double tick : axis_ticks(frame.most_x)) {
    svg += fmt::format(
        "<line class=\"grid\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:.1f}\" y2=\"{2:.1f}\"/>"
        "<text x=\"{0:.1f}\" y=\"{3:.1f}\" text-anchor=\"middle\">{4:g}</text>",
        frame.x(tick), kTop, kHeight - kBottom, kHeight - kBottom + 18, tick);
  }
  return svg;
}

std::string horizontal_grid(const ChartFrame& frame) {
  std::string svg;
  for (const double tick : axis_ticks(frame.most_y)) {
    svg += fmt::format(
        "<line class=\"grid\" x1=\"{1:.1f}\" x2=\"{2:.1f}\" y1=\"{0:.1f}\" y2=\"{0:.1f}\"/>"
        "<text x=\"{3:.1f}\" y=\"{4:.1f}\" text-anchor=\"end\">{5:g}</text>",
        frame.y(tick), kLeft, kWidth - kRight, kLeft - 6, frame.y(tick) + 4, tick);
  }
  return svg;
}

std::string axis_labels(const LineChart& chart) {
  const double middle_y = 0.5 * (kTop + kHeight - kBottom);
  return fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>"
      "<text transform=\"translate(18 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
      0.5 * (kLeft + kWidth - kRight), kHeight - 10, escape_html(chart.x.label), middle_y,
      escape_html(chart.y.label));
}

std::string band_svg(const ChartLine& line, const ChartFrame& frame) {
  if (line.low.empty()) return "";
  std::string corners;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    corners += fmt::format("{:.1f},{:.1f} ", frame.x(line.points[i].first),
                           frame.y(line.high[i].value_or(line.points[i].second)));
  }
  for (std::size_t i = line.points.size(); i-- > 0;) {
    corners += fmt::format("{:.1f},{:.1f} ", frame.x(line.points[i].first),
                           frame.y(line.low[i].value_or(line.points[i].second)));
  }
  return fmt::format("<polygon class=\"band\" style=\"fill:var(--c{})\" points=\"{}\"/>\n",
                     line.style, corners);
}

std::string line_svg(const ChartLine& line, const ChartFrame& frame) {
  std::string data;
  for (const auto& [x, y] : line.points) {
    data += fmt::format("{}{:.1f} {:.1f}", data.empty() ? 'M' : 'L', frame.x(x), frame.y(y));
  }
  return fmt::format(
      "<path class=\"path c{}\" stroke-width=\"2.2\" d=\"{}\"><title>{}</title>"
      "</path>\n",
      line.style, data, escape_html(line.name));
}

}  // namespace

std::vector<double> axis_ticks(double most) {
  constexpr double kMostTicks = 10.0;
  const double power = std::pow(10.0, std::floor(std::log10(most / kMostTicks)));
  double step = 10.0 * power;
  for (const double factor : {5.0, 2.0, 1.0}) {
    if (most / (factor * power) <= kMostTicks) step = factor * power;
  }
  std::vector<double> ticks;
  const auto count = static_cast<int>(std::floor(most / step + 1e-9));
  for (int i = 0; i <= count; ++i) ticks.push_back(i * step);
  return ticks;
}

std::string line_sample(std::size_t style) {
  return fmt::format(
      "<svg class=\"sample\" viewBox=\"0 0 26 10\" aria-hidden=\"true\"><line class=\"c{}\" "
      "x1=\"1\" x2=\"25\" y1=\"5\" y2=\"5\"/></svg>",
      style);
}

std::string line_chart_html(const LineChart& chart) {
  const ChartFrame frame{chart.x.most, chart.y.most};
  std::string legend;
  std::string lines;
  for (const ChartLine& line : chart.lines) {
    legend += fmt::format("<span>{}{}</span>", line_sample(line.style), escape_html(line.name));
    lines.insert(0, band_svg(line, frame));
    lines += line_svg(line, frame);
  }
  return fmt::format(
      "<div class=\"legend\">{}</div>\n<svg class=\"chart\" viewBox=\"0 0 {:.0f} {:.0f}\" "
      "role=\"img\" aria-label=\"{}\">{}{}{}\n{}</svg>\n",
      legend, kWidth, kHeight, escape_html(chart.title), vertical_grid(frame),
      horizontal_grid(frame), axis_labels(chart), lines);
}

}  // namespace castaway::testbed
