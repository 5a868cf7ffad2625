/// What moves among the things that the lidar sees, as discs with a velocity.
#pragma once

#include <chrono>
#include <vector>

#include <Eigen/Core>

namespace castaway::sim {

/// An end point of a beam.
struct SeenPoint {
  Eigen::Vector2d p = Eigen::Vector2d::Zero();  ///< [m]
  std::chrono::nanoseconds stamp{};             ///< Of its beam.
};

/// Somebody on the move, or who stands about where the map has nothing.
struct Mover {
  Eigen::Vector2d p = Eigen::Vector2d::Zero();         ///< [m] Its middle.
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< [m/s] Zero: stands.

  [[nodiscard]] bool stands() const { return velocity.isZero(0.0); }
};

/// Radius that a mover is kept free of: the legs that the lidar sees are within a body. [m]
inline constexpr double kMoverRadius = 0.3;

/// Follows people from scan to scan: small clusters of points are legs, legs that are near each
/// other a person, and a Kalman filter of constant velocity (white noise of acceleration; Y.
/// Bar-Shalom, X.-R. Li and T. Kirubarajan, "Estimation with Applications to Tracking and
/// Navigation", 2001, section 6.2) carries each over scans in which it is hidden. What stands has
/// no velocity that stands out from the filter's own uncertainty and is no mover.
class Movers {
 public:
  /// Takes what one scan saw where the map has nothing, in a frame that does not move.
  void update(const std::vector<SeenPoint>& points);
  /// All who have been seen for a while, as they are `now`, in that frame.
  [[nodiscard]] std::vector<Mover> seen(std::chrono::nanoseconds now) const;

 private:
  /// A person with the filter's state; both axes have the same covariance.
  struct Track {
    Eigen::Vector2d p;
    Eigen::Vector2d v;
    Eigen::Matrix2d covariance;  ///< Of position and velocity.
    std::chrono::nanoseconds stamp;
    int seen = 1;                   ///< Scans.
    std::vector<SeenPoint> legs{};  ///< Of the scan at hand.

    [[nodiscard]] Eigen::Vector2d at(std::chrono::nanoseconds t) const;
    void predict(std::chrono::nanoseconds to);
    void correct(const Eigen::Vector2d& measured, double sigma);
  };

  [[nodiscard]] Track* nearest(const SeenPoint& leg);
  void begin(const SeenPoint& leg);
  void split();
  void take_legs();
  void drop_doubles();

  std::vector<Track> tracks_;
};

}  // namespace castaway::sim
