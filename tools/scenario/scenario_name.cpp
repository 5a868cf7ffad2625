#include "tools/scenario/scenario_name.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "tools/base/output/file_name.hpp"
#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {
namespace {

constexpr std::size_t kLongestLabel = 60;  // [bytes]

/// The text of a key that is a scalar or a map with `long_key`.
std::string text_at(const YamlNode& root, const std::string& key, const std::string& long_key,
                    const std::string& fallback) {
  const YamlNode* node = root.find(key);
  if (node && node->kind == YamlNode::Kind::kMap) node = node->find(long_key);
  return node && node->kind == YamlNode::Kind::kScalar ? node->scalar : fallback;
}

/// What a scenario plays, as it is written.
struct Played {
  std::string world;
  std::string robot;
};

Played played_by(const YamlNode& root) {
  return {text_at(root, "world", "name", "lab"), text_at(root, "robot", "file", "waffle")};
}

/// "burger" of /maps/burger.urdf.xacro and of models/burger/model.sdf.
std::string short_name(const std::filesystem::path& path) {
  constexpr std::array kEndings{".xacro", ".urdf", ".sdf", ".world", ".yaml", ".yml"};
  std::filesystem::path name = path.filename();
  for (const char* ending : kEndings) {
    if (name.extension() == ending) name = name.stem();
  }
  const std::string folder = path.parent_path().filename().string();
  const bool says_nothing = name == "model" || name.empty();
  return says_nothing && !folder.empty() ? folder : name.string();
}

/// "kidnap" of lab-kidnap in the world lab.
std::string without_world(const std::string& name, const std::string& world) {
  const std::string prefix = short_name(world) + "-";
  return name.starts_with(prefix) && name.size() > prefix.size() ? name.substr(prefix.size())
                                                                 : name;
}

/// True of what a shell takes without quotes.
bool is_plain(char c) {
  const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  return is_letter || (c >= '0' && c <= '9') || std::string_view("-_.,+").find(c) < 5;
}

bool sets_name(const std::string& assignment) { return assignment.starts_with("name="); }

}  // namespace

std::optional<std::string> name_of_overridden(const std::filesystem::path& scenario,
                                              const std::vector<std::string>& overrides) {
  YamlNode root = YamlDocument::load(scenario).root().copy();
  const Played before = played_by(root);
  const std::string name = text_at(root, "name", "", scenario.stem().string());
  for (const std::string& assignment : overrides) {
    if (sets_name(assignment)) return std::nullopt;
    const std::string key = assignment.substr(0, assignment.find('='));
    if (key == "world" || key == "world.name" || key == "robot" || key == "robot.file") {
      if (key == "world.name") expand_short_form(root, "world", "name");
      if (key == "robot.file") expand_short_form(root, "robot", "file");
      apply_override(root, assignment);
    }
  }
  const Played now = played_by(root);
  if (now.world == before.world && now.robot == before.robot) return std::nullopt;
  const std::string place = now.world == before.world
                                ? name
                                : short_name(now.world) + "-" + without_world(name, before.world);
  const std::string chosen =
      file_name_of(now.robot == before.robot ? place : short_name(now.robot) + "-on-" + place);
  return file_name_error(chosen).empty() ? std::optional(chosen) : std::nullopt;
}

std::string label_of(const std::vector<std::string>& overrides) {
  std::string label;
  for (std::string text : overrides) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '=' || c == ':'; }, '-');
    if (std::all_of(text.begin(), text.end(), is_plain)) label += (label.empty() ? "" : ",") + text;
  }
  return label.size() > kLongestLabel ? std::string() : label;
}

}  // namespace castaway::testbed
