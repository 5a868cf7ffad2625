#include "tools/outputs/records/place_scores.hpp"

#include <algorithm>

namespace castaway::testbed {

std::optional<double> PlaceScores::at(const Eigen::Vector2d& p_map) const {
  const auto nearest = std::min_element(
      places.begin(), places.end(), [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return (a - p_map).squaredNorm() < (b - p_map).squaredNorm();
      });
  if (nearest == places.end()) return std::nullopt;
  return scores[static_cast<std::size_t>(nearest - places.begin())];
}

}  // namespace castaway::testbed
