#include "sim/robot/discovery/lidar_discovery.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <sstream>

namespace castaway::sim {
namespace {

constexpr int kMinBeams = 20;
constexpr double kMinView = 0.3;  // [rad]

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

/// `<pose>x y z roll pitch yaw</pose>` of a sensor in its link.
Eigen::Isometry3d read_pose(const TiXmlElement& sensor) {
  const TiXmlElement* pose = sensor.FirstChildElement("pose");
  std::array<double, 6> v{};
  std::istringstream text(pose != nullptr && pose->GetText() != nullptr ? pose->GetText() : "");
  for (double& x : v) {
    if (!(text >> x) || !std::isfinite(x)) x = 0.0;
  }
  return Eigen::Translation3d(v[0], v[1], v[2]) *
         Eigen::AngleAxisd(v[5], Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(v[4], Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(v[3], Eigen::Vector3d::UnitX());
}

/// The link that a gazebo tag refers to: by its own name, or as the child of the named joint.
std::string referred_link(const TiXmlElement& gazebo, const UrdfFile& file) {
  const char* name = gazebo.Attribute("reference");
  if (name == nullptr) return file.model->getRoot()->name;
  const auto joint = file.model->joints_.find(name);
  return joint == file.model->joints_.end() ? name : joint->second->child_link_name;
}

bool sees_widely(const LidarSpecs& specs) {
  return specs.samples >= kMinBeams && specs.angle_max - specs.angle_min >= kMinView;
}

std::vector<LidarMount> by_sensor_tag(const UrdfFile& file, const LinkFrames& frames) {
  std::vector<LidarMount> lidars;
  const TiXmlElement& root = *file.xml->RootElement();
  for (auto* g = root.FirstChildElement("gazebo"); g != nullptr;
       g = g->NextSiblingElement("gazebo")) {
    const std::string link = referred_link(*g, file);
    if (!frames.contains(link)) continue;
    for (auto* s = g->FirstChildElement("sensor"); s != nullptr;
         s = s->NextSiblingElement("sensor")) {
      if (!is_lidar(*s) || !sees_widely(read_specs(*s))) continue;
      const char* name = s->Attribute("name");
      lidars.push_back({link, frames.at(link) * read_pose(*s), read_specs(*s),
                        name == nullptr || *name == 0 ? "sensor" : name});
    }
  }
  std::stable_partition(lidars.begin(), lidars.end(),
                        [](const LidarMount& lidar) { return lidar.specs->layers == 1; });
  return lidars;
}

bool holds_word(std::string link, const std::vector<const char*>& words) {
  std::transform(link.begin(), link.end(), link.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::any_of(words.begin(), words.end(),
                     [&link](const char* word) { return link.find(word) != std::string::npos; });
}

int distance_from_root(const urdf::ModelInterface& model, const std::string& name) {
  int distance = 0;
  for (auto link = model.getLink(name); link->parent_joint; ++distance) {
    link = model.getLink(link->parent_joint->parent_link_name);
  }
  return distance;
}

std::vector<LidarMount> by_name(const UrdfFile& file, const LinkFrames& frames) {
  std::vector<LidarMount> lidars;
  int farthest = -1;
  for (const auto& [link, T_base_link] : frames) {
    if (!holds_word(link, {"scan", "laser", "lidar", "lds", "hokuyo", "sick", "velodyne"})) {
      continue;
    }
    if (holds_word(link, {"mount", "plate", "bracket", "cable", "support", "shield"})) continue;
    const int distance = distance_from_root(*file.model, link);
    if (distance <= farthest) continue;
    farthest = distance;
    lidars = {{link, T_base_link, std::nullopt, ""}};
  }
  return lidars;
}

}  // namespace

std::vector<LidarMount> find_lidars(const UrdfFile& file, const LinkFrames& frames) {
  std::vector<LidarMount> lidars = by_sensor_tag(file, frames);
  return lidars.empty() ? by_name(file, frames) : lidars;
}

}  // namespace castaway::sim
