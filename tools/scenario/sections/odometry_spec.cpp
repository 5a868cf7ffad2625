#include "tools/scenario/sections/odometry_spec.hpp"

namespace castaway::testbed {
namespace {

void read_slip(YamlReader& map, OdometrySpec& odometry) {
  if (!map.has("slip")) return;
  YamlReader slip = map.child("slip");
  for (const SlipKey& known : kSlipKeys) {
    const auto value = slip.get_optional<double>(known.key);
    if (value) odometry.slip[known.key] = *value;
  }
  odometry.slip_zones = slip.get_optional<bool>("zones");
}

void read_gyro(YamlReader& map, OdometrySpec& odometry) {
  if (!map.has("gyro")) return;
  YamlReader gyro = map.child("gyro");
  sim::GyroConfig config;
  config.noise_deg = gyro.get("noise_deg", config.noise_deg);
  config.bias_deg_s = gyro.get("bias_deg_s", config.bias_deg_s);
  config.bias_walk_deg_s = gyro.get("bias_walk_deg_s", config.bias_walk_deg_s);
  config.scale_sigma = gyro.get("scale_sigma", config.scale_sigma);
  odometry.gyro = config;
}

}  // namespace

OdometrySpec read_odometry(YamlReader& root) {
  OdometrySpec odometry;
  YamlReader map = root.child("odometry");
  odometry.profile = map.choice("profile", odometry.profile, kOdometryProfiles);
  odometry.ticks_per_turn = map.get_optional<int>("ticks_per_turn");
  odometry.radius_sigma = map.get_optional<double>("radius_sigma");
  odometry.track_sigma = map.get_optional<double>("track_sigma");
  odometry.drift_along = map.get_optional<double>("drift_along");
  odometry.drift_yaw_deg = map.get_optional<double>("drift_yaw_deg");
  read_slip(map, odometry);
  read_gyro(map, odometry);
  return odometry;
}

}  // namespace castaway::testbed
