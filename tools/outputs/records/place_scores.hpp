/// Scores at places all over a map.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace castaway::testbed {

/// Places and their scores.
struct PlaceScores {
  std::vector<Eigen::Vector2d> places;  ///< [m] In map.
  std::vector<double> scores;           ///< One per place.

  /// Score of the nearest place, the first of several at equal distance; nothing without places.
  [[nodiscard]] std::optional<double> at(const Eigen::Vector2d& p_map) const;
};

}  // namespace castaway::testbed
