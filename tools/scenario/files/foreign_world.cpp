#include "tools/scenario/files/foreign_world.hpp"

#include <array>
#include <fstream>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace castaway::testbed {
namespace {

constexpr std::size_t kHead = 65536;  // [bytes] Enough to get past a licence.

using Named = std::pair<std::string_view, std::string_view>;

constexpr std::array<Named, 5> kFirstBytes{{{"#VRML_SIM", "a world of Webots"},
                                            {"#usda", "a USD stage, as of Isaac Sim"},
                                            {"PXR-USDC", "a USD stage, as of Isaac Sim"},
                                            {"PK\x03\x04", "an archive, as USD stages are (.usdz)"},
                                            {"glTF", "a mesh (glTF)"}}};

constexpr std::array<Named, 7> kRoots{{{"mujoco", "a model of MuJoCo"},
                                       {"mvsim_world", "a world of MVSim"},
                                       {"robot", "a robot's description (URDF; see --robot)"},
                                       {"COLLADA", "a mesh (Collada)"},
                                       {"scenario", "an XML file of another simulator"},
                                       {"OpenDRIVE", "a road network (OpenDRIVE)"},
                                       {"osm", "a map of OpenStreetMap"}}};

/// The text without leading blanks.
std::string_view skip_blanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos ? std::string_view() : text.substr(first);
}

/// Name of an XML text's root; empty if it is none.
std::string_view root_of(std::string_view text) {
  for (text = skip_blanks(text); text.starts_with("<?") || text.starts_with("<!");) {
    const std::string_view end = text.starts_with("<!--") ? "-->" : ">";
    const std::size_t at = text.find(end);
    if (at == std::string_view::npos) return {};
    text = skip_blanks(text.substr(at + end.size()));
  }
  if (!text.starts_with("<")) return {};
  const std::size_t end = text.find_first_of(" \t\r\n/>", 1);
  return end == std::string_view::npos ? std::string_view() : text.substr(1, end - 1);
}

/// Takes the first line off a text.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  const std::string_view line = text.substr(0, end);
  text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
  return line;
}

std::string_view first_word(std::string_view text) {
  return text.substr(0, text.find_first_of(" \t\r\n(:"));
}

/// True for worlds of Stage: `define NAME BASE (`, and blocks in round brackets.
bool is_stage(std::string_view text) {
  while (!text.empty()) {
    const std::string_view rest = skip_blanks(text);
    const std::string_view word = first_word(rest);
    const std::string_view after = skip_blanks(rest.substr(word.size()));
    if (word == "define" && !after.empty() && after.front() != ':') return true;
    for (const std::string_view block : {"floorplan", "window", "model", "position", "ranger"}) {
      if (word == block && after.starts_with("(")) return true;
    }
    (void)take_line(text);
  }
  return false;
}

/// True for building files of RMF's traffic editor: levels of vertices, in YAML.
bool is_rmf(std::string_view text) {
  bool levels = false;
  bool parts = false;
  while (!text.empty()) {
    const std::string_view line = take_line(text);
    const std::string_view word = first_word(skip_blanks(line));
    if (line.starts_with("levels:")) levels = skip_blanks(line.substr(7)).empty();
    const bool part = word == "vertices" || word == "walls" || word == "lanes" ||
                      word == "drawing" || word == "measurements";
    parts = parts || (line.starts_with(" ") && part);
  }
  return levels && parts;
}

}  // namespace

std::optional<std::string> foreign_format(std::string_view head) {
  if (head.starts_with("\xEF\xBB\xBF")) head.remove_prefix(3);  // A byte order mark.
  for (const auto& [bytes, name] : kFirstBytes) {
    if (head.starts_with(bytes)) return std::string(name);
  }
  const std::string_view root = root_of(head);
  for (const auto& [tag, name] : kRoots) {
    if (root == tag) return std::string(name);
  }
  if (!root.empty()) return std::nullopt;
  if (is_stage(head)) return "a world of Stage";
  if (is_rmf(head)) return "a building of RMF's traffic editor";
  return std::nullopt;
}

void refuse_foreign_world(const std::filesystem::path& path) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(path, none)) return;
  std::string head(kHead, '\0');
  std::ifstream stream(path, std::ios::binary);
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(stream.gcount()));
  const auto format = foreign_format(head);
  if (!format) return;
  throw std::runtime_error(
      fmt::format("{}: {}, which is not read: a world is a world file (YAML), a ROS map (YAML with "
                  "its picture) or an SDF world of Gazebo (.sdf, .world)",
                  path.string(), *format));
}

}  // namespace castaway::testbed
