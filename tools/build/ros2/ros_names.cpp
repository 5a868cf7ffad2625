#include "tools/build/ros2/ros_names.hpp"

#include <regex>
#include <stdexcept>

namespace castaway::testbed {
namespace {

/// Parts of letters, digits and underscores that do not begin with a digit.
void require_name(const std::string& full) {
  static const std::regex kName("(/[A-Za-z_][A-Za-z0-9_]*)+");
  if (std::regex_match(full, kName) && full.find("__") == std::string::npos) return;
  throw std::invalid_argument("'" + full +
                              "' is no name of ROS 2: letters, digits and single underscores "
                              "between slashes, no part begins with a digit");
}

}  // namespace

std::string full_topic(const std::string& name_space, const std::string& name) {
  const bool is_full = name.starts_with('/');
  std::string full = is_full ? name : "/" + name;
  if (!is_full && !name_space.empty() && name_space != "/") {
    full = (name_space.starts_with('/') ? "" : "/") + name_space + full;
  }
  require_name(full);
  return full;
}

std::string refusal_sentence(const std::string& topic, const std::string& policy) {
  return "a subscriber of " + topic + " gets nothing: it asks for more " + policy +
         " than is offered";
}

std::string dds_topic_name(const std::string& full) { return "rt" + full; }

std::string dds_type_name(const std::string& type) {
  const std::size_t first = type.find('/');
  const std::size_t last = type.rfind('/');
  return type.substr(0, first) + "::msg::dds_::" + type.substr(last + 1) + "_";
}

}  // namespace castaway::testbed
