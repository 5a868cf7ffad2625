#include "tools/pages/dataset/dataset_plots.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/bytes/json_number.hpp"
#include "tools/base/formats/html.hpp"
#include "tools/batch/dataset/sequence_statistics.hpp"
#include "tools/pages/html/html_page.hpp"
#include "tools/pages/html/plot_data.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kKidnapBin = 2.0;  // [m]

double sum_of(const std::vector<double>& counts) {
  return std::accumulate(counts.begin(), counts.end(), 0.0);
}

std::vector<double> kidnap_counts(const DatasetContents& contents) {
  std::vector<double> counts;
  for (const Json& sequence : contents.sequences) {
    for (const Json& kidnap : sequence.at("kidnaps")) {
      const auto bin = static_cast<std::size_t>(kidnap.at("distance_m").get<double>() / kKidnapBin);
      counts.resize(std::max(counts.size(), bin + 1));
      counts[bin] += 1.0;
    }
  }
  return counts;
}

Json histogram_json(const Histogram& histogram) {
  const double sum = sum_of(histogram.counts);
  PlotPoints steps;
  for (const double count : histogram.counts) {
    steps.emplace_back(histogram.bin * static_cast<double>(steps.size()), count / sum);
  }
  if (!steps.empty()) steps.emplace_back(steps.back().first + histogram.bin, steps.back().second);
  const double most = steps.empty() ? 1.0 : steps.back().first;
  return {{"title", histogram.title},
          {"x", {{"label", histogram.label}, {"range", {0.0, most}}}},
          {"y", {{"label", "share"}}},
          {"series", Json::array({point_series("share", "steps", steps)})},
          {"nothing", "There are none."}};
}

Json odometry_json(const DatasetContents& contents) {
  PlotPoints median{{0.0, 0.0}};
  PlotPoints most{{0.0, 0.0}};
  for (const auto& [metres, errors] : odometry_errors(contents)) {
    median.emplace_back(metres, quantile(errors, 0.5));
    most.emplace_back(metres, quantile(errors, 0.9));
  }
  return {{"title", "Odometry: error of position since the start or the last kidnap"},
          {"x", {{"label", "driven [m]"}}},
          {"y", {{"label", "error [m]"}}},
          {"series", Json::array({point_series("median", "", median),
                                  point_series("90 % below", "", most)})}};
}

std::string quantile_cell(const std::optional<double>& value) {
  return value ? fmt::format("{:.4g}", *value) : "";
}

}  // namespace

std::vector<Histogram> dataset_histograms(const DatasetContents& contents) {
  std::vector<Histogram> histograms{
      {"Ranges of all returns", "range [m]", kRangeBin, contents.counts("/statistics/ranges")},
      {"Occlusion: beams on what the map does not show", "share of a scan's beams",
       1.0 / kOccludedBins, contents.counts("/statistics/occluded")},
      {"Kidnaps: how far", "distance [m]", kKidnapBin, kidnap_counts(contents)}};
  for (Histogram& histogram : histograms) {
    while (!histogram.counts.empty() && histogram.counts.back() <= 0.0) histogram.counts.pop_back();
  }
  return histograms;
}

std::optional<double> quantile_of(const Histogram& histogram, double q) {
  const double wanted = q * sum_of(histogram.counts);
  double sum = 0.0;
  for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
    sum += histogram.counts[i];
    if (sum >= wanted) return histogram.bin * static_cast<double>(i + 1);
  }
  return std::nullopt;
}

std::map<int, std::vector<double>> odometry_errors(const DatasetContents& contents) {
  std::map<int, std::vector<double>> errors;
  for (const Json& sequence : contents.sequences) {
    for (const Json& point : sequence.at("statistics").at("odometry_error_m")) {
      errors[integer<int>(point[0])].push_back(point[1].get<double>());
    }
  }
  return errors;
}

std::string describe_distributions(const DatasetContents& contents) {
  std::string text = "| | 10 % below | 50 % below | 90 % below |\n|---|---|---|---|\n";
  for (const Histogram& histogram : dataset_histograms(contents)) {
    text += fmt::format("| {}, {} | {} | {} | {} |\n", histogram.title, histogram.label,
                        quantile_cell(quantile_of(histogram, 0.1)),
                        quantile_cell(quantile_of(histogram, 0.5)),
                        quantile_cell(quantile_of(histogram, 0.9)));
  }
  const auto errors = odometry_errors(contents);
  for (const int metres : {1, 5, 10, 50, 100}) {
    const auto found = errors.find(metres);
    if (found == errors.end()) continue;
    text += fmt::format("| Odometry, error after {} m [m] | {} | {} | {} |\n", metres,
                        quantile_cell(quantile(found->second, 0.1)),
                        quantile_cell(quantile(found->second, 0.5)),
                        quantile_cell(quantile(found->second, 0.9)));
  }
  return text;
}

std::string plots_page(const DatasetContents& contents) {
  const std::string title = "Data set " + contents.spec.name;
  Json plots = Json::array();
  for (const Histogram& histogram : dataset_histograms(contents)) {
    plots.push_back(histogram_json(histogram));
  }
  plots.push_back(odometry_json(contents));
  const std::string body =
      "<h1>" + escape_html(title) + "</h1>\n" + plots_notice() +
      "<p class=\"soft\">As tables: <a href=\"../README.md\">README.md</a>.</p>\n" +
      plots_html({{"plots", plots}}, PlotLayout::kPairs);
  return html_page({.title = title, .body = body, .bundle = plots_bundle()});
}

}  // namespace castaway::testbed
