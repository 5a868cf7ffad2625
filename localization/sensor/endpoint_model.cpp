#include "localization/sensor/endpoint_model.hpp"

#include <cmath>
#include <stdexcept>

#include "localization/sensor/pose_in_cells.hpp"

namespace castaway::localization {

void validate(const EndpointConfig& config) {
  if (!(config.sigma > 0.0)) throw std::invalid_argument("sigma must be positive");
  if (!(config.floor > 0.0)) throw std::invalid_argument("floor must be positive");
  if (!(config.independent_beams > 0.0)) {
    throw std::invalid_argument("independent_beams must be positive");
  }
}

double endpoint_log_likelihood(const EndpointConfig& config, double distance) {
  const double z = distance / config.sigma;
  return std::log(std::exp(-0.5 * z * z) + config.floor) - std::log1p(config.floor);
}

EndpointModel::EndpointModel(const EndpointConfig& config, const DistanceField& distances)
    : config_((validate(config), config)),
      field_(distances, [&](double d) { return endpoint_log_likelihood(config, d); }) {}

double EndpointModel::log_likelihood(const ScanPoints& points, const SE2& T_map_base) const {
  if (points.empty()) return 0.0;
  const PoseInCells pose(field_.frame(), T_map_base);
  float sum = 0.0F;
  for (std::size_t i = 0; i < points.size(); ++i) {
    sum += field_.at_cells(pose.x(points.x[i], points.y[i]), pose.y(points.x[i], points.y[i]));
  }
  return config_.independent_beams * static_cast<double>(sum) / static_cast<double>(points.size());
}

std::vector<float> EndpointModel::beam_log_likelihoods(const ScanPoints& points,
                                                       const SE2& T_map_base) const {
  const PoseInCells pose(field_.frame(), T_map_base);
  std::vector<float> result(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    result[i] = field_.at_cells(pose.x(points.x[i], points.y[i]), pose.y(points.x[i], points.y[i]));
  }
  return result;
}

}  // namespace castaway::localization
