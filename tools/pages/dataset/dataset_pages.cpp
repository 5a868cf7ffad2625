#include "tools/pages/dataset/dataset_pages.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <nlohmann/json.hpp>

#include "sim/scene/image.hpp"
#include "tools/base/bytes/json_number.hpp"
#include "tools/base/output/file_name.hpp"
#include "tools/batch/dataset/sequence_statistics.hpp"
#include "tools/pages/dataset/dataset_card.hpp"
#include "tools/pages/dataset/dataset_plots.hpp"

namespace castaway::testbed {
namespace {

using Color = std::array<double, 3>;

constexpr Color kFew{1.0, 0.93, 0.55};
constexpr Color kMost{0.60, 0.0, 0.10};

Color map_color(std::int8_t cell) {
  if (cell < 0) return {0.80, 0.80, 0.80};
  const double light = 1.0 - 0.01 * cell;
  return {light, light, light};
}

/// `heat` in (0, 1]. The colour is multiplied so that walls stay visible.
Color blend_heat(const Color& below, double heat) {
  Color color{};
  for (std::size_t i = 0; i < color.size(); ++i) {
    color[i] = (kFew[i] + (kMost[i] - kFew[i]) * heat) * below[i];
  }
  return color;
}

double most_of(const Coverage& coverage) {
  double most = 0.0;
  for (const auto& [cell, scans] : coverage) most = std::max(most, scans);
  return most;
}

using Json = nlohmann::ordered_json;

Coverage coverage_of(const DatasetContents& contents, const std::string& world) {
  Coverage coverage;
  for (const Json& sequence : contents.sequences) {
    if (sequence.at("world") != world) continue;
    for (const Json& cell : sequence.at("statistics").at("coverage")) {
      coverage[{integer<int>(cell[0]), integer<int>(cell[1])}] += cell[2].get<double>();
    }
  }
  return coverage;
}

}  // namespace

std::string coverage_png(const RosMap& map, const Coverage& coverage, double edge) {
  sim::Image image{map.width, map.height, {}};
  image.pixels.reserve(3 * map.cells.size());
  const double most = most_of(coverage);
  const auto cell_of = [&](int index, double origin) {
    return static_cast<int>(std::floor((origin + (index + 0.5) * map.resolution) / edge));
  };
  for (int y = map.height - 1; y >= 0; --y) {
    for (int x = 0; x < map.width; ++x) {
      Color color = map_color(map.at(x, y));
      const auto found = coverage.find({cell_of(x, map.origin_x), cell_of(y, map.origin_y)});
      if (found != coverage.end()) {
        color = blend_heat(color, std::log1p(found->second) / std::log1p(most));
      }
      for (const double part : color) {
        image.pixels.push_back(static_cast<std::uint8_t>(std::lround(255.0 * part)));
      }
    }
  }
  return sim::encode_png(image);
}

std::vector<DatasetFile> dataset_pages(const DatasetContents& contents) {
  std::vector<DatasetFile> files{{"README.md", dataset_card(contents)},
                                 {kPlotsPage, plots_page(contents)}};
  for (const auto& [world, map] : contents.maps) {
    files.emplace_back("plots/coverage-" + file_name_of(world) + ".png",
                       coverage_png(map, coverage_of(contents, world), kCoverageCell));
  }
  return files;
}

}  // namespace castaway::testbed
