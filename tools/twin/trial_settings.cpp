#include "tools/twin/trial_settings.hpp"

#include <array>
#include <numbers>

#include <fmt/format.h>
#include <boost/random/uniform_real_distribution.hpp>

#include "localization/geometry/random.hpp"

namespace castaway::testbed {
namespace {

constexpr const char* kTrialRobot = "butler";
constexpr std::array kTrialWorlds = {"office", "warehouse", "lab", "home"};

double draw(double low, double high, localization::Rng& rng) {
  return boost::random::uniform_real_distribution<double>(low, high)(rng);
}

/// A value of either sign.
double draw_signed(double least, double most, localization::Rng& rng) {
  const double sign = draw(-1.0, 1.0, rng) < 0.0 ? -1.0 : 1.0;
  return sign * draw(least, most, rng);
}

/// Settings of errors that not every robot has.
void draw_rare(int index, localization::Rng& rng, TrialSettings& s) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  if (index % 2 == 1) {
    s.drift_yaw_deg = 0.0;
    s.drift_turn_deg = draw(1.0, 4.0, rng);
  }
  if (index % 3 == 1) s.stamp_sigma_s = draw(0.01, 0.025, rng);  // A quarter of the period.
  if (index % 4 == 2) s.beam_bias_sigma_m = draw(0.005, 0.02, rng);
  if (index % 4 == 3) s.dust_per_m = draw(0.002, 0.02, rng);
  const double x = draw_signed(0.03, 0.12, rng);
  const double y = draw_signed(0.02, 0.08, rng);
  s.mount = {x, y, kDegree * draw_signed(1.0, 3.0, rng)};
}

}  // namespace

TrialSettings draw_settings(std::uint64_t seed, int index) {
  localization::Rng rng = localization::substream(seed, fmt::format("calibration/{}", index));
  TrialSettings s;
  s.world = kTrialWorlds[static_cast<std::size_t>(index) % kTrialWorlds.size()];
  s.radius_error_left = draw_signed(0.02, 0.06, rng);
  s.radius_error_right = draw_signed(0.02, 0.06, rng);
  s.track_error = draw_signed(0.03, 0.10, rng);
  s.drift_along = draw(0.01, 0.03, rng);
  s.drift_yaw_deg = draw(0.3, 1.5, rng);
  s.sigma_m = draw(0.003, 0.03, rng);
  s.sigma_relative = draw(0.0, 0.01, rng);
  s.resolution_m = index % 3 == 0 ? 0.01 : 0.0;
  s.dropout = draw(0.01, 0.1, rng);
  s.dropout_far = draw(0.05, 0.4, rng);
  s.dropout_grazing = draw(0.05, 0.5, rng);
  s.offset_s = draw(-0.08, 0.08, rng);
  s.people = static_cast<int>(draw(3.0, 13.0, rng));
  draw_rare(index, rng, s);
  return s;
}

std::string trial_scenario(const TrialSettings& s, double duration_s) {
  return fmt::format(
      "world: {}\nrobot: {}\nphysics: kinematic\nduration_s: {}\ndrive: {{route: explore}}\n"
      "lidar: {{profile: ideal, beams: 360, fov_deg: 359, angle_min_deg: -180, range_max: 12, "
      "range_min: 0.1, rate_hz: 10, stamp_sigma_s: {}, noise: {{sigma_m: {}, sigma_relative: {}, "
      "resolution_m: {}, dropout: {}, dropout_far: {}, dropout_grazing: {}, beam_bias_sigma_m: {}, "
      "dust_per_m: {}, dust_range_m: 6}}}}\n"
      "odometry: {{profile: ideal, radius_error_left: {}, radius_error_right: {}, track_error: {}, "
      "drift_along: {}, drift_yaw_deg: {}, drift_turn_deg: {}, ticks_per_turn: 4096}}\n"
      "people: {{count: {}}}\n"
      "events:\n  - fault: {{kind: lidar-clock, at_s: 0, for_s: 1e6, offset_s: {}}}\n"
      "  - fault: {{kind: lidar-mount, at_s: 0, for_s: 1e6, dx_m: {}, dy_m: {}, yaw_deg: {}}}\n",
      s.world, kTrialRobot, duration_s, s.stamp_sigma_s, s.sigma_m, s.sigma_relative,
      s.resolution_m, s.dropout, s.dropout_far, s.dropout_grazing, s.beam_bias_sigma_m,
      s.dust_per_m, s.radius_error_left, s.radius_error_right, s.track_error, s.drift_along,
      s.drift_yaw_deg, s.drift_turn_deg, s.people, s.offset_s, s.mount.x, s.mount.y,
      s.mount.yaw * 180.0 / std::numbers::pi);
}

}  // namespace castaway::testbed
