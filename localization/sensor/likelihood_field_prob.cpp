#include "localization/sensor/likelihood_field_prob.hpp"

#include <algorithm>
#include <cmath>

namespace castaway::localization {

std::vector<bool> beams_to_use(const std::vector<std::vector<double>>& distances,
                               const BeamSkipConfig& config) {
  const std::size_t beams = distances.empty() ? 0 : distances[0].size();
  std::vector<bool> use(beams, true);
  if (!config.enabled) return use;
  for (std::size_t b = 0; b < beams; ++b) {
    const auto explained = std::count_if(distances.begin(), distances.end(),
                                         [&](const auto& d) { return d[b] < config.distance; });
    use[b] =
        static_cast<double>(explained) > config.threshold * static_cast<double>(distances.size());
  }
  const auto skipped = std::count(use.begin(), use.end(), false);
  if (static_cast<double>(skipped) >= config.error_threshold * static_cast<double>(beams)) {
    use.assign(beams, true);
  }
  return use;
}

std::vector<double> prob_log_weights(const LikelihoodField& field, const ScanPoints& points,
                                     const std::vector<SE2>& poses, double range_max,
                                     const BeamSkipConfig& config) {
  std::vector<std::vector<double>> distances;
  for (const SE2& pose : poses) distances.push_back(field.distances(points, pose));
  const std::vector<bool> use = beams_to_use(distances, config);
  std::vector<double> log_weights(poses.size(), 0.0);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    for (std::size_t b = 0; b < points.size(); ++b) {
      if (use[b]) log_weights[i] += std::log(field.beam_probability(distances[i][b], range_max));
    }
  }
  return log_weights;
}

}  // namespace castaway::localization
