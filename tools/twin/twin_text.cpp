#include "tools/twin/twin_text.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "tools/base/formats/time_list.hpp"
#include "tools/base/formats/tum.hpp"
#include "tools/twin/alignment/aligned_path.hpp"

namespace castaway::testbed {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kObjectHeight = 1.0;   // [m]
constexpr double kAfterLastScan = 0.5;  // [s]
constexpr double kLidarHeight = 0.3;    // [m] A log does not tell it.

/// A value of a key, rounded to six digits; small ones are 0.
std::string number(double value) {
  return fmt::format("{:.6g}", std::abs(value) < 1e-9 ? 0.0 : value);
}

bool holds(const Figure& figure, double value) {
  return figure.interval.low <= value && value <= figure.interval.high;
}

double not_negative(const Figure& figure) { return std::max(figure.value, 0.0); }

/// Indents every line.
std::string indent(const std::string& text) {
  std::string result;
  std::size_t from = 0;
  while (from < text.size()) {
    const std::size_t end = text.find('\n', from);
    result += "  " + text.substr(from, end - from) + "\n";
    from = end + 1;
  }
  return result;
}

/// The field of view that spreads the beams by `increment`: from the first one to the last, or, for
/// a full circle, by one increment more.
double field_of_view_deg(double increment, double beams) {
  constexpr double kFull = 359.9995;  // Becomes 360 with six digits.
  const double open = increment * (beams - 1.0);
  return open < kFull ? std::max(open, 0.001) : increment * beams;
}

std::string noise_text(const LogFit& fit) {
  std::string text = "noise:\n";
  if (fit.noise) {
    text += "  sigma_m: " + number(not_negative(fit.noise->sigma_m)) + "\n";
    text += "  sigma_relative: " + number(not_negative(fit.noise->sigma_relative)) + "\n";
    text += "  bias_m: " + number(fit.world_bias_m) + "\n";
    text += "  resolution_m: " + number(fit.noise->resolution_m) + "\n";
  } else {
    text += "  sigma_m: 0\n";
  }
  if (fit.loss) {
    text += "  dropout: " + number(not_negative(fit.loss->dropout)) + "\n";
    text += "  dropout_far: " + number(not_negative(fit.loss->dropout_far)) + "\n";
    text += "  dropout_grazing: " + number(not_negative(fit.loss->dropout_grazing)) + "\n";
  }
  if (fit.mixed && fit.mixed->divergence_deg.value > 0.0) {
    text += "  divergence_deg: " + number(fit.mixed->divergence_deg.value) + "\n";
    text += "  mixed_reach_m: " + number(fit.mixed->reach_m) + "\n";
  }
  if (fit.dust && fit.dust->per_m.interval.low > 0.0) {
    text += "  dust_per_m: " + number(fit.dust->per_m.value) + "\n";
    text += "  dust_range_m: " + number(fit.dust->range_m) + "\n";
  }
  if (fit.beam_bias && fit.beam_bias->sigma_m.interval.low > 0.0) {
    text += "  beam_bias_sigma_m: " + number(fit.beam_bias->sigma_m.value) + "\n";
  }
  return text;
}

double range_limit(const FittedLog& fitted) {
  const auto& limit = fitted.fit.range_limit;
  return limit ? limit->limit_m.value : fitted.log.scans.front().scan.range_max;
}

}  // namespace

TwinMotion motion_of(const AlignedLog& log) {
  TwinMotion motion;
  double product = 0.0;
  double square = 0.0;
  double turned = 0.0;
  for (const Leg& leg : take_legs(log, kTwinTrack)) {
    for (const OdometryStep& step : leg.steps) {
      product += step.across * step.turn;
      square += step.turn * step.turn;
      turned += std::abs(step.turn);
    }
  }
  constexpr double kFewestTurns = 3.0;  // [rad]
  if (turned > kFewestTurns) motion.axle_m = product / square;
  motion.duration_s = seconds(log.scans.back().scan.stamp - log.scans.front().scan.stamp);
  return motion;
}

SE2 axle_in_base(const FittedLog& fitted) {
  const auto& odometry = fitted.fit.odometry;
  const SE2 T_base_drive = odometry ? odometry->errors.T_base_drive : SE2{};
  return T_base_drive * SE2{-motion_of(fitted.log).axle_m, 0.0, 0.0};
}

std::string lidar_text(const FittedLog& fitted) {
  const LaserScan& scan = fitted.log.scans.front().scan;
  const SE2 T_axle_base = axle_in_base(fitted).inverse();
  const Eigen::Isometry3d T_axle_laser =
      Eigen::Translation3d(T_axle_base.x, T_axle_base.y, 0.0) *
      Eigen::AngleAxisd(T_axle_base.yaw, Eigen::Vector3d::UnitZ()) * scan.T_base_laser;
  const Eigen::Vector3d mount = T_axle_laser.translation();
  const Eigen::Matrix3d R = T_axle_laser.linear();
  const Eigen::Vector3d rpy(std::atan2(R(2, 1), R(2, 2)),
                            std::asin(std::clamp(-R(2, 0), -1.0, 1.0)),
                            std::atan2(R(1, 0), R(0, 0)));
  const auto beams = static_cast<double>(scan.ranges.size());
  const double increment = std::abs(scan.angle_increment);
  const double first = scan.angle_increment < 0.0
                           ? scan.angle_min + scan.angle_increment * (beams - 1.0)
                           : scan.angle_min;
  std::string text = "profile: ideal\n";
  text += fmt::format("beams: {}\n", scan.ranges.size());
  text += "fov_deg: " + number(field_of_view_deg(increment * kDegrees, beams)) + "\n";
  text += "angle_min_deg: " + number(first * kDegrees) + "\n";
  text += "range_min: " + number(std::max(scan.range_min, 0.0)) + "\n";
  text += "range_max: " + number(range_limit(fitted)) + "\n";
  text += "rate_hz: " + number(std::clamp(fitted.fit.stamps.rate_hz, 0.01, 1000.0)) + "\n";
  if (fitted.fit.odometry) {
    text +=
        "stamp_sigma_s: " + number(std::min(fitted.fit.odometry->stamp_sigma_s.value, 10.0)) + "\n";
  }
  text += fmt::format("sweep: {}\n", scan.time_increment != Stamp::zero());
  text += fmt::format("mount_xyz: [{}, {}, {}]\n", number(mount.x()), number(mount.y()),
                      number(mount.z() > 0.0 ? mount.z() : kLidarHeight));
  text +=
      fmt::format("mount_rpy: [{}, {}, {}]\n", number(rpy.x()), number(rpy.y()), number(rpy.z()));
  return text + noise_text(fitted.fit);
}

std::string odometry_text(const FittedLog& fitted) {
  std::string text = "profile: ideal\n";
  if (!fitted.fit.odometry) return text;
  const OdometryFit& fit = *fitted.fit.odometry;
  const auto error = [](const Figure& figure) {
    return number(std::clamp(figure.value, -0.5, 0.5));
  };
  text += "radius_error_left: " + error(fit.radius_error_left) + "\n";
  text += "radius_error_right: " + error(fit.radius_error_right) + "\n";
  text += "track_error: " + error(fit.track_error) + "\n";
  text += "drift_along: " + number(not_negative(fit.drift_along)) + "\n";
  text += "drift_yaw_deg: " + number(not_negative(fit.drift_yaw_deg)) + "\n";
  text += "drift_turn_deg: " + number(not_negative(fit.drift_turn_deg)) + "\n";
  if (fit.slip.rate_per_m.value > 0.0) {
    text +=
        fmt::format("slip: {{rate_per_m: {}, length_m: {}, share: {}}}\n",
                    number(fit.slip.rate_per_m.value), number(fit.slip.length_m), SlipFit::kShare);
  }
  if (fit.unsigned_distance) text += "unsigned_distance: true\n";
  return text;
}

std::string people_text(int count) { return fmt::format("count: {}\n", count); }

std::string differences_text(const FittedLog& fitted) {
  if (!fitted.fit.building || fitted.fit.building->standing.empty()) return "";
  std::string text = "changes:\n";
  for (const MapBox& box : fitted.fit.building->standing) {
    text += fmt::format("  - add: {{box: {{at: [{}, {}], yaw_deg: {}, size: [{}, {}, {}]}}}}\n",
                        number(box.T_map_box.x), number(box.T_map_box.y),
                        number(box.T_map_box.yaw * kDegrees), number(box.size.x()),
                        number(box.size.y()), number(kObjectHeight));
  }
  return text;
}

std::string twin_scenario(const FittedLog& fitted, int people) {
  std::string text = fmt::format(
      "# The twin of a recorded log: its path, with the models that were fitted to it.\n"
      "name: twin\n"
      "duration_s: {}\n",
      number(motion_of(fitted.log).duration_s + kAfterLastScan));
  text += "world:\n  name: world.yaml\n  map: map.yaml\n";
  text += fmt::format("robot: {}\n", kTwinRobot);
  text += "drive: {path: path.tum}\n";
  text += "lidar:\n" + indent(lidar_text(fitted));
  text += "  scan_times: scan_times.txt\n";
  text += "odometry:\n" + indent(odometry_text(fitted));
  text += "people:\n" + indent(people_text(people));
  if (fitted.fit.clock && !holds(fitted.fit.clock->offset_s, 0.0)) {
    text += fmt::format(
        "events:\n  - fault: {{kind: lidar-clock, at_s: 0, for_s: {}, offset_s: {}}}\n",
        number(motion_of(fitted.log).duration_s + 1.0), number(fitted.fit.clock->offset_s.value));
  }
  return text + "localizers: [mh_amcl, amcl]\n";
}

std::string path_text(const FittedLog& fitted) {
  const SE2 T_base_axle = axle_in_base(fitted);
  const Stamp first = fitted.log.scans.front().scan.stamp;
  std::string text;
  for (const PathPose& pose : path_of(fitted.log)) {
    text += tum_line({pose.stamp - first, pose.T_map_base * T_base_axle});
  }
  return text;
}

std::string scan_times_text(const AlignedLog& log) { return times_text(played_times(log)); }

}  // namespace castaway::testbed
