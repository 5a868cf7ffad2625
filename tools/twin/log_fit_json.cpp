#include <numbers>

#include "tools/twin/log_fit.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const StampFit& fit) {
  return {{"rate_hz", fit.rate_hz},
          {"jitter_s", fit.jitter_s},
          {"gap_share", fit.gap_share},
          {"longest_s", fit.longest_s}};
}

Json to_json(const OdometryFit& fit) {
  return {
      {"radius_error_left", to_json(fit.radius_error_left)},
      {"radius_error_right", to_json(fit.radius_error_right)},
      {"track_error", to_json(fit.track_error)},
      {"drift_along", to_json(fit.drift_along)},
      {"drift_yaw_deg", to_json(fit.drift_yaw_deg)},
      {"drift_turn_deg", to_json(fit.drift_turn_deg)},
      {"scale", to_json(fit.scale)},
      {"yaw_scale", to_json(fit.yaw_scale)},
      {"curvature_rad_per_m", to_json(fit.curvature)},
      {"drive_in_base",
       {{"x_m", to_json(fit.drive_x_m)},
        {"y_m", to_json(fit.drive_y_m)},
        {"yaw_deg", to_json(fit.drive_yaw_deg)}}},
      {"slips", {{"rate_per_m", to_json(fit.slip.rate_per_m)}, {"length_m", fit.slip.length_m}}},
      {"unsigned_distance", fit.unsigned_distance},
      {"stamp_sigma_s", to_json(fit.stamp_sigma_s)},
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
  if (fit.dust) {
    json["dust"] = {{"per_m", to_json(fit.dust->per_m)}, {"range_m", fit.dust->range_m}};
  }
  if (fit.beam_bias) json["beam_bias_sigma_m"] = to_json(fit.beam_bias->sigma_m);
  if (fit.range_limit) json["range_limit_m"] = to_json(fit.range_limit->limit_m);
  if (fit.building) json["building"] = to_json(*fit.building);
  return json;
}

}  // namespace castaway::testbed
