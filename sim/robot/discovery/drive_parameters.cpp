#include "sim/robot/discovery/drive_parameters.hpp"

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

}  // namespace

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

void add_controller_types(const Value& parameters, DriveTags& tags) {
  const auto* dict = std::get_if<Dict>(&parameters.data);
  if (dict == nullptr) return;
  for (const auto& entry : *dict) {
    const bool type = entry.key == "type" && std::holds_alternative<std::string>(entry.value.data);
    if (type) tags.controllers.push_back(to_text(entry.value));
    add_controller_types(entry.value, tags);
  }
}

}  // namespace castaway::sim
