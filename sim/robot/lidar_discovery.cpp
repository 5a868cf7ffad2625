#include "sim/robot/lidar_discovery.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <initializer_list>
#include <sstream>

namespace castaway::sim {
namespace {

/// The element at the end of a path of names; null if there is none.
const TiXmlElement* descend(const TiXmlElement* from, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    if (from != nullptr) from = from->FirstChildElement(name);
  }
  return from;
}

std::optional<double> number(const TiXmlElement* from, std::initializer_list<const char*> names) {
  const TiXmlElement* element = descend(from, names);
  if (element == nullptr || element->GetText() == nullptr) return std::nullopt;
  return std::strtod(element->GetText(), nullptr);
}

bool is_lidar(const TiXmlElement& sensor) {
  const std::string type = sensor.Attribute("type") != nullptr ? sensor.Attribute("type") : "";
  return type == "ray" || type == "gpu_ray" || type == "lidar" || type == "gpu_lidar";
}

LidarSpecs read_specs(const TiXmlElement& sensor) {
  const TiXmlElement* ray = sensor.FirstChildElement("ray");
  if (ray == nullptr) ray = sensor.FirstChildElement("lidar");
  LidarSpecs specs;
  const auto samples = number(ray, {"scan", "horizontal", "samples"});
  if (samples) specs.samples = std::max(1, static_cast<int>(*samples));
  specs.angle_min = number(ray, {"scan", "horizontal", "min_angle"}).value_or(0.0);
  specs.angle_max = number(ray, {"scan", "horizontal", "max_angle"}).value_or(6.28319);
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
  for (double& x : v) text >> x;
  return Eigen::Translation3d(v[0], v[1], v[2]) *
         Eigen::AngleAxisd(v[5], Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(v[4], Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(v[3], Eigen::Vector3d::UnitX());
}

std::optional<LidarMount> by_sensor_tag(const UrdfFile& file, const LinkFrames& frames) {
  const TiXmlElement& root = *file.xml->RootElement();
  for (auto* g = root.FirstChildElement("gazebo"); g != nullptr;
       g = g->NextSiblingElement("gazebo")) {
    const char* link = g->Attribute("reference");
    if (link == nullptr || !frames.contains(link)) continue;
    for (auto* s = g->FirstChildElement("sensor"); s != nullptr;
         s = s->NextSiblingElement("sensor")) {
      if (is_lidar(*s)) return LidarMount{link, frames.at(link) * read_pose(*s), read_specs(*s)};
    }
  }
  return std::nullopt;
}

bool sounds_like_lidar(std::string link) {
  std::transform(link.begin(), link.end(), link.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const std::array<const char*, 4> words{"scan", "laser", "lidar", "lds"};
  return std::any_of(words.begin(), words.end(),
                     [&link](const char* word) { return link.find(word) != std::string::npos; });
}

}  // namespace

std::optional<LidarMount> find_lidar(const UrdfFile& file, const LinkFrames& frames) {
  if (auto mount = by_sensor_tag(file, frames)) return mount;
  for (const auto& [link, T_base_link] : frames) {
    if (sounds_like_lidar(link)) return LidarMount{link, T_base_link, std::nullopt};
  }
  return std::nullopt;
}

}  // namespace castaway::sim
