/// A figure at places all over a map.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace castaway::testbed {

/// Places and what was found there.
struct PlaceScores {
  std::vector<Eigen::Vector2d> places;  ///< [m] In map.
  std::vector<double> scores;           ///< One for each place.

  /// The score of the nearest place, the first of equally near ones; nothing without places.
  [[nodiscard]] std::optional<double> at(const Eigen::Vector2d& p_map) const;
};

}  // namespace castaway::testbed
