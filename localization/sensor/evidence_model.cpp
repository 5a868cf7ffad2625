#include "localization/sensor/evidence_model.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace castaway::localization {
namespace {

std::vector<std::size_t> likelier_than(double least, const std::vector<double>& beams) {
  std::vector<std::size_t> indices;
  indices.reserve(beams.size());
  for (std::size_t i = 0; i < beams.size(); ++i) {
    if (beams[i] > least) indices.push_back(i);
  }
  return indices;
}

}  // namespace

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
  std::vector<double> beams = log_likelihoods(points, T_map_base);
  const double hits = sum_of_likelihoods(beams);
  const RayConsistency rays(world(), T_map_base, config_.rays);
  for (const std::size_t i : rays.through_wall(points, likelier_than(through_wall_, beams))) {
    beams[i] = through_wall_;
  }
  const double sum = std::accumulate(beams.begin(), beams.end(), 0.0);
  return {scale_sum(sum, points, T_map_base),
          std::min(1.0, hits / static_cast<double>(beams.size()))};
}

double EvidenceModel::log_likelihood_above(double least, const ScanPoints& points,
                                           const SE2& T_map_base) const {
  if (points.empty()) return 0.0;
  const std::vector<double> beams = log_likelihoods(points, T_map_base);
  const RayConsistency rays(world(), T_map_base, config_.rays);
  double sum = std::accumulate(beams.begin(), beams.end(), 0.0);
  double value = scale_sum(sum, points, T_map_base);
  constexpr std::size_t kAtOnce = 8;
  const std::vector<std::size_t> likely = likelier_than(through_wall_, beams);
  for (std::size_t first = 0; first < likely.size() && value > least; first += kAtOnce) {
    const std::size_t count = std::min(kAtOnce, likely.size() - first);
    for (const std::size_t i : rays.through_wall(points, std::span(likely).subspan(first, count))) {
      if (value <= least) break;
      sum += through_wall_ - beams[i];
      value = scale_sum(sum, points, T_map_base);
    }
  }
  return value;
}

std::vector<double> EvidenceModel::log_likelihoods(const ScanPoints& points,
                                                   const SE2& T_map_base) const {
  const std::vector<float> beams = endpoint_.beam_log_likelihoods(points, T_map_base);
  return {beams.begin(), beams.end()};
}

double EvidenceModel::sum_of_likelihoods(const std::vector<double>& beams) const {
  const double floor = config_.endpoint.floor;
  double sum = 0.0;
  for (const double l : beams) sum += std::max(0.0, std::exp(l) * (1.0 + floor) - floor);
  return sum;
}

/// Share of the independent beams that a scan counts as.
double EvidenceModel::share(std::size_t beams) const {
  return std::min(
      1.0, config_.per_beam * static_cast<double>(beams) / config_.endpoint.independent_beams);
}

double EvidenceModel::scale_sum(double sum, const ScanPoints& points, const SE2& T_map_base) const {
  double mean = sum / static_cast<double>(points.size());
  if (!is_free(T_map_base)) mean -= config_.off_free_penalty;
  const double fit = config_.endpoint.independent_beams * mean - config_.right_pose;
  return std::max(share(points.size()) * fit - tilt_cost(points, T_map_base), config_.minimum);
}

/// What it costs that the robot would stand tilted otherwise than it does. [nats]
double EvidenceModel::tilt_cost(const ScanPoints& points, const SE2& T_map_base) const {
  if (volume_ == nullptr || !points.up) return 0.0;
  const auto ground = volume_->lift(T_map_base);
  if (!ground) return 0.0;
  const Eigen::Vector3d up = ground->T_map_base.linear().row(2).transpose();
  const double error = (points.up->cast<double>() - up).norm() / config_.tilt_sigma;
  return std::min(0.5 * error * error, config_.most_tilt);
}

double EvidenceModel::bound(const ScanPoints& points, const SE2& T_map_base) const {
  constexpr double kRounding = 1e-3;  // Rounding of sums in single precision.
  const double sum = endpoint_.log_likelihood(points, T_map_base) - config_.right_pose;
  return std::max(share(points.size()) * sum + kRounding, config_.minimum);
}

}  // namespace castaway::localization
