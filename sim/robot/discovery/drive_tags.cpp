#include "sim/robot/discovery/drive_tags.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <stdexcept>

namespace castaway::sim {
namespace {

using xacro::Dict;
using xacro::find_key;
using xacro::Value;

const Value* first_key(const Dict& dict, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    if (const Value* value = find_key(dict, name)) return value;
  }
  return nullptr;
}

/// A single name as a list, or a list of names.
std::vector<std::string> names_of(const Value* value) {
  std::vector<std::string> names;
  if (value == nullptr) return names;
  if (const auto* list = std::get_if<xacro::List>(&value->data)) {
    for (const Value& item : *list) names.push_back(to_text(item));
  } else {
    names.push_back(to_text(*value));
  }
  return names;
}

void set_number(const Value* value, std::optional<double>& number) {
  if (value == nullptr || number || !is_number(*value)) return;
  if (to_double(*value) > 0.0) number = to_double(*value);
}

/// The dictionary of a differential drive's parameters; nullptr if there is none.
const Dict* find_drive(const Value& value) {
  const auto* dict = std::get_if<Dict>(&value.data);
  if (dict == nullptr) return nullptr;
  if (first_key(*dict, {"left_wheel_names", "left_wheel", "wheel_separation"}) != nullptr) {
    return dict;
  }
  for (const auto& entry : *dict) {
    if (const Dict* found = find_drive(entry.value)) return found;
  }
  return nullptr;
}

/// Adds joints, separation and radius from the first dictionary in a parameter file, at any depth,
/// that has `left_wheel_names` (ROS 1: `left_wheel`) or `wheel_separation`. Values that `tags`
/// already has are kept.
void add_drive_parameters(const Value& parameters, DriveTags& tags) {
  const Dict* drive = find_drive(parameters);
  if (drive == nullptr) return;
  if (tags.left.empty() && tags.right.empty()) {
    tags.left = names_of(first_key(*drive, {"left_wheel_names", "left_wheel"}));
    tags.right = names_of(first_key(*drive, {"right_wheel_names", "right_wheel"}));
    if (tags.dialect.empty() && !tags.left.empty()) tags.dialect = "ros2_control";
  }
  set_number(find_key(*drive, "wheel_separation"), tags.separation);
  set_number(find_key(*drive, "wheel_radius"), tags.radius);
}

/// Adds the types of all controllers in a parameter file.
void add_controller_types(const Value& parameters, DriveTags& tags) {
  const auto* dict = std::get_if<Dict>(&parameters.data);
  if (dict == nullptr) return;
  for (const auto& entry : *dict) {
    const bool type = entry.key == "type" && std::holds_alternative<std::string>(entry.value.data);
    if (type) tags.controllers.push_back(to_text(entry.value));
    add_controller_types(entry.value, tags);
  }
}

using Visit = std::function<void(const TiXmlElement&)>;

/// Calls `visit` for all elements of a name below another one.
void for_each(const TiXmlElement& from, const std::string& name, const Visit& visit) {
  for (auto* e = from.FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
    if (e->ValueStr() == name) visit(*e);
    for_each(*e, name, visit);
  }
}

std::string trim(const char* text) {
  const std::string all = text == nullptr ? "" : text;
  const std::size_t first = all.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return "";
  return all.substr(first, all.find_last_not_of(" \t\r\n") - first + 1);
}

std::string trimmed_attribute(const TiXmlElement& element, const char* name) {
  return trim(element.Attribute(name));
}

template <std::size_t N>
bool one_of(const std::string& text, const std::array<const char*, N>& names) {
  return std::find(names.begin(), names.end(), text) != names.end();
}

constexpr std::array<const char*, 8> kLeft{
    "leftJoint",  "leftFrontJoint",        "leftRearJoint",    "left_joint",
    "left_wheel", "left_wheel_joint_name", "left_front_joint", "left_rear_joint"};
constexpr std::array<const char*, 8> kRight{
    "rightJoint",  "rightFrontJoint",        "rightRearJoint",    "right_joint",
    "right_wheel", "right_wheel_joint_name", "right_front_joint", "right_rear_joint"};
constexpr std::array<const char*, 2> kSeparation{"wheelSeparation", "wheel_separation"};
constexpr std::array<const char*, 2> kDiameter{"wheelDiameter", "wheel_diameter"};
constexpr std::array<const char*, 2> kRadiusTags{"wheelRadius", "wheel_radius"};

std::optional<double> positive(const std::string& text) {
  const xacro::Value value = xacro::from_literal(text);
  if (!xacro::is_number(value) || xacro::to_double(value) <= 0.0) return std::nullopt;
  return xacro::to_double(value);
}

std::string dialect_of(const TiXmlElement& plugin, const std::string& joint_tag) {
  const std::string names =
      trimmed_attribute(plugin, "filename") + " " + trimmed_attribute(plugin, "name");
  for (const char* hint : {"diff-drive", "gz::sim", "gazebo::systems"}) {
    if (names.find(hint) != std::string::npos) return "gz-sim";
  }
  const bool camel = joint_tag.find("Joint") != std::string::npos;
  return camel ? "gazebo-classic" : "gazebo-ros2";
}

/// The drive of a plug-in that names joints on both sides; otherwise its dialect is empty.
DriveTags of_plugin(const TiXmlElement& plugin) {
  DriveTags tags;
  std::string joint_tag;
  for (auto* e = plugin.FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
    const std::string& tag = e->ValueStr();
    const std::string text = trim(e->GetText());
    if (one_of(tag, kLeft)) {
      tags.left.push_back(text);
      joint_tag = tag;
    }
    if (one_of(tag, kRight)) tags.right.push_back(text);
    if (one_of(tag, kSeparation)) tags.separation = positive(text);
    if (one_of(tag, kRadiusTags)) tags.radius = positive(text);
    if (one_of(tag, kDiameter) && positive(text)) tags.radius = 0.5 * *positive(text);
  }
  if (!tags.left.empty() && !tags.right.empty()) tags.dialect = dialect_of(plugin, joint_tag);
  return tags;
}

/// Joints with a velocity command interface.
std::vector<std::string> velocity_joints(const TiXmlElement& root) {
  std::vector<std::string> joints;
  for_each(root, "ros2_control", [&](const TiXmlElement& control) {
    for_each(control, "joint", [&](const TiXmlElement& joint) {
      for_each(joint, "command_interface", [&](const TiXmlElement& interface) {
        if (trimmed_attribute(interface, "name") == "velocity")
          joints.push_back(trimmed_attribute(joint, "name"));
      });
    });
  });
  return joints;
}

std::vector<std::string> transmission_joints(const TiXmlElement& root) {
  std::vector<std::string> joints;
  for_each(root, "transmission", [&](const TiXmlElement& transmission) {
    bool velocity = false;
    for_each(transmission, "hardwareInterface", [&](const TiXmlElement& interface) {
      velocity = velocity || trim(interface.GetText()).find("Velocity") != std::string::npos;
    });
    for_each(transmission, "joint", [&](const TiXmlElement& joint) {
      if (velocity) joints.push_back(trimmed_attribute(joint, "name"));
    });
  });
  return joints;
}

/// Adds what the plug-ins' parameter files tell: controllers and, unless a plug-in names the
/// joints, the parameters of a differential drive.
void add_parameters(const UrdfFile& file, const PackageFinder& packages,
                    const xacro::Options& options, DriveTags& tags) {
  if (!options.read_yaml) return;
  const bool named = !tags.left.empty();
  for_each(*file.xml->RootElement(), "parameters", [&](const TiXmlElement& e) {
    std::filesystem::path path = trim(e.GetText());
    if (path.is_relative()) path = std::filesystem::path(file.path).parent_path() / path;
    std::error_code none;
    if (!packages.may_read(path) || !std::filesystem::is_regular_file(path, none)) return;
    try {
      const xacro::Value parameters = options.read_yaml(path.string());
      add_controller_types(parameters, tags);
      if (!named) add_drive_parameters(parameters, tags);
    } catch (const std::runtime_error&) {
      return;  // No error: the drive is known without it.
    }
  });
}

}  // namespace

DriveTags find_drive_tags(const UrdfFile& file, const PackageFinder& packages,
                          const xacro::Options& options) {
  const TiXmlElement& root = *file.xml->RootElement();
  DriveTags tags;
  for_each(root, "plugin", [&](const TiXmlElement& plugin) {
    if (tags.dialect.empty()) tags = of_plugin(plugin);
  });
  if (!tags.dialect.empty()) {
    add_parameters(file, packages, options, tags);
    return tags;
  }
  tags = {};
  tags.driven = velocity_joints(root);
  if (!tags.driven.empty()) tags.dialect = "ros2_control";
  if (tags.dialect.empty()) {
    tags.driven = transmission_joints(root);
    if (!tags.driven.empty()) tags.dialect = "transmission";
  }
  add_parameters(file, packages, options, tags);
  return tags;
}

}  // namespace castaway::sim
