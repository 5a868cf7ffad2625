#include "tools/twin/log_fit.hpp"

#include <cmath>
#include <numbers>

#include "tools/alignment/expected_scan.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

/// Fits odometry and the offset of the lidar's clock.
void fit_motion(const AlignedLog& log, double track, LogFit& fit) {
  fit.odometry = fit_odometry(take_legs(log, track), track);
  const OdometryErrors errors = fit.odometry ? fit.odometry->errors : OdometryErrors{};
  fit.clock = fit_clock(log, errors);
}

WallOffsets learn_walls(const AlignedLog& log, double usual) {
  constexpr std::size_t kMostScans = 4000;
  constexpr double kNearWall = 0.2;  // [m]
  WallOffsets walls(log.grid.frame, usual);
  for (const std::size_t i : spread_scans(log, kMostScans)) {
    const LaserScan& scan = log.scans[i].scan;
    const auto expected = expect_scan(log, log.scans[i], std::min(scan.range_max, 40.0));
    for (std::size_t k = 0; k < expected.size(); ++k) {
      const double offset = scan.ranges[k] - expected[k].range;
      if (!expected[k].straight || !(std::abs(offset - usual) < kNearWall)) continue;
      walls.add(expected[k].cell, offset * expected[k].cosine);
    }
  }
  return walls;
}

/// Improves the corrections of the scans by what was fitted to the scans as they are.
void correct(const FittedLog& fitted, ScanCorrection& correction) {
  if (fitted.fit.clock) {
    correction.stamp -= localization::from_seconds(fitted.fit.clock->offset_s.value);
  }
  if (fitted.fit.odometry) correction.odometry = fitted.fit.odometry->errors;
  if (fitted.fit.noise) {
    correction.walls = learn_walls(fitted.log, fitted.fit.noise->bias_m.value);
  }
}

Figure shift_figure(Figure figure, double by) {
  return {figure.value + by, {figure.interval.low + by, figure.interval.high + by}};
}

Json to_json(const StampFit& fit) {
  return {{"rate_hz", fit.rate_hz},
          {"jitter_s", fit.jitter_s},
          {"gap_share", fit.gap_share},
          {"longest_s", fit.longest_s}};
}

Json to_json(const OdometryFit& fit) {
  return {{"radius_error_left", to_json(fit.radius_error_left)},
          {"radius_error_right", to_json(fit.radius_error_right)},
          {"track_error", to_json(fit.track_error)},
          {"drift_along", to_json(fit.drift_along)},
          {"drift_yaw_deg", to_json(fit.drift_yaw_deg)},
          {"scale", to_json(fit.scale)},
          {"yaw_scale", to_json(fit.yaw_scale)},
          {"curvature_rad_per_m", to_json(fit.curvature)},
          {"alignment_sigma_m", to_json(fit.match_sigma_m)},
          {"way_m", fit.way_m},
          {"stretches", fit.stretches},
          {"outlier_share", fit.outliers}};
}

Json to_json(const RangeNoiseFit& fit) {
  Json bins = Json::array();
  for (const auto& bin : fit.bins)
    bins.push_back({{"range_m", bin.range_m}, {"sigma_m", bin.sigma_m}});
  return {{"sigma_m", to_json(fit.sigma_m)},
          {"sigma_relative", to_json(fit.sigma_relative)},
          {"sigma_typical_m", to_json(fit.sigma_typical)},
          {"typical_range_m", fit.typical_range_m},
          {"resolution_m", fit.resolution_m},
          {"bias_m", to_json(fit.bias_m)},
          {"groups", fit.groups},
          {"by_range", bins}};
}

Json to_json(const LossFit& fit) {
  return {{"dropout", to_json(fit.dropout)},
          {"dropout_far", to_json(fit.dropout_far)},
          {"dropout_grazing", to_json(fit.dropout_grazing)},
          {"lost", to_json(fit.lost)},
          {"beams", fit.beams}};
}

Json to_json(const std::vector<MapBox>& boxes) {
  Json list = Json::array();
  for (const MapBox& box : boxes) {
    list.push_back({{"at", {box.T_map_box.x, box.T_map_box.y}},
                    {"yaw_deg", box.T_map_box.yaw * 180.0 / std::numbers::pi},
                    {"size", {box.size.x(), box.size.y()}}});
  }
  return list;
}

Json to_json(const BuildingFit& fit) {
  return {{"moving_share", to_json(fit.moving_share)},
          {"standing_share", to_json(fit.standing_share)},
          {"through_share", to_json(fit.through_share)},
          {"moving_count", to_json(fit.moving_count)},
          {"free_area_m2", fit.free_area_m2},
          {"watched_m2", fit.watched_m2},
          {"beams", fit.beams},
          {"standing", to_json(fit.standing)},
          {"gone", to_json(fit.gone)}};
}

}  // namespace

FittedLog fit_log(const RecordedPlace& place, const LogFitConfig& config) {
  constexpr int kRounds = 4;
  ScanCorrection correction;
  FittedLog fitted;
  for (int round = 0; round < kRounds; ++round) {
    if (round > 0) correct(fitted, correction);
    fitted.log = align_log(place, config.align, correction);
    fit_motion(fitted.log, config.track, fitted.fit);
    fitted.fit.noise = fit_range_noise(fitted.log);
  }
  fitted.walls = std::move(correction.walls);
  if (fitted.fit.clock) {
    Figure& offset = fitted.fit.clock->offset_s;
    offset = shift_figure(offset, -seconds(correction.stamp));
  }
  fitted.fit.stamps = fit_stamps(fitted.log.stamps);
  fitted.fit.loss = fit_loss(fitted.log);
  fitted.fit.mixed = fit_mixed(fitted.log);
  fitted.fit.building = fit_building(fitted.log);
  return fitted;
}

Json to_json(const Figure& figure) {
  return {{"value", figure.value}, {"interval", {figure.interval.low, figure.interval.high}}};
}

Json to_json(const FittedLog& fitted) {
  const LogFit& fit = fitted.fit;
  Json json = {{"log", fitted.log.name},
               {"scans", fitted.log.scans.size()},
               {"scans_left_out", fitted.log.left_out},
               {"end_points_on_walls", fitted.log.on_walls},
               {"aligned_by", fitted.log.by_truth ? "reference poses" : "mh_amcl"},
               {"stamps", to_json(fit.stamps)}};
  if (fit.clock) {
    json["lidar_clock"] = {{"offset_s", to_json(fit.clock->offset_s)},
                           {"turn_changes_rad_s", fit.clock->turn_changes}};
  }
  if (fit.odometry) json["odometry"] = to_json(*fit.odometry);
  if (fit.noise) json["range_noise"] = to_json(*fit.noise);
  if (fit.loss) json["loss"] = to_json(*fit.loss);
  if (fit.mixed) {
    json["mixed_pixels"] = {{"divergence_deg", to_json(fit.mixed->divergence_deg)},
                            {"reach_m", fit.mixed->reach_m},
                            {"steps", fit.mixed->steps}};
  }
  if (fit.building) json["building"] = to_json(*fit.building);
  return json;
}

}  // namespace castaway::testbed
