#include "localization/sensor/evidence_model.hpp"

#include <algorithm>
#include <cmath>

namespace castaway::localization {

EvidenceModel::EvidenceModel(const EvidenceConfig& config, const OccupancyGrid& grid,
                             const DistanceField& distances)
    : config_(config), grid_(grid), distances_(distances), endpoint_(config.endpoint, distances) {}

Evidence EvidenceModel::evaluate(const ScanPoints& points, const SE2& T_map_base) const {
  if (points.empty()) return {};
  const std::vector<float> beams = endpoint_.beam_log_likelihoods(points, T_map_base);
  const std::vector<bool> through =
      beams_through_walls(points, distances_, T_map_base, config_.rays);
  const double floor = config_.endpoint.floor;
  const double worst = std::log(config_.through_wall) - std::log1p(config_.through_wall);
  double sum = 0.0;
  double hits = 0.0;
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const double l = beams[i];
    sum += through[i] ? std::min(l, worst) : l;
    hits += std::max(0.0, std::exp(l) * (1.0 + floor) - floor);
  }
  const auto n = static_cast<double>(beams.size());
  double mean = sum / n;
  if (grid_.at(T_map_base.translation()) != CellState::kFree) mean -= config_.off_free_penalty;
  const double scaled = config_.endpoint.independent_beams * mean;
  return {std::max(scaled, config_.minimum), std::min(1.0, hits / n)};
}

double EvidenceModel::bound(const ScanPoints& points, const SE2& T_map_base) const {
  constexpr double kRounding = 1e-3;  // sums in single precision
  return std::max(endpoint_.log_likelihood(points, T_map_base) + kRounding, config_.minimum);
}

}  // namespace castaway::localization
