#include "tools/scenario/sections/odometry_yaml.hpp"

#include <stdexcept>

#include "sim/sensor/odometry_profiles.hpp"

namespace castaway::testbed {
namespace {

void fields(Settings settings, sim::SlipConfig& slip) {
  settings.field(
      {"rate_per_m", "1/m", "Number of slips per metre that a wheel rolls.", {0.0, 1000.0}},
      slip.rate);
  settings.field({"length_m", "m", "Rolled distance of one slip.", {0.0, 1000.0}}, slip.length);
  settings.field({"share", "", "Mean share of that distance that is lost.", {0.0, 1.0}},
                 slip.share);
  settings.field(
      {"collision_length_m", "m", "Distance lost by both wheels in a collision.", {0.0, 1000.0}},
      slip.collision_length);
  settings.field({"zones", "", "Wheels slip in the world's slip zones."}, slip.zones);
  settings.field({"zone_spread", "", "Relative variation of the slip in a zone.", {0.0, 100.0}},
                 slip.zone_spread);
}

void fields(Settings settings, sim::GyroConfig& gyro) {
  constexpr NumberRange kRange{0.0, 360.0};
  settings.field({"noise_deg", "deg/sqrt(s)", "Random walk of the angle.", kRange}, gyro.noise_deg);
  settings.field(
      {"bias_deg_s", "deg/s", "Standard deviation of the bias left by calibration.", kRange},
      gyro.bias_deg_s);
  settings.field({"bias_walk_deg_s", "deg/s/sqrt(s)", "Random walk of the bias.", kRange},
                 gyro.bias_walk_deg_s);
  settings.field({"scale_sigma", "", "Relative error of every turn, drawn once.", kRange},
                 gyro.scale_sigma);
}

}  // namespace

void fields(Settings settings, sim::OdometryConfig& odometry) {
  settings.field({"ticks_per_turn", "", "Encoder resolution; 0: continuous.", {0.0, 1e9}},
                 odometry.ticks_per_turn);
  settings.field(
      {"radius_sigma", "", "Relative error of each wheel's radius, drawn once.", {0.0, 1.0}},
      odometry.radius_sigma);
  settings.field({"track_sigma", "", "Relative error of the track, drawn once.", {0.0, 1.0}},
                 odometry.track_sigma);
  constexpr NumberRange kError{-0.5, 0.5};
  settings.field(
      {"radius_error_left", "", "Relative error of the left wheel's radius, besides.", kError},
      odometry.radius_error_left);
  settings.field(
      {"radius_error_right", "", "Relative error of the right wheel's radius, besides.", kError},
      odometry.radius_error_right);
  settings.field({"track_error", "", "Relative error of the track, besides.", kError},
                 odometry.track_error);
  settings.field({"drift_along", "m/sqrt(m)", "Random walk along the heading.", {0.0, 10.0}},
                 odometry.drift_along);
  settings.field(
      {"drift_yaw_deg", "deg/sqrt(m)", "Random walk of the heading by travel.", {0.0, 360.0}},
      odometry.drift_yaw_deg);
  settings.field(
      {"drift_turn_deg", "deg/sqrt(rad)", "Random walk of the heading by turn.", {0.0, 360.0}},
      odometry.drift_turn_deg);
  settings.field({"unsigned_distance", "", "Reversing is counted as driving ahead."},
                 odometry.unsigned_distance);
  fields(settings.group("slip"), odometry.slip);
  if (settings.has("gyro")) odometry.gyro = sim::GyroConfig{};
  if (odometry.gyro) fields(settings.group("gyro"), *odometry.gyro);
}

sim::OdometryConfig read_odometry(YamlReader& root) {
  YamlReader map = root.child("odometry");
  const std::string profile = map.choice("profile", "default", sim::odometry_profile_names());
  sim::OdometryConfig odometry = sim::odometry_profile(profile).value();
  fields(Settings::reading(map), odometry);
  try {
    sim::validate(odometry);
  } catch (const std::invalid_argument& error) {
    map.fail(error.what());
  }
  return odometry;
}

void fields(Settings settings, sim::ImuConfig& imu) {
  constexpr NumberRange kError{0.0, 100.0};
  settings.field({"rate_hz", "Hz", "Rate of readings.", {1e-3, 1000.0}}, imu.rate_hz);
  settings.field({"accel_noise", "m/s^2", "Noise of the specific force, each axis.", kError},
                 imu.accel_noise);
  settings.field({"accel_bias", "m/s^2", "Standard deviation of its bias, drawn once.", kError},
                 imu.accel_bias);
  settings.field({"gyro_noise_deg", "deg/s", "Noise of the rates, each axis.", kError},
                 imu.gyro_noise_deg);
  settings.field(
      {"gyro_bias_deg", "deg/s", "Standard deviation of their bias, drawn once.", kError},
      imu.gyro_bias_deg);
}

std::optional<sim::ImuConfig> read_imu(YamlReader& root) {
  const std::optional<YamlReader> found = root.find("imu");
  if (!found) return std::nullopt;
  sim::ImuConfig imu;
  if (found->is_scalar()) return found->as<bool>() ? std::optional(imu) : std::nullopt;
  YamlReader map = root.child("imu");
  fields(Settings::reading(map), imu);
  return imu;
}

}  // namespace castaway::testbed
