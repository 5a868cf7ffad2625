#include "tools/scenario/sections/lidar_yaml.hpp"

#include <algorithm>
#include <numbers>

#include "tools/scenario/sections/name_yaml.hpp"

namespace castaway::testbed {
namespace {

constexpr double kRadians = std::numbers::pi / 180.0;

LidarSpec read_named_lidar(const std::string& name, YamlReader body) {
  LidarSpec lidar;
  lidar.name = name;
  lidar.changes = read_lidar_changes(body);
  lidar.profile = body.get("profile", lidar.profile);
  lidar.scan_times = body.get_optional<std::string>("scan_times").value_or("");
  return lidar;
}

/// Changes the number of beams over the same field of view.
void resample(int beams, sim::LidarConfig& lidar) {
  lidar.angle_increment *= static_cast<double>(lidar.beams) / beams;
  lidar.beams = beams;
}

/// Spreads the beams over a field of view centred ahead; the last beam of a full circle does not
/// repeat the first.
void spread_beams(double fov_deg, sim::LidarConfig& lidar) {
  const int gaps = fov_deg >= 360.0 ? lidar.beams : std::max(lidar.beams - 1, 1);
  lidar.angle_increment = fov_deg * kRadians / gaps;
  lidar.angle_min = -0.5 * fov_deg * kRadians;
}

Eigen::Matrix3d rotation(const Eigen::Vector3d& rpy) {
  return (Eigen::AngleAxisd(rpy.z(), Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(rpy.y(), Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(rpy.x(), Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

void angle_fields(Settings& settings, sim::LidarConfig& lidar) {
  int beams = lidar.beams;
  double fov_deg = lidar.angle_increment * lidar.beams / kRadians;
  double angle_min_deg = lidar.angle_min / kRadians;
  std::vector<double> elevations_deg;
  for (const double elevation : lidar.elevations) elevations_deg.push_back(elevation / kRadians);
  if (settings.field({"beams", "", "Number of beams per layer.", {1.0, 1e5}}, beams))
    resample(beams, lidar);
  if (settings.field({"fov_deg",
                      "deg",
                      "Field of view ahead, from the first beam to the last.",
                      {1e-3, 720.0}},
                     fov_deg)) {
    spread_beams(fov_deg, lidar);
  }
  if (settings.field({"angle_min_deg", "deg", "Direction of the first beam.", {-720.0, 720.0}},
                     angle_min_deg)) {
    lidar.angle_min = angle_min_deg * kRadians;
  }
  if (settings.field(
          {"elevations_deg", "deg", "Elevations of the layers of a 3-D lidar.", {-90.0, 90.0}},
          elevations_deg)) {
    lidar.elevations.clear();
    for (const double degrees : elevations_deg) lidar.elevations.push_back(degrees * kRadians);
  }
  settings.optional({"localize_layer",
                     "",
                     "Layer for the localizers; by default, the most level one.",
                     {0.0, 1e4}},
                    lidar.planar_layer);
}

constexpr NumberRange kNoiseRange{-1e4, 1e4};

void fields(Settings settings, sim::RangeNoise& noise) {
  const auto field = [&](const char* key, const char* unit, const char* what, double& value) {
    settings.field({key, unit, what, kNoiseRange}, value);
  };
  field("sigma_m", "m", "Standard deviation of a range at range 0.", noise.sigma);
  field("sigma_relative", "m/m", "Increase of this standard deviation per metre of range.",
        noise.sigma_relative);
  field("bias_m", "m", "Bias of every range.", noise.bias);
  field("beam_bias_sigma_m", "m", "Standard deviation of an offset that each beam keeps.",
        noise.beam_bias_sigma);
  field("resolution_m", "m", "Ranges are rounded to multiples of it; 0: they are not.",
        noise.resolution);
}

void fields(Settings settings, sim::LightEffects& light) {
  const auto field = [&](const char* key, const char* unit, const char* what, double& value) {
    settings.field({key, unit, what, kNoiseRange}, value);
  };
  field("dark_range_m", "m",
        "Range at which a surface of reflectivity 0.1 is just seen at normal incidence; 0: all "
        "surfaces are seen.",
        light.dark_range);
  field("dropout", "", "Share of the returns that are lost.", light.dropout);
  field("dropout_far", "", "Share lost besides at range_max; grows with the square of range.",
        light.dropout_far);
  field("dropout_grazing", "", "Share lost besides at grazing incidence.", light.dropout_grazing);
  field("dropout_dark", "", "Share lost besides on black surfaces.", light.dropout_dark);
  field("dust_per_m", "1/m", "Grains or drops in a metre of beam that return it.", light.dust_rate);
  field("dust_range_m", "m", "Farther grains return too little light.", light.dust_range);
  field("divergence_deg", "deg", "Full opening of a beam; 0: no mixed pixels.",
        light.divergence_deg);
  field("mixed_reach_m", "m", "Smaller depth steps within a beam are reported as one range.",
        light.mixed_reach);
  settings.field({"glass", "", "Light passes glass."}, light.glass);
  field("glass_return", "", "Share of beams that a pane mirrors back at normal incidence.",
        light.glass_return);
  field("glass_angle_deg", "deg", "A pane mirrors beams back within this angle off its normal.",
        light.glass_angle_deg);
}

void mount_fields(Settings& settings, sim::LidarConfig& lidar) {
  Eigen::Vector3d xyz = lidar.T_base_laser.translation();
  Eigen::Vector3d rpy = Eigen::Vector3d::Zero();
  if (settings.field({"mount_xyz", "m", "Position of the laser in base.", {-100.0, 100.0}}, xyz)) {
    lidar.T_base_laser.translation() = xyz;
  }
  if (settings.field(
          {"mount_rpy", "rad", "Roll, pitch, yaw of the laser in base.", {-100.0, 100.0}}, rpy)) {
    lidar.T_base_laser.linear() = rotation(rpy);
  }
}

}  // namespace

void fields(Settings settings, sim::LidarConfig& lidar) {
  using sim::Intensity;
  angle_fields(settings, lidar);
  settings.field({"range_min", "m", "Shorter returns are reported as -inf.", {0.0, 1e4}},
                 lidar.range_min);
  settings.field({"range_max", "m", "Longer returns are reported as +inf.", {1e-3, 1e4}},
                 lidar.range_max);
  settings.field({"rate_hz", "Hz", "Rotations per second.", {0.01, 1000.0}}, lidar.rate_hz);
  settings.field(
      {"stamp_sigma_s", "s", "Standard deviation of the error of a scan's stamp.", {0.0, 10.0}},
      lidar.stamp_sigma);
  settings.field({"sweep", "", "Each beam at its own time; false: all at the scan's stamp."},
                 lidar.sweep);
  settings.choice({"intensity", "", "Quantity that the intensities represent."}, lidar.intensity,
                  {{"none", Intensity::kNone},
                   {"power", Intensity::kPower},
                   {"reflectivity", Intensity::kReflectivity}});
  settings.field({"range_sigma", "m", "Short form of noise.sigma_m.", {0.0, 1000.0}},
                 lidar.noise.sigma);
  fields(settings.group("noise"), lidar.noise);
  fields(settings.group("noise"), lidar.light);
  mount_fields(settings, lidar);
}

YamlNode read_lidar_changes(YamlReader& map) {
  sim::LidarConfig scratch;
  fields(Settings::changing(map), scratch);
  return map.copy();
}

std::vector<LidarSpec> read_lidars(YamlReader& root) {
  std::vector<LidarSpec> lidars;
  for (YamlReader item : root.list("lidars")) {
    auto [name, body] = item.name_and_body();
    require_name(item, "a lidar's name", name);
    for (const LidarSpec& other : lidars) {
      if (other.name == name) item.fail("two lidars are named '" + name + "': give other names");
    }
    lidars.push_back(read_named_lidar(name, body));
  }
  if (lidars.empty()) lidars.push_back(read_named_lidar("", root.child("lidar")));
  return lidars;
}

sim::LidarConfig apply_changes(sim::LidarConfig lidar, const YamlNode& changes) {
  YamlNode copy = changes;
  fields(Settings::changing({copy, "lidar"}), lidar);
  return lidar;
}

}  // namespace castaway::testbed
