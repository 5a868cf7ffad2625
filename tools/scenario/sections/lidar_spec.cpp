#include "tools/scenario/sections/lidar_spec.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/scenario/sections/lidar_noise.hpp"
#include "tools/scenario/sections/name_spec.hpp"

namespace castaway::testbed {
namespace {

constexpr double kRadians = std::numbers::pi / 180.0;

void read_noise(YamlReader& map, LidarSpec& lidar) {
  if (!map.has("noise")) return;
  YamlReader noise = map.child("noise");
  for (const LidarNoiseKey& known : kLidarNoiseKeys) {
    const auto value = noise.get_optional<double>(known.key);
    if (value) lidar.noise[known.key] = *value;
  }
  lidar.glass = noise.get_optional<bool>("glass");
}

LidarSpec read_named_lidar(const std::string& name, YamlReader body) {
  LidarSpec lidar = read_lidar_figures(body);
  lidar.name = name;
  lidar.profile = body.get("profile", lidar.profile);
  return lidar;
}

sim::Intensity intensity_of(const std::string& name) {
  if (name == "power") return sim::Intensity::kPower;
  return name == "reflectivity" ? sim::Intensity::kReflectivity : sim::Intensity::kNone;
}

/// Beams over a field of view; the last beam of a full circle does not repeat the first.
void spread(sim::LidarConfig& lidar, const LidarSpec& spec) {
  if (spec.beams) {
    lidar.angle_increment *= static_cast<double>(lidar.beams) / *spec.beams;
    lidar.beams = *spec.beams;
  }
  if (spec.fov_deg) {
    const bool circle = *spec.fov_deg >= 360.0;
    const int gaps = circle ? lidar.beams : std::max(lidar.beams - 1, 1);
    lidar.angle_increment = *spec.fov_deg * kRadians / gaps;
    lidar.angle_min = -0.5 * *spec.fov_deg * kRadians;
  }
  if (spec.angle_min_deg) lidar.angle_min = *spec.angle_min_deg * kRadians;
}

void mount(sim::LidarConfig& lidar, const LidarSpec& spec) {
  if (spec.mount_xyz) lidar.T_base_laser.translation() = *spec.mount_xyz;
  if (!spec.mount_rpy) return;
  lidar.T_base_laser.linear() = (Eigen::AngleAxisd(spec.mount_rpy->z(), Eigen::Vector3d::UnitZ()) *
                                 Eigen::AngleAxisd(spec.mount_rpy->y(), Eigen::Vector3d::UnitY()) *
                                 Eigen::AngleAxisd(spec.mount_rpy->x(), Eigen::Vector3d::UnitX()))
                                    .toRotationMatrix();
}

void add_noise(sim::LidarConfig& lidar, const LidarSpec& spec) {
  lidar.noise.sigma = spec.range_sigma.value_or(lidar.noise.sigma);
  for (const LidarNoiseKey& known : kLidarNoiseKeys) {
    const auto found = spec.noise.find(known.key);
    if (found != spec.noise.end()) known.of(lidar) = found->second;
  }
  lidar.light.glass = spec.glass.value_or(lidar.light.glass);
}

}  // namespace

LidarSpec read_lidar_figures(YamlReader& map) {
  LidarSpec lidar;
  lidar.beams = map.get_optional<int>("beams");
  if (lidar.beams && (*lidar.beams < 1 || *lidar.beams > 100000)) {
    map.find("beams")->fail("'beams' must be 1 to 100000");
  }
  lidar.angle_min_deg = map.get_optional<double>("angle_min_deg");
  lidar.fov_deg = map.get_optional<double>("fov_deg");
  lidar.range_min = map.get_optional<double>("range_min");
  lidar.range_max = map.get_optional<double>("range_max");
  lidar.rate_hz = map.get_optional<double>("rate_hz");
  lidar.range_sigma = map.get_optional<double>("range_sigma");
  lidar.sweep = map.get_optional<bool>("sweep");
  if (map.has("elevations_deg")) {
    lidar.elevations_deg = map.require<std::vector<double>>("elevations_deg");
  }
  lidar.localize_layer = map.get_optional<int>("localize_layer");
  if (map.has("intensity")) {
    lidar.intensity = map.choice("intensity", "none", {"none", "power", "reflectivity"});
  }
  read_noise(map, lidar);
  lidar.mount_xyz = map.get_optional<Eigen::Vector3d>("mount_xyz");
  lidar.mount_rpy = map.get_optional<Eigen::Vector3d>("mount_rpy");
  return lidar;
}

LidarSpec read_lidar(YamlReader& root) { return read_named_lidar("", root.child("lidar")); }

std::vector<LidarSpec> read_lidars(YamlReader& root) {
  std::vector<LidarSpec> lidars;
  for (YamlReader item : root.list("lidars")) {
    auto [name, body] = item.named();
    require_name(item, "a lidar's name", name);
    for (const LidarSpec& other : lidars) {
      if (other.name == name) item.fail("two lidars are named '" + name + "': give other names");
    }
    lidars.push_back(read_named_lidar(name, body));
  }
  return lidars;
}

sim::LidarConfig changed(sim::LidarConfig lidar, const LidarSpec& spec) {
  if (!spec.name.empty()) lidar.name = spec.name;
  spread(lidar, spec);
  lidar.range_min = spec.range_min.value_or(lidar.range_min);
  lidar.range_max = spec.range_max.value_or(lidar.range_max);
  lidar.rate_hz = spec.rate_hz.value_or(lidar.rate_hz);
  lidar.sweep = spec.sweep.value_or(lidar.sweep);
  if (!spec.elevations_deg.empty()) lidar.elevations.clear();
  for (const double degrees : spec.elevations_deg) lidar.elevations.push_back(degrees * kRadians);
  if (spec.localize_layer) lidar.planar_layer = spec.localize_layer;
  if (spec.intensity) lidar.intensity = intensity_of(*spec.intensity);
  add_noise(lidar, spec);
  mount(lidar, spec);
  return lidar;
}

}  // namespace castaway::testbed
