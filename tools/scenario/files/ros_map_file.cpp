#include "tools/scenario/files/ros_map_file.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "tools/scenario/yaml/nearest.hpp"
#include "tools/scenario/yaml/yaml_reader.hpp"
#include "xacro/files/lower_case.hpp"

namespace castaway::testbed {
namespace {

double share_of_one(YamlReader& root, const std::string& key, double fallback) {
  const double value = root.get(key, fallback);
  if (value < 0.0 || value > 1.0) root.find(key)->fail("must be from 0 to 1");
  return value;
}

/// `negate` is 0 or 1, or a boolean.
bool read_negate(YamlReader& root) {
  const auto negate = root.find("negate");
  if (!negate) return false;
  const auto text = to_lower(negate->as<std::string>());
  if (text != "0" && text != "1" && text != "true" && text != "false") {
    negate->fail("expected 0 or 1, found '" + text + "'");
  }
  return text == "1" || text == "true";
}

/// Case-insensitive, as in map_server.
MapMode read_mode(YamlReader& root) {
  const std::string text = root.get<std::string>("mode", "trinary");
  const std::string mode = to_lower(text);
  if (mode == "trinary") return MapMode::kTrinary;
  if (mode == "scale") return MapMode::kScale;
  if (mode == "raw") return MapMode::kRaw;
  root.find("mode")->fail(fmt::format("'{}' is not allowed here; {}", text,
                                      suggestion(mode, {"trinary", "scale", "raw"})));
}

RosMapHeader read_header(YamlReader& root) {
  RosMapHeader header;
  header.resolution = root.require<double>("resolution");
  if (!(header.resolution >= 0.001 && header.resolution <= 10.0)) {
    root.find("resolution")->fail("must be above 0, from 0.001 to 10 (metres a cell)");
  }
  const auto origin = root.require<Eigen::Vector3d>("origin");
  if (!(origin.cwiseAbs().maxCoeff() <= 1e7)) root.find("origin")->fail("lies beyond 1e7 m");
  header.origin_x = origin.x();
  header.origin_y = origin.y();
  header.origin_yaw = origin.z();
  header.mode = read_mode(root);
  header.negate = read_negate(root);
  header.occupied_thresh = share_of_one(root, "occupied_thresh", header.occupied_thresh);
  header.free_thresh = share_of_one(root, "free_thresh", header.free_thresh);
  if (header.free_thresh >= header.occupied_thresh) {
    root.fail("free_thresh must be below occupied_thresh");
  }
  return header;
}

std::string name_of(const std::filesystem::path& yaml_path) {
  const auto folder = std::filesystem::absolute(yaml_path).parent_path().filename();
  return yaml_path.stem() == "map" && !folder.empty() ? folder.string() : yaml_path.stem().string();
}

}  // namespace

void refuse_picture(const std::filesystem::path& path) {
  const std::string extension = to_lower(path.extension().string());
  const std::array<std::string_view, 7> kPictures{".png", ".pgm",  ".ppm", ".bmp",
                                                  ".jpg", ".jpeg", ".pnm"};
  if (std::find(kPictures.begin(), kPictures.end(), extension) == kPictures.end()) return;
  std::filesystem::path yaml = path;
  yaml.replace_extension(".yaml");
  std::error_code none;
  if (std::filesystem::exists(yaml, none)) {
    throw std::runtime_error(fmt::format("{}: is a map's picture; give its YAML file, {}",
                                         path.string(), yaml.string()));
  }
  throw std::runtime_error(fmt::format(
      "{0}: a picture alone does not say how large its cells are and where it lies; write {1} with "
      "the size of a cell [m] and the pose of the lower left corner: {{image: {2}, resolution: "
      "0.05, origin: [0.0, 0.0, 0.0], negate: 0, occupied_thresh: 0.65, free_thresh: 0.196}} and "
      "give that",
      path.string(), yaml.string(), path.filename().string()));
}

RosMap load_ros_map(const std::filesystem::path& yaml_path) {
  refuse_picture(yaml_path);
  YamlDocument document = YamlDocument::load(yaml_path);
  YamlReader root = document.root();
  const std::filesystem::path image = root.require<std::string>("image");
  const RosMapHeader header = read_header(root);
  return make_ros_map(load_gray_image(yaml_path.parent_path() / image), header, name_of(yaml_path));
}

}  // namespace castaway::testbed
