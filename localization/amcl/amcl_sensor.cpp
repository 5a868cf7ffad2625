#include "localization/amcl/amcl_sensor.hpp"

#include <cmath>

namespace castaway::localization {
namespace {

/// Returns the map, shifted by half a cell if configured.
OccupancyGrid place_map(const AmclConfig& config, OccupancyGrid map) {
  validate(map);
  const double shift = config.half_cell_shift ? -0.5 * map.frame.resolution : 0.0;
  map.frame.T_map_grid = map.frame.T_map_grid * SE2{shift, shift, 0.0};
  return map;
}

}  // namespace

AmclSensor::AmclSensor(const AmclConfig& config, const OccupancyGrid& map)
    : model_(config.model),
      beam_skip_(config.beam_skip),
      map_(place_map(config, map)),
      field_(config.sensor, map_) {
  if (model_ == AmclSensorModel::kBeam) beam_model_.emplace(config.beam, map_);
}

bool AmclSensor::is_informative(const BeamScan& beams) const {
  return !beams.returns.empty() || (beam_model_ && !beams.misses.empty());
}

std::vector<double> AmclSensor::log_weights(const BeamScan& beams, const std::vector<SE2>& poses,
                                            double range_max) const {
  if (model_ == AmclSensorModel::kLikelihoodFieldProb) {
    return prob_log_weights(field_, beams.returns, poses, range_max, beam_skip_);
  }
  std::vector<double> result;
  for (const SE2& pose : poses) {
    const double weight = beam_model_ ? beam_model_->weight(beams, pose, range_max)
                                      : field_.weight(beams.returns, pose, range_max);
    result.push_back(std::log(weight));
  }
  return result;
}

double AmclSensor::quality(const BeamScan& beams, const SE2& T_map_base) const {
  return field_.quality(beams.returns, T_map_base);
}

}  // namespace castaway::localization
