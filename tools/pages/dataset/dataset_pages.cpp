#include "tools/pages/dataset/dataset_pages.hpp"

#include <nlohmann/json.hpp>

#include "tools/base/bytes/json_number.hpp"
#include "tools/base/output/file_name.hpp"
#include "tools/batch/dataset/sequence_statistics.hpp"
#include "tools/pages/dataset/coverage_picture.hpp"
#include "tools/pages/dataset/dataset_card.hpp"
#include "tools/pages/dataset/dataset_plots.hpp"

namespace castaway::testbed {
namespace {

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
