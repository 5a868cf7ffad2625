/// Tracks people in lidar scans as discs with a velocity.
#pragma once

#include <chrono>
#include <vector>

#include <Eigen/Core>

namespace castaway::sim {

/// An end point of a beam.
struct SeenPoint {
  Eigen::Vector2d p = Eigen::Vector2d::Zero();  ///< [m]
  std::chrono::nanoseconds stamp{};             ///< Time of its beam.
};

/// A tracked person, walking or standing, where the map has no obstacle.
struct Mover {
  Eigen::Vector2d p = Eigen::Vector2d::Zero();         ///< [m] Centre.
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< [m/s] Zero if it stands.

  [[nodiscard]] bool stands() const { return velocity.isZero(0.0); }
};

/// Radius of the disc kept free around a mover: it covers the body about the legs that the lidar
/// sees. [m]
inline constexpr double kMoverRadius = 0.3;

/// Tracks people from scan to scan: small clusters of points are legs, and legs that are near each
/// other are one person. A Kalman filter with constant velocity and white acceleration noise (Y.
/// Bar-Shalom, X.-R. Li and T. Kirubarajan, "Estimation with Applications to Tracking and
/// Navigation", 2001, section 6.2) bridges scans in which the person is hidden. A track whose speed
/// does not exceed the filter's own uncertainty is reported as standing.
class Movers {
 public:
  /// Takes the points of one scan that are not on the map, in a frame that does not move.
  void update(const std::vector<SeenPoint>& points);
  /// Tracks seen in enough scans, extrapolated to `now`, in that frame.
  [[nodiscard]] std::vector<Mover> extrapolate(std::chrono::nanoseconds now) const;

 private:
  /// Filter state of one person; both axes share one covariance.
  struct Track {
    Eigen::Vector2d p;
    Eigen::Vector2d v;
    Eigen::Matrix2d covariance;  ///< Of position and velocity along one axis.
    std::chrono::nanoseconds stamp;
    int seen = 1;                   ///< Scans that saw it.
    std::vector<SeenPoint> legs{};  ///< Those of the current scan.

    [[nodiscard]] Eigen::Vector2d at(std::chrono::nanoseconds t) const;
    void predict(std::chrono::nanoseconds to);
    void correct(const Eigen::Vector2d& measured, double sigma);
  };

  [[nodiscard]] Track* nearest(const SeenPoint& leg);
  void start_track(const SeenPoint& leg);
  void split();
  void update_tracks();
  void drop_duplicates();

  std::vector<Track> tracks_;
};

}  // namespace castaway::sim
