#include "tools/pages/html/plot_data.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include <fmt/format.h>

#include "tools/pages/html/web_bundle.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostOfLine = 2400;
constexpr int kTimeDigits = 7;  // 0.1 ms in a thousand seconds, 10 ms in a day.

Json plot_number(const std::optional<double>& value, int digits) {
  if (!value || !std::isfinite(*value)) return nullptr;
  const std::string text = fmt::format("{:.{}g}", *value, digits);
  const double rounded = std::strtod(text.c_str(), nullptr);
  const bool whole = std::abs(rounded) < 1e15 && rounded == std::floor(rounded);
  return whole ? Json(static_cast<std::int64_t>(rounded))
               : Json(rounded);  // Writes 2 rather than 2.0.
}

template <typename T>
std::vector<T> evenly_spaced(const std::vector<T>& all, std::size_t most) {
  if (all.size() <= most) return all;
  std::vector<T> kept;
  for (std::size_t i = 0; i < most; ++i) kept.push_back(all[i * all.size() / most]);
  return kept;
}

}  // namespace

Json plot_numbers(const PlotColumn& values, int digits) {
  Json numbers = Json::array();
  for (const auto& value : values) numbers.push_back(plot_number(value, digits));
  return numbers;
}

PlotColumn thin_column(const PlotColumn& values, std::size_t most) {
  if (values.size() <= most) return values;
  const std::size_t stretches = most / 2;
  const auto start_of = [&](std::size_t stretch) {
    return values.begin() + static_cast<std::ptrdiff_t>(stretch * values.size() / stretches);
  };
  PlotColumn kept;
  for (std::size_t i = 0; i < stretches; ++i) {
    const auto [low, high] = std::minmax_element(start_of(i), start_of(i + 1));
    kept.push_back(*std::min(low, high));
    kept.push_back(*std::max(low, high));
  }
  return kept;
}

PlotPoints every_few(const PlotPoints& points, std::size_t most) {
  return evenly_spaced(points, most);
}

Json time_axis(const std::vector<double>& stamps_s) {
  const std::vector<double> kept = evenly_spaced(stamps_s, kMostOfLine);
  return plot_numbers({kept.begin(), kept.end()}, kTimeDigits);
}

PlotPoints cumulative(const std::vector<double>& samples) {
  PlotPoints points;
  const auto count = static_cast<double>(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    points.emplace_back(samples[i], static_cast<double>(i + 1) / count);
  }
  constexpr std::size_t kMostOfCurve = 300;
  return every_few(points, kMostOfCurve);
}

Json time_series(const std::string& name, const std::vector<double>& stamps_s,
                 const PlotColumn& values, const Json& shared) {
  Json series{{"name", name}, {"y", plot_numbers(thin_column(values, kMostOfLine))}};
  Json times = time_axis(stamps_s);
  if (times != shared) series["x"] = std::move(times);
  return series;
}

Json point_series(const std::string& name, const std::string& style, const PlotPoints& points) {
  PlotColumn x;
  PlotColumn y;
  for (const auto& [px, py] : points) {
    x.emplace_back(px);
    y.emplace_back(py);
  }
  Json series{{"name", name}};
  if (!style.empty()) series["style"] = style;
  series["x"] = plot_numbers(x);
  series["y"] = plot_numbers(y);
  return series;
}

std::string script_json(const Json& json) {
  std::string safe;
  for (const char c : json.dump(-1, ' ', true, Json::error_handler_t::replace)) {
    if (c == '<') {
      safe += "\\u003c";
    } else {
      safe += c;
    }
  }
  return safe;
}

std::string plots_html(const Json& group, PlotLayout layout) {
  if (!plots_bundle()) return "";
  return fmt::format(
      "<div class=\"plots {}\"></div><script type=\"application/json\">{}</script>\n",
      layout == PlotLayout::kPairs ? "pairs" : "wide", script_json(group));
}

std::string plots_notice() {
  if (plots_bundle()) {
    return "<noscript><p class=\"soft\">JavaScript is off: the plots of this page are missing, its "
           "tables and pictures are not.</p></noscript>\n";
  }
  return "<p class=\"soft\">This page has no plots: castaway was built without Node.js. Install "
         "nodejs and npm, configure and build again, and make the page again.</p>\n";
}

}  // namespace castaway::testbed
