#include "tools/dataset/dataset_plots.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "tools/pictures/palette.hpp"
#include "tools/report/html/html.hpp"

namespace castaway::testbed {
namespace {

constexpr double kWidth = 640.0;   // [px]
constexpr double kHeight = 320.0;  // [px]
constexpr double kLeft = 62.0;
constexpr double kRight = 620.0;
constexpr double kTop = 40.0;
constexpr double kBottom = 268.0;

/// 1, 2 or 5 times a power of ten, so that about five steps reach `most`.
double step_for(double most) {
  const double raw = std::max(most, 1e-9) / 5.0;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (raw <= factor * power) return factor * power;
  }
  return 10.0 * power;
}

/// The two axes from 0 to where they end.
class PlotFrame {
 public:
  PlotFrame(double x_most, double y_most)
      : x_most_(std::max(x_most, 1e-9)), y_most_(std::max(y_most, 1e-9)) {}

  [[nodiscard]] double x(double value) const {
    return kLeft + (kRight - kLeft) * std::clamp(value / x_most_, 0.0, 1.0);
  }
  [[nodiscard]] double y(double value) const {
    return kBottom - (kBottom - kTop) * std::clamp(value / y_most_, 0.0, 1.0);
  }

  [[nodiscard]] std::string axes(const std::string& x_label, const std::string& y_label) const {
    std::string svg;
    const auto out = std::back_inserter(svg);
    const double x_step = step_for(x_most_);
    for (int i = 0; i * x_step <= x_most_ * 1.0001; ++i) {
      fmt::format_to(out, "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{:g}</text>\n",
                     x(i * x_step), kBottom + 18.0, i * x_step);
    }
    const double y_step = step_for(y_most_);
    for (int i = 0; i * y_step <= y_most_ * 1.0001; ++i) {
      const double at = y(i * y_step);
      fmt::format_to(out,
                     "<line x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\" "
                     "stroke=\"#ddd\"/>\n"
                     "<text x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\">{5:g}</text>\n",
                     kLeft, kRight, at, kLeft - 6.0, at + 4.0, i * y_step);
    }
    fmt::format_to(out, "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n",
                   0.5 * (kLeft + kRight), kBottom + 38.0, escape_html(x_label));
    fmt::format_to(out, "<text x=\"8\" y=\"{}\">{}</text>\n", kTop - 10.0, escape_html(y_label));
    return svg;
  }

 private:
  double x_most_;
  double y_most_;
};

std::string page(const std::string& title, const std::string& body) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\" font-family=\"sans-serif\" font-size=\"12\" fill=\"#222\">\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n"
      "<text x=\"{2}\" y=\"18\" text-anchor=\"middle\" font-size=\"14\">{3}</text>\n{4}</svg>\n",
      kWidth, kHeight, 0.5 * kWidth, escape_html(title), body);
}

}  // namespace

std::string histogram_svg(const HistogramPlot& plot) {
  std::vector<double> shares = plot.counts;
  while (shares.size() > 1 && shares.back() <= 0.0) shares.pop_back();
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  for (double& share : shares) share = sum > 0.0 ? share / sum : 0.0;
  const double most = shares.empty() ? 0.0 : *std::max_element(shares.begin(), shares.end());
  const PlotFrame frame(plot.bin * static_cast<double>(shares.size()), most);
  std::string body = frame.axes(plot.x_label, "share");
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const double left = frame.x(plot.bin * static_cast<double>(i));
    const double right = frame.x(plot.bin * static_cast<double>(i + 1));
    const double top = frame.y(shares[i]);
    fmt::format_to(std::back_inserter(body),
                   "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" "
                   "fill=\"{}\"/>\n",
                   left, top, std::max(right - left - 1.0, 0.5), kBottom - top,
                   css_color(kLocalizerColors[0]));
  }
  return page(plot.title, body);
}

std::string lines_svg(const LinesPlot& plot) {
  double x_most = 0.0;
  double y_most = 0.0;
  for (const LinesPlot::Line& line : plot.lines) {
    for (const auto& [x, y] : line.points) {
      x_most = std::max(x_most, x);
      y_most = std::max(y_most, y);
    }
  }
  const PlotFrame frame(x_most, y_most);
  std::string body = frame.axes(plot.x_label, plot.y_label);
  for (std::size_t i = 0; i < plot.lines.size(); ++i) {
    const std::string color = css_color(palette_color(kLocalizerColors, i));
    std::string points;
    for (const auto& [x, y] : plot.lines[i].points) {
      fmt::format_to(std::back_inserter(points), "{:.1f},{:.1f} ", frame.x(x), frame.y(y));
    }
    fmt::format_to(std::back_inserter(body),
                   "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/>\n"
                   "<text x=\"{}\" y=\"{}\" fill=\"{}\">{}</text>\n",
                   points, color, kLeft + 12.0, kTop + 14.0 + 16.0 * static_cast<double>(i), color,
                   escape_html(plot.lines[i].name));
  }
  return page(plot.title, body);
}

}  // namespace castaway::testbed
