#include "tools/report/html/xy_plot.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "tools/report/html/html.hpp"

namespace castaway::testbed {
namespace {

constexpr double kPlotWidth = 520.0;
constexpr double kPlotHeight = 340.0;
constexpr double kPlotLeft = 58.0;
constexpr double kPlotRight = 14.0;
constexpr double kPlotTop = 14.0;
constexpr double kPlotBottom = 44.0;
constexpr std::size_t kMostDots = 2500;

/// Where along an axis a value lies, in [0, 1].
double share(const PlotAxis& axis, double value) {
  const auto scaled = [&](double v) { return axis.logarithmic ? std::log10(v) : v; };
  const double clipped = std::clamp(value, axis.low, axis.high);
  return (scaled(clipped) - scaled(axis.low)) / (scaled(axis.high) - scaled(axis.low));
}

double x_of(const XyPlot& plot, double value) {
  return kPlotLeft + share(plot.x, value) * (kPlotWidth - kPlotLeft - kPlotRight);
}

double y_of(const XyPlot& plot, double value) {
  return kPlotHeight - kPlotBottom - share(plot.y, value) * (kPlotHeight - kPlotTop - kPlotBottom);
}

std::vector<double> ticks(const PlotAxis& axis) {
  std::vector<double> values;
  if (axis.logarithmic) {
    for (double value = axis.low; value < 1.001 * axis.high; value *= 10.0) values.push_back(value);
    return values;
  }
  for (int i = 0; i <= 4; ++i) values.push_back(axis.low + (axis.high - axis.low) * i / 4.0);
  return values;
}

void add_axes(const XyPlot& plot, std::string& svg) {
  for (const double value : ticks(plot.y)) {
    svg += fmt::format(
        "<line class=\"grid\" x1=\"{0:.0f}\" x2=\"{1:.0f}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\"/>"
        "<text x=\"{3:.0f}\" y=\"{4:.1f}\" text-anchor=\"end\">{5:g}</text>",
        kPlotLeft, kPlotWidth - kPlotRight, y_of(plot, value), kPlotLeft - 6, y_of(plot, value) + 4,
        value);
  }
  for (const double value : ticks(plot.x)) {
    svg += fmt::format(
        "<line class=\"grid\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:.0f}\" y2=\"{2:.0f}\"/>"
        "<text x=\"{0:.1f}\" y=\"{3:.0f}\" text-anchor=\"middle\">{4:g}</text>",
        x_of(plot, value), kPlotTop, kPlotHeight - kPlotBottom, kPlotHeight - kPlotBottom + 16,
        value);
  }
  const double middle = kPlotTop + 0.5 * (kPlotHeight - kPlotTop - kPlotBottom);
  svg += fmt::format(
      "<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"middle\">{}</text>"
      "<text x=\"12\" y=\"{:.0f}\" text-anchor=\"middle\" transform=\"rotate(-90 12 {:.0f})\">{}"
      "</text>",
      0.5 * (kPlotLeft + kPlotWidth - kPlotRight), kPlotHeight - 8, escape_html(plot.x.label),
      middle, middle, escape_html(plot.y.label));
}

void add_line(const XyPlot& plot, const XySeries& series, std::string& svg) {
  std::string path;
  for (const auto& [x, y] : series.points) {
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? 'M' : 'L', x_of(plot, x), y_of(plot, y));
  }
  svg += fmt::format("<path class=\"curve c{}\" d=\"{}\"><title>{}</title></path>",
                     series.color % 6, path, escape_html(series.name));
}

/// Dots are strokes of no length with round ends: one path for all of them.
void add_dots(const XyPlot& plot, const XySeries& series, std::string& svg) {
  std::string path;
  for (const auto& [x, y] : every_few(series.points, kMostDots)) {
    path += fmt::format("M{:.1f} {:.1f}h0", x_of(plot, x), y_of(plot, y));
  }
  svg += fmt::format(
      "<path class=\"dots c{}\" style=\"stroke-dasharray: none\" fill=\"none\" "
      "stroke-width=\"4\" stroke-linecap=\"round\" stroke-opacity=\"0.45\" "
      "d=\"{}\"><title>{}</title></path>",
      series.color % 6, path, escape_html(series.name));
}

/// Why a plot without points is empty.
void add_nothing(const XyPlot& plot, std::string& svg) {
  const auto is_empty = [](const XySeries& series) { return series.points.empty(); };
  if (!std::all_of(plot.series.begin(), plot.series.end(), is_empty)) return;
  svg += fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"middle\">{}</text>",
                     0.5 * (kPlotLeft + kPlotWidth - kPlotRight),
                     0.5 * (kPlotTop + kPlotHeight - kPlotBottom), escape_html(plot.nothing));
}

}  // namespace

std::vector<std::pair<double, double>> every_few(
    const std::vector<std::pair<double, double>>& points, std::size_t most) {
  if (points.size() <= most) return points;
  std::vector<std::pair<double, double>> kept;
  for (std::size_t i = 0; i < most; ++i) kept.push_back(points[i * points.size() / most]);
  return kept;
}

std::string render_xy_plot(const XyPlot& plot) {
  std::string svg = fmt::format(
      "<svg class=\"plot xy\" viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"{}\">",
      kPlotWidth, kPlotHeight, escape_html(plot.title));
  add_axes(plot, svg);
  add_nothing(plot, svg);
  for (const XySeries& series : plot.series) {
    if (series.points.empty()) continue;
    if (series.line) {
      add_line(plot, series, svg);
    } else {
      add_dots(plot, series, svg);
    }
  }
  return svg + "</svg>\n";
}

}  // namespace castaway::testbed
