#include "tools/report/html/reliability_plot.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "tools/report/html/html.hpp"

namespace castaway::testbed {
namespace {

constexpr double kReliabilityWidth = 900.0;
constexpr double kReliabilityHeight = 360.0;
constexpr double kReliabilityTop = 24.0;
constexpr double kReliabilitySide = 290.0;  // Of both panels, upwards.
constexpr int kBins = 10;

/// A panel whose both axes go from 0 to 1.
struct Panel {
  double left = 0.0;
  double width = kReliabilitySide;

  [[nodiscard]] double x(double value) const { return left + value * width; }
  [[nodiscard]] static double y(double value) {
    return kReliabilityTop + (1.0 - value) * kReliabilitySide;
  }
};

constexpr Panel kDiagram{58.0, kReliabilitySide};
constexpr Panel kHistogram{440.0, 440.0};

void add_grid(const Panel& panel, const char* across, const char* upwards, std::string& svg) {
  for (int i = 0; i <= 5; ++i) {
    const double value = 0.2 * i;
    svg += fmt::format(
        "<line class=\"grid\" x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{:.1f}\" y2=\"{:.1f}\"/>"
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{:g}</text>",
        panel.x(0.0), panel.x(1.0), Panel::y(value), Panel::y(value), panel.x(0.0) - 6.0,
        Panel::y(value) + 4.0, value);
    svg += fmt::format(
        "<line class=\"grid\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:.1f}\" y2=\"{2:.1f}\"/>"
        "<text x=\"{0:.1f}\" y=\"{3:.1f}\" text-anchor=\"middle\">{4:g}</text>",
        panel.x(value), Panel::y(1.0), Panel::y(0.0), Panel::y(0.0) + 15.0, value);
  }
  svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>", panel.x(1.0),
                     Panel::y(0.0) + 32.0, across);
  svg += fmt::format("<text x=\"{:.1f}\" y=\"14\">{}</text>", panel.x(0.0) - 30.0, upwards);
}

std::string words(const ReliabilityCurve& curve, const ReliabilityPoint& point) {
  return fmt::format("{}: stated {:.3f}, right {:.3f} of {} scans", escape_html(curve.name),
                     point.stated, point.observed, point.scans);
}

/// Points with their intervals, joined by a line.
void add_points(const ReliabilityCurve& curve, std::string& svg) {
  const std::size_t color = curve.color % 6;
  std::string path;
  for (const ReliabilityPoint& point : curve.points) {
    const double x = kDiagram.x(point.stated);
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? 'M' : 'L', x, Panel::y(point.observed));
    svg += fmt::format(
        "<line class=\"c{0}\" x1=\"{1:.1f}\" x2=\"{1:.1f}\" y1=\"{2:.1f}\" y2=\"{3:.1f}\"/>"
        "<circle class=\"curve c{0}\" cx=\"{1:.1f}\" cy=\"{4:.1f}\" r=\"4\"><title>{5}</title>"
        "</circle>",
        color, x, Panel::y(point.low), Panel::y(point.high), Panel::y(point.observed),
        words(curve, point));
  }
  if (!path.empty()) svg += fmt::format("<path class=\"curve c{}\" d=\"{}\"/>", color, path);
}

/// Bars of the share of a localizer's scans; `place` of `count` localizers.
void add_bars(const ReliabilityCurve& curve, std::size_t place, std::size_t count,
              std::string& svg) {
  std::int64_t all = 0;
  for (const ReliabilityPoint& point : curve.points) all += point.scans;
  const double bin = kHistogram.width / kBins;
  const double bar = 0.8 * bin / static_cast<double>(count);
  for (const ReliabilityPoint& point : curve.points) {
    const int index = std::clamp(static_cast<int>(point.stated * kBins), 0, kBins - 1);
    const double x =
        kHistogram.left + (index + 0.1) * bin + (static_cast<double>(place) + 0.5) * bar;
    const double share = static_cast<double>(point.scans) / static_cast<double>(all);
    svg += fmt::format(
        "<line class=\"c{0}\" stroke-width=\"{1:.1f}\" x1=\"{2:.1f}\" x2=\"{2:.1f}\" "
        "y1=\"{3:.1f}\" y2=\"{4:.1f}\"><title>{5}</title></line>",
        curve.color % 6, bar, x, Panel::y(0.0), std::min(Panel::y(share), Panel::y(0.0) - 1.5),
        words(curve, point));
  }
}

}  // namespace

std::string render_reliability(const std::vector<ReliabilityCurve>& curves) {
  std::string svg = fmt::format(
      "<svg class=\"plot\" viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" "
      "aria-label=\"stated probability against observed frequency\">",
      kReliabilityWidth, kReliabilityHeight);
  add_grid(kDiagram, "stated probability", "share that is right", svg);
  add_grid(kHistogram, "stated probability", "share of the scans", svg);
  svg +=
      fmt::format("<line class=\"limit\" x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{:.1f}\" y2=\"{:.1f}\"/>",
                  kDiagram.x(0.0), kDiagram.x(1.0), Panel::y(0.0), Panel::y(1.0));
  for (std::size_t i = 0; i < curves.size(); ++i) {
    add_points(curves[i], svg);
    add_bars(curves[i], i, curves.size(), svg);
  }
  return svg + "</svg>\n";
}

}  // namespace castaway::testbed
