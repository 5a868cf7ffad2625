#include "localization/sensor/along_beam_model.hpp"

#include <algorithm>
#include <cmath>

#include "localization/sensor/four_points.hpp"
#include "localization/space/volume/surface_along.hpp"

namespace castaway::localization {
namespace {

constexpr double kMostReach = 1.0;  // [m]

FourFloats square_root(FourFloats values) {
  for (int k = 0; k < 4; ++k) values[k] = std::sqrt(values[k]);
  return values;
}

/// Unit vectors from `from` to `to`.
FourPoints directions(const FourPoints& from, const FourPoints& to) {
  const FourPoints way{to.x - from.x, to.y - from.y, to.z - from.z};
  const FourFloats length =
      square_root(way.x * way.x + way.y * way.y + way.z * way.z) + 1e-6F;  // Never 0.
  return {way.x / length, way.y / length, way.z / length};
}

}  // namespace

AlongBeamModel::AlongBeamModel(const EndpointConfig& config, const Volume& volume)
    : config_((validate(config), config)),
      volume_(&volume),
      reach_(static_cast<float>(std::min(3.0 * config.sigma, kMostReach))) {
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(values_.size() - 1);
    values_[i] =
        static_cast<float>(endpoint_log_likelihood(config, share * static_cast<double>(reach_)));
  }
}

template <typename Take>
void AlongBeamModel::take_errors(const ScanPoints& points, const SE2& T_map_base,
                                 const Take& take) const {
  const auto base = volume_->lift(T_map_base);
  if (!base) {
    for (std::size_t i = 0; i < points.size(); ++i) take(reach_);
    return;
  }
  const PoseInVolume pose(base->T_map_base);
  for (std::size_t i = 0; i < points.size(); i += 4) {
    const FourPoints ends = pose * four_ends(points, i);
    const FourPoints origins = pose * four_origins(points, i);
    const FourFloats errors =
        surface_along(volume_->surfaces(), ends, directions(origins, ends), reach_);
    const int last = static_cast<int>(std::min<std::size_t>(4, points.size() - i));
    for (int k = 0; k < last; ++k) take(errors[k]);
  }
}

float AlongBeamModel::value(float error) const {
  const float per_m = static_cast<float>(values_.size() - 1) / reach_;
  return values_[static_cast<std::size_t>(per_m * error + 0.5F)];
}

double AlongBeamModel::log_likelihood(const ScanPoints& points, const SE2& T_map_base) const {
  if (points.empty()) return 0.0;
  float sum = 0.0F;
  take_errors(points, T_map_base, [&](float error) { sum += value(error); });
  return config_.independent_beams * static_cast<double>(sum) / static_cast<double>(points.size());
}

std::vector<float> AlongBeamModel::beam_log_likelihoods(const ScanPoints& points,
                                                        const SE2& T_map_base) const {
  std::vector<float> all = errors(points, T_map_base);
  for (float& error : all) error = value(error);
  return all;
}

std::vector<float> AlongBeamModel::errors(const ScanPoints& points, const SE2& T_map_base) const {
  std::vector<float> all;
  all.reserve(points.size());
  take_errors(points, T_map_base, [&](float error) { all.push_back(error); });
  return all;
}

}  // namespace castaway::localization
