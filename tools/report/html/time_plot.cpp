#include "tools/report/html/time_plot.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "tools/report/html/html.hpp"

namespace castaway::testbed {
namespace {

constexpr double kTimeWidth = 900.0;
constexpr double kTimeHeight = 270.0;
constexpr double kTimeLeft = 58.0;
constexpr double kTimeRight = 12.0;
constexpr double kTimeTop = 22.0;
constexpr double kTimeBottom = 30.0;
constexpr std::size_t kMaxPoints = 1200;

/// From time and value to the picture.
struct Axes {
  const TimePlot& plot;

  [[nodiscard]] double x(double time_s) const {
    const double share = (time_s - plot.begin_s) / (plot.end_s - plot.begin_s);
    return kTimeLeft + share * (kTimeWidth - kTimeLeft - kTimeRight);
  }
  [[nodiscard]] double y(double value) const {
    const auto scaled = [&](double v) { return plot.logarithmic ? std::log10(v) : v; };
    const double clipped = std::clamp(value, plot.low, plot.high);
    const double share =
        (scaled(clipped) - scaled(plot.low)) / (scaled(plot.high) - scaled(plot.low));
    return kTimeHeight - kTimeBottom - share * (kTimeHeight - kTimeTop - kTimeBottom);
  }
};

/// 1, 2 or 5 times a power of ten: about eight ticks.
double time_step(double duration_s) {
  const double rough = std::max(duration_s, 1e-3) / 8.0;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough) return factor * power;
  }
  return 10.0 * power;
}

std::vector<double> value_ticks(const TimePlot& plot) {
  std::vector<double> ticks;
  if (!plot.logarithmic) {
    for (int i = 0; i <= 4; ++i) ticks.push_back(plot.low + (plot.high - plot.low) * i / 4.0);
    return ticks;
  }
  const auto last = static_cast<int>(std::lround(std::log10(plot.high)));
  for (auto power = static_cast<int>(std::lround(std::log10(plot.low))); power <= last; ++power) {
    ticks.push_back(std::pow(10.0, power));
  }
  return ticks;
}

void add_grid(const TimePlot& plot, const Axes& axes, std::string& svg) {
  for (const double value : value_ticks(plot)) {
    svg += fmt::format(
        "<line class=\"grid\" x1=\"{:.0f}\" x2=\"{:.0f}\" y1=\"{:.1f}\" y2=\"{:.1f}\"/>"
        "<text x=\"{:.0f}\" y=\"{:.1f}\" text-anchor=\"end\">{:g}</text>",
        kTimeLeft, kTimeWidth - kTimeRight, axes.y(value), axes.y(value), kTimeLeft - 6,
        axes.y(value) + 4, value);
  }
  const double step = time_step(plot.end_s - plot.begin_s);
  for (double t = std::ceil(plot.begin_s / step) * step; t <= plot.end_s + 1e-9; t += step) {
    svg += fmt::format(
        "<line class=\"grid\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:.0f}\" y2=\"{2:.0f}\"/>"
        "<text x=\"{0:.1f}\" y=\"{3:.0f}\" text-anchor=\"middle\">{4:g}</text>",
        axes.x(t), kTimeTop, kTimeHeight - kTimeBottom, kTimeHeight - kTimeBottom + 16, t);
  }
  svg += fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"end\">time, s</text>",
                     kTimeWidth - kTimeRight, kTimeHeight - 2);
  svg += fmt::format("<text x=\"{:.0f}\" y=\"12\" text-anchor=\"end\">{}</text>", kTimeLeft - 6,
                     escape_html(plot.unit));
}

void add_marks(const TimePlot& plot, const Axes& axes, std::string& svg) {
  if (plot.limit > 0.0) {
    svg += fmt::format(
        "<line class=\"limit\" x1=\"{:.0f}\" x2=\"{:.0f}\" y1=\"{:.1f}\" y2=\"{:.1f}\"/>",
        kTimeLeft, kTimeWidth - kTimeRight, axes.y(plot.limit), axes.y(plot.limit));
  }
  for (const PlotMark& mark : plot.marks) {
    svg += fmt::format(
        "<line class=\"mark\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:.0f}\" y2=\"{2:.0f}\"/>"
        "<text class=\"marked\" x=\"{0:.1f}\" y=\"14\" text-anchor=\"middle\">{3}</text>",
        axes.x(mark.time_s), kTimeTop, kTimeHeight - kTimeBottom, escape_html(mark.label));
  }
}

void add_curve(const PlotCurve& curve, const Axes& axes, std::string& svg) {
  std::string path;
  for (const auto& piece : curve.pieces) {
    char command = 'M';
    for (const auto& [time_s, value] : thinned(piece, kMaxPoints)) {
      path += fmt::format("{}{:.1f} {:.1f}", command, axes.x(time_s), axes.y(value));
      command = 'L';
    }
    if (piece.size() == 1) path += "h0.1";
  }
  if (path.empty()) return;
  svg += fmt::format("<path class=\"curve c{}\" d=\"{}\"><title>{}</title></path>", curve.color % 6,
                     path, escape_html(curve.name));
}

}  // namespace

std::vector<std::pair<double, double>> thinned(const std::vector<std::pair<double, double>>& points,
                                               std::size_t most) {
  if (points.size() <= most || most < 2) return points;
  const std::size_t buckets = most / 2;
  std::vector<std::pair<double, double>> kept;
  for (std::size_t i = 0; i < buckets; ++i) {
    const auto at = [&](std::size_t bucket) {
      return points.begin() + static_cast<std::ptrdiff_t>(bucket * points.size() / buckets);
    };
    const auto [low, high] = std::minmax_element(
        at(i), at(i + 1), [](const auto& a, const auto& b) { return a.second < b.second; });
    kept.push_back(*std::min(low, high));
    if (low != high) kept.push_back(*std::max(low, high));
  }
  return kept;
}

std::string render_plot(const TimePlot& plot) {
  const Axes axes{plot};
  std::string svg = fmt::format(
      "<svg class=\"plot time\" viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"{}\">",
      kTimeWidth, kTimeHeight, escape_html(plot.title));
  add_grid(plot, axes, svg);
  add_marks(plot, axes, svg);
  for (const PlotCurve& curve : plot.curves) add_curve(curve, axes, svg);
  return svg + "</svg>\n";
}

}  // namespace castaway::testbed
