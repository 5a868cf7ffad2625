#include "tools/ros/ros_message.hpp"

#include <algorithm>

namespace castaway::testbed {

std::string short_type_name(const std::string& type) {
  const std::size_t at = type.find("/msg/");
  return at == std::string::npos ? type : type.substr(0, at) + type.substr(at + 4);
}

void RosDefinition::need(const char* type, const RosDefinition& definition) {
  const auto add = [&](const std::string& name, const std::string& fields) {
    const bool known = std::any_of(needed_.begin(), needed_.end(),
                                   [&](const auto& needed) { return needed.first == name; });
    if (!known) needed_.emplace_back(name, fields);
  };
  add(type, definition.fields_);
  for (const auto& [name, fields] : definition.needed_) add(name, fields);
}

std::string RosDefinition::text() const {
  std::string text = fields_;
  for (const auto& [type, fields] : needed_) {
    text += std::string(80, '=') + "\nMSG: " + short_type_name(type) + "\n" + fields;
  }
  return text;
}

}  // namespace castaway::testbed
