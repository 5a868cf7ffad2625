#include "tools/twin/prediction/calibration_lines.hpp"

#include <numbers>

#include <fmt/format.h>

namespace castaway::testbed {
namespace {

constexpr double kPercent = 100.0;
constexpr double kMilli = 1000.0;
constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;

/// `scale` converts the figure to the unit shown.
CalibrationLine line_of(const char* name, const Figure& figure, const char* unit,
                        double scale = 1.0) {
  return {
      name, fmt::format("{:.4g} {}", scale * figure.value, unit),
      fmt::format("{:.4g} to {:.4g}", scale * figure.interval.low, scale * figure.interval.high)};
}

CalibrationGroup odometry_group(const LogFit& fit) {
  if (!fit.odometry) {
    return {"Odometry", {{"errors", "not fitted: the robot drove less than 100 m", ""}}};
  }
  const OdometryFit& odometry = *fit.odometry;
  return {fmt::format("Odometry, over {:.0f} m", odometry.way_m),
          {line_of("distance, true over measured", odometry.scale, "% more", kPercent),
           line_of("turn, true over measured", odometry.yaw_scale, "% more", kPercent),
           line_of("curvature", odometry.curvature, "deg/m", kDegreesPerRadian),
           line_of("random walk along", odometry.drift_along, "m/sqrt(m)"),
           line_of("walk of the yaw by travel", odometry.drift_yaw_deg, "deg/sqrt(m)"),
           line_of("walk of the yaw by turn", odometry.drift_turn_deg, "deg/sqrt(rad)"),
           line_of("slips of each wheel", odometry.slip.rate_per_m, "/m"),
           line_of("drive ahead of stated base", odometry.drive_x_m, "mm", kMilli),
           line_of("drive left of stated base", odometry.drive_y_m, "mm", kMilli),
           line_of("drive turned against base", odometry.drive_yaw_deg, "deg"),
           {"reversing", odometry.unsigned_distance ? "counted as driving ahead" : "counted", ""}}};
}

void add_noise(const LogFit& fit, CalibrationGroup& group) {
  if (!fit.noise) {
    group.lines.push_back({"noise", "not fitted: too few beams on straight walls", ""});
    return;
  }
  const RangeNoiseFit& noise = *fit.noise;
  group.lines.push_back(line_of("noise at range 0", noise.sigma_m, "mm", kMilli));
  group.lines.push_back(line_of("noise per metre", noise.sigma_relative, "mm/m", kMilli));
  group.lines.push_back(line_of("range behind the map's walls", noise.bias_m, "mm", kMilli));
  group.lines.push_back({"resolution", fmt::format("{:.4g} mm", kMilli * noise.resolution_m), ""});
}

void add_mixed(const LogFit& fit, CalibrationGroup& group) {
  if (!fit.mixed) {
    group.lines.push_back({"mixed pixels", "not fitted: too few depth steps", ""});
    return;
  }
  group.lines.push_back(line_of("opening of a beam", fit.mixed->divergence_deg, "deg"));
  group.lines.push_back({"mixed steps, up to", fmt::format("{:.4g} m", fit.mixed->reach_m), ""});
}

/// Errors that many lidars do not have.
void add_rare(const LogFit& fit, CalibrationGroup& group) {
  if (fit.dust) {
    group.lines.push_back(line_of("dust", fit.dust->per_m, "/m"));
  } else {
    group.lines.push_back({"dust", "not fitted: too few beams on straight walls", ""});
  }
  if (fit.beam_bias) {
    group.lines.push_back(line_of("offsets of beams", fit.beam_bias->sigma_m, "mm", kMilli));
  } else {
    group.lines.push_back({"offsets of beams", "not fitted: too few straight surfaces", ""});
  }
  if (fit.range_limit) {
    group.lines.push_back(line_of("nothing is seen beyond", fit.range_limit->limit_m, "m"));
  }
}

CalibrationGroup lidar_group(const LogFit& fit) {
  CalibrationGroup group{fmt::format("Lidar, {:.2f} scans a second", fit.stamps.rate_hz), {}};
  if (fit.clock) {
    group.lines.push_back(line_of("clock ahead of odometry", fit.clock->offset_s, "ms", kMilli));
  } else {
    group.lines.push_back(
        {"clock", "not fitted: odometry comes too seldom or turns too evenly", ""});
  }
  if (fit.odometry) {
    group.lines.push_back(
        line_of("error of the stamps", fit.odometry->stamp_sigma_s, "ms", kMilli));
  }
  group.lines.push_back(
      {"jitter of the periods", fmt::format("{:.4g} ms", kMilli * fit.stamps.jitter_s), ""});
  add_noise(fit, group);
  if (fit.loss) {
    group.lines.push_back(line_of("lost on walls", fit.loss->lost, "% of beams", kPercent));
  } else {
    group.lines.push_back({"losses", "not fitted: too few beams on straight walls", ""});
  }
  add_mixed(fit, group);
  add_rare(fit, group);
  return group;
}

CalibrationGroup building_group(const BuildingFit& fit, const Figure& people) {
  return {
      fmt::format("Building against map, {:.0f} m^2", fit.free_area_m2),
      {line_of("beams on what moves", fit.moving_share, "%", kPercent),
       line_of("beams on new objects", fit.standing_share, "%", kPercent),
       line_of("beams through walls", fit.through_share, "%", kPercent),
       {"objects",
        fmt::format("{} new; parts of walls gone: {}", fit.standing.size(), fit.gone.size()), ""},
       line_of("people", people, "walking")}};
}

}  // namespace

std::vector<CalibrationGroup> calibration_groups(const Twin& twin) {
  const LogFit& fit = twin.fitted.fit;
  std::vector<CalibrationGroup> groups{odometry_group(fit), lidar_group(fit)};
  if (fit.building) groups.push_back(building_group(*fit.building, twin.people));
  return groups;
}

std::string alignment_sentence(const AlignedLog& log) {
  return fmt::format("{} scans aligned by {}, {} left out; {:.0f} % of the end points on walls",
                     log.scans.size(), log.by_truth ? "reference poses" : "mh_amcl", log.left_out,
                     kPercent * log.on_walls);
}

}  // namespace castaway::testbed
