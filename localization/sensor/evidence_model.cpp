#include "localization/sensor/evidence_model.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace castaway::localization {

EvidenceModel::EvidenceModel(const EvidenceConfig& config, const OccupancyGrid& grid,
                             const DistanceField& distances)
    : config_(config),
      grid_(&grid),
      walls_(distances),
      endpoint_(config.endpoint, distances),
      through_wall_(std::log(config.through_wall) - std::log1p(config.through_wall)) {}

EvidenceModel::EvidenceModel(const EvidenceConfig& config, const Volume& volume)
    : config_(config),
      volume_(&volume),
      endpoint_(config.endpoint, volume),
      through_wall_(std::log(config.through_wall) - std::log1p(config.through_wall)) {}

bool EvidenceModel::is_free(const SE2& T_map_base) const {
  if (volume_ != nullptr) return volume_->lift(T_map_base).has_value();
  return grid_->at(T_map_base.translation()) == CellState::kFree;
}

Evidence EvidenceModel::evaluate(const ScanPoints& points, const SE2& T_map_base) const {
  if (points.empty()) return {};
  const std::vector<float> beams = endpoint_.beam_log_likelihoods(points, T_map_base);
  const RayConsistency rays(world(), T_map_base, config_.rays);
  const double floor = config_.endpoint.floor;
  double sum = 0.0;
  double hits = 0.0;
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const double l = beams[i];
    sum += l > through_wall_ && rays.through_wall(points, i) ? through_wall_ : l;
    hits += std::max(0.0, std::exp(l) * (1.0 + floor) - floor);
  }
  return {scale_sum(sum, beams.size(), T_map_base),
          std::min(1.0, hits / static_cast<double>(beams.size()))};
}

double EvidenceModel::log_likelihood_above(double least, const ScanPoints& points,
                                           const SE2& T_map_base) const {
  if (points.empty()) return 0.0;
  const std::vector<float> beams = endpoint_.beam_log_likelihoods(points, T_map_base);
  const RayConsistency rays(world(), T_map_base, config_.rays);
  double sum = std::accumulate(beams.begin(), beams.end(), 0.0);
  double value = scale_sum(sum, beams.size(), T_map_base);
  for (std::size_t i = 0; i < beams.size() && value > least; ++i) {
    const double l = beams[i];
    if (l <= through_wall_ || !rays.through_wall(points, i)) continue;
    sum += through_wall_ - l;
    value = scale_sum(sum, beams.size(), T_map_base);
  }
  return value;
}

/// Share of the independent beams that a scan counts as.
double EvidenceModel::share(std::size_t beams) const {
  return std::min(
      1.0, config_.per_beam * static_cast<double>(beams) / config_.endpoint.independent_beams);
}

double EvidenceModel::scale_sum(double sum, std::size_t beams, const SE2& T_map_base) const {
  double mean = sum / static_cast<double>(beams);
  if (!is_free(T_map_base)) mean -= config_.off_free_penalty;
  return std::max(share(beams) * (config_.endpoint.independent_beams * mean - config_.right_pose),
                  config_.minimum);
}

double EvidenceModel::bound(const ScanPoints& points, const SE2& T_map_base) const {
  constexpr double kRounding = 1e-3;  // Rounding of sums in single precision.
  const double sum = endpoint_.log_likelihood(points, T_map_base) - config_.right_pose;
  return std::max(share(points.size()) * sum + kRounding, config_.minimum);
}

}  // namespace castaway::localization
