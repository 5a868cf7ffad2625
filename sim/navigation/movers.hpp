/// What moves among the things that the lidar sees, as discs with a velocity.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include <Eigen/Core>

namespace castaway::sim {

/// Somebody on the move.
struct Mover {
  Eigen::Vector2d p = Eigen::Vector2d::Zero();         ///< [m] Its middle.
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< [m/s]
};

/// Radius that a mover is kept free of: the legs that the lidar sees are within a body. [m]
inline constexpr double kMoverRadius = 0.3;

/// Follows clusters of points from look to look. Whatever keeps moving for half a second is a
/// mover; what stands is not.
class Movers {
 public:
  /// `period` [s] between two calls of `update`.
  explicit Movers(double period) : period_(period) {}

  /// Takes what the lidar sees where the map has nothing. [m] In a frame that does not move.
  void update(const std::vector<Eigen::Vector2d>& points);
  /// Those of the newest look, in its frame.
  [[nodiscard]] std::vector<Mover> moving() const;

 private:
  struct Sighting {
    std::int64_t look = 0;
    Eigen::Vector2d p = Eigen::Vector2d::Zero();
  };
  using Track = std::deque<Sighting>;

  [[nodiscard]] Eigen::Vector2d velocity(const Track& track) const;
  [[nodiscard]] Track* nearest(const Eigen::Vector2d& p);

  double period_;
  std::int64_t look_ = 0;
  std::vector<Track> tracks_;
};

}  // namespace castaway::sim
