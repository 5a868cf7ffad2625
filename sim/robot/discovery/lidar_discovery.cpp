#include "sim/robot/discovery/lidar_discovery.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/common/xml_pose.hpp"
#include "xacro/files/lower_case.hpp"
#include "xacro/files/xml_text.hpp"

namespace castaway::sim {
namespace {

constexpr int kMinBeams = 20;
constexpr double kMinView = 0.3;     // [rad]
constexpr double kOneDevice = 0.15;  // [m]

/// The element at the end of a path of names; nullptr if there is none.
const TiXmlElement* descend(const TiXmlElement* from, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    if (from != nullptr) from = from->FirstChildElement(name);
  }
  return from;
}

std::optional<double> number(const TiXmlElement* from, std::initializer_list<const char*> names) {
  const TiXmlElement* element = descend(from, names);
  if (element == nullptr || element->GetText() == nullptr) return std::nullopt;
  const double value = std::strtod(element->GetText(), nullptr);
  return std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

bool is_lidar(const TiXmlElement& sensor) {
  const std::string type = sensor.Attribute("type") != nullptr ? sensor.Attribute("type") : "";
  return type == "ray" || type == "gpu_ray" || type == "lidar" || type == "gpu_lidar";
}

/// Reads the angles, samples and layers of `<scan>`.
void read_scan(const TiXmlElement* ray, LidarSpecs& specs) {
  const auto samples = number(ray, {"scan", "horizontal", "samples"});
  if (samples) specs.samples = static_cast<int>(std::clamp(*samples, 1.0, 100000.0));
  specs.angle_min = number(ray, {"scan", "horizontal", "min_angle"}).value_or(0.0);
  specs.angle_max = number(ray, {"scan", "horizontal", "max_angle"}).value_or(6.28319);
  const auto layers = number(ray, {"scan", "vertical", "samples"});
  if (layers) specs.layers = static_cast<int>(std::clamp(*layers, 1.0, 1024.0));
  specs.layer_min = number(ray, {"scan", "vertical", "min_angle"}).value_or(0.0);
  specs.layer_max = number(ray, {"scan", "vertical", "max_angle"}).value_or(0.0);
}

LidarSpecs read_specs(const TiXmlElement& sensor) {
  const TiXmlElement* ray = sensor.FirstChildElement("ray");
  if (ray == nullptr) ray = sensor.FirstChildElement("lidar");
  LidarSpecs specs;
  read_scan(ray, specs);
  specs.range_min = number(ray, {"range", "min"}).value_or(0.0);
  specs.range_max = number(ray, {"range", "max"}).value_or(0.0);
  specs.rate_hz = number(&sensor, {"update_rate"}).value_or(0.0);
  specs.sigma = number(ray, {"noise", "stddev"});
  return specs;
}

/// The link that a gazebo tag refers to: by its own name, or as the child of the named joint.
std::string referred_link(const TiXmlElement& gazebo, const UrdfFile& file) {
  const char* name = gazebo.Attribute("reference");
  if (name == nullptr) return file.model->getRoot()->name;
  const auto joint = file.model->joints_.find(name);
  return joint == file.model->joints_.end() ? name : joint->second->child_link_name;
}

/// Turns a scan that is described from its last angle to its first one, as Gazebo does.
void order_angles(const std::string& name, LidarSpecs& specs, std::vector<std::string>& warnings) {
  if (specs.angle_min <= specs.angle_max) return;
  warnings.push_back(
      fmt::format("sensor {}: its min_angle {:.5g} is above its max_angle {:.5g}: it sees from the "
                  "lower to the upper one",
                  name, specs.angle_min, specs.angle_max));
  std::swap(specs.angle_min, specs.angle_max);
}

bool sees_widely(const LidarSpecs& specs) {
  return specs.samples >= kMinBeams && specs.angle_max - specs.angle_min >= kMinView;
}

/// The lidar that a sensor describes; nothing, with a warning, for a range finder.
std::optional<LidarMount> described_lidar(const TiXmlElement& sensor, const std::string& link,
                                          const LinkFrames& frames,
                                          std::vector<std::string>& warnings) {
  const std::string given = attribute(sensor, "name");
  const std::string name = given.empty() ? "sensor" : given;
  if (!frames.contains(link)) {
    warnings.push_back(
        fmt::format("sensor {}: left out, since no link is called '{}'", name, link));
    return std::nullopt;
  }
  LidarSpecs specs = read_specs(sensor);
  order_angles(name, specs, warnings);
  if (!sees_widely(specs)) {
    warnings.push_back(
        fmt::format("sensor {}: left out, since {} beams over {:.2f} rad are a range finder: a "
                    "lidar has at least {} over {} rad",
                    name, specs.samples, specs.angle_max - specs.angle_min, kMinBeams, kMinView));
    return std::nullopt;
  }
  return LidarMount{link, frames.at(link) * child_pose(sensor), specs, name};
}

std::vector<LidarMount> by_sensor_tag(const UrdfFile& file, const LinkFrames& frames,
                                      std::vector<std::string>& warnings) {
  std::vector<LidarMount> lidars;
  const TiXmlElement& root = *file.xml->RootElement();
  for (auto* g = root.FirstChildElement("gazebo"); g != nullptr;
       g = g->NextSiblingElement("gazebo")) {
    const std::string link = referred_link(*g, file);
    for (auto* s = g->FirstChildElement("sensor"); s != nullptr;
         s = s->NextSiblingElement("sensor")) {
      if (!is_lidar(*s)) continue;
      const auto lidar = described_lidar(*s, link, frames, warnings);
      if (lidar) lidars.push_back(*lidar);
    }
  }
  std::stable_partition(lidars.begin(), lidars.end(),
                        [](const LidarMount& lidar) { return lidar.specs->layers == 1; });
  return lidars;
}

bool is_called_lidar(const std::string& link) {
  return holds_word(link, {"scan", "laser", "lidar", "lds", "hokuyo", "sick", "velodyne"}) &&
         !holds_word(link, {"mount", "plate", "bracket", "cable", "support", "shield"});
}

/// The links from the parent of a link to the root.
std::vector<std::string> ancestors(const urdf::ModelInterface& model, const std::string& name) {
  std::vector<std::string> names;
  for (auto link = model.getLink(name); link->parent_joint; names.push_back(link->name)) {
    link = model.getLink(link->parent_joint->parent_link_name);
  }
  return names;
}

/// Links that are called like lidars and hold no other one, the farthest from the root first.
std::vector<std::string> links_of_lidars(const UrdfFile& file, const LinkFrames& frames) {
  std::set<std::string> holders;
  std::vector<std::pair<std::size_t, std::string>> links;
  for (const auto& [link, T_base_link] : frames) {
    if (!is_called_lidar(link)) continue;
    const std::vector<std::string> above = ancestors(*file.model, link);
    links.emplace_back(above.size(), link);
    holders.insert(above.begin(), above.end());
  }
  std::stable_sort(links.begin(), links.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::string> names;
  for (const auto& [distance, link] : links) {
    if (!holders.contains(link)) names.push_back(link);
  }
  return names;
}

/// All lidars that are known by their links' names; links nearby are parts of one device.
std::vector<LidarMount> by_name(const UrdfFile& file, const LinkFrames& frames,
                                std::vector<std::string>& warnings) {
  std::vector<LidarMount> lidars;
  std::vector<std::string> names;
  for (const std::string& link : links_of_lidars(file, frames)) {
    const Eigen::Isometry3d& T_base_link = frames.at(link);
    const bool known = std::any_of(lidars.begin(), lidars.end(), [&](const LidarMount& lidar) {
      const Eigen::Vector3d to = lidar.T_base_laser.translation() - T_base_link.translation();
      return to.norm() < kOneDevice;
    });
    if (known) continue;
    lidars.push_back({link, T_base_link, std::nullopt, ""});
    names.push_back(link);
  }
  if (lidars.size() > 1) {
    warnings.push_back(fmt::format(
        "no <sensor> describes a lidar: {} links are taken for lidars by their names: {}",
        lidars.size(), fmt::join(names, ", ")));
  }
  return lidars;
}

}  // namespace

std::vector<LidarMount> find_lidars(const UrdfFile& file, const LinkFrames& frames,
                                    std::vector<std::string>& warnings) {
  std::vector<LidarMount> lidars = by_sensor_tag(file, frames, warnings);
  return lidars.empty() ? by_name(file, frames, warnings) : lidars;
}

}  // namespace castaway::sim
