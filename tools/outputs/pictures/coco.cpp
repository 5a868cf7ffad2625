#include "tools/outputs/pictures/coco.hpp"

#include <algorithm>
#include <set>

#include <nlohmann/json.hpp>

#include "sim/scene/scene.hpp"

#include "tools/base/files/json_text.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kPersonCategory = 1;

Json annotation(const InstanceMask& mask, int height, int width) {
  return {{"category_id", kPersonCategory},
          {"bbox", {mask.left, mask.top, mask.width, mask.height}},
          {"area", mask.area},
          {"iscrowd", 0},
          {"segmentation", {{"size", {height, width}}, {"counts", mask.counts}}}};
}

/// Ids of the people in an image, ascending.
std::set<std::uint16_t> people_in(const std::vector<std::uint16_t>& instances) {
  std::set<std::uint16_t> people;
  for (const std::uint16_t instance : instances) {
    if (instance >= sim::kFirstPersonInstance) people.insert(instance);
  }
  return people;
}

}  // namespace

std::optional<InstanceMask> mask_of(const std::vector<std::uint16_t>& instances, int width,
                                    std::uint16_t instance) {
  const int height = static_cast<int>(instances.size()) / width;
  InstanceMask mask{width, height, 0, 0, 0, {}};
  int right = -1;
  int bottom = -1;
  bool inside = false;
  mask.counts.push_back(0);
  for (int column = 0; column < width; ++column) {
    for (int row = 0; row < height; ++row) {
      const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(column);
      const bool belongs = instances[at] == instance;
      if (belongs != inside) mask.counts.push_back(0);
      inside = belongs;
      ++mask.counts.back();
      if (!belongs) continue;
      ++mask.area;
      mask.left = std::min(mask.left, column);
      mask.top = std::min(mask.top, row);
      right = std::max(right, column);
      bottom = std::max(bottom, row);
    }
  }
  if (mask.area == 0) return std::nullopt;
  mask.width = right - mask.left + 1;
  mask.height = bottom - mask.top + 1;
  return mask;
}

CocoFile::CocoFile()
    : root_{{"info", {{"description", "people seen by the robot's camera"}}},
            {"licenses", Json::array()},
            {"categories",
             {{{"id", kPersonCategory}, {"name", "person"}, {"supercategory", "person"}}}},
            {"images", Json::array()},
            {"annotations", Json::array()}} {}

void CocoFile::add(const std::string& file_name, double stamp_s,
                   const std::vector<std::uint16_t>& instances, int width) {
  const int height = static_cast<int>(instances.size()) / width;
  const std::size_t image = root_["images"].size() + 1;
  root_["images"].push_back({{"id", image},
                             {"file_name", file_name},
                             {"width", width},
                             {"height", height},
                             {"stamp_s", stamp_s}});
  for (const std::uint16_t person : people_in(instances)) {
    Json entry{{"id", root_["annotations"].size() + 1},
               {"image_id", image},
               {"person", person - sim::kFirstPersonInstance}};
    entry.update(annotation(*mask_of(instances, width, person), height, width));
    root_["annotations"].push_back(std::move(entry));
  }
}

std::string CocoFile::text() const { return json_text(root_) + "\n"; }

}  // namespace castaway::testbed
