/// The seam between a run and a localizer: what real hardware would send goes in, estimates come
/// out.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "localization/geometry/se2.hpp"
#include "localization/stamp.hpp"

namespace castaway::localization {

/// One reading of wheel odometry.
struct Odometry {
  Stamp stamp{};
  SE2 T_odom_base;  ///< Accumulated from an arbitrary start; continuous, drifting (REP-105).
};

/// One sweep of a planar lidar, wherever it is mounted.
struct LaserScan {
  Stamp stamp{};                 ///< Time of the first beam.
  Stamp time_increment{};        ///< Time between two beams; 0 if they were taken at once.
  double angle_min = 0.0;        ///< [rad] Angle of the first beam about the lidar's z, from its x.
  double angle_increment = 0.0;  ///< [rad] Signed step between two beams.
  double range_min = 0.0;        ///< [m] Shorter returns are invalid.
  double range_max = 0.0;        ///< [m] Longer returns are invalid.
  std::vector<float> ranges;     ///< [m] REP-117: +inf no return, -inf too close, NaN invalid.
  Eigen::Isometry3d T_base_laser = Eigen::Isometry3d::Identity();  ///< The lidar's mount.
  std::string lidar;  ///< Name of the lidar where there are several; order is kept for each.

  /// Time of beam `index`.
  [[nodiscard]] Stamp beam_stamp(std::size_t index) const {
    return stamp + time_increment * static_cast<std::int64_t>(index);
  }
  /// Angle of beam `index` in the lidar's plane. [rad]
  [[nodiscard]] double beam_angle(std::size_t index) const {
    return angle_min + angle_increment * static_cast<double>(index);
  }
};

/// A pose with its uncertainty.
struct PoseWithCovariance {
  SE2 T_map_base;
  Eigen::Matrix3d covariance =
      Eigen::Matrix3d::Zero();  ///< Of (x, y, yaw) in map: m^2, m rad, rad^2.
};

/// Another place where the robot may be.
struct Alternative {
  SE2 T_map_base;
  double share = 0.0;  ///< Posterior probability in [0, 1].
};

/// What a localizer believes at the stamp of a scan.
struct Estimate {
  Stamp stamp{};  ///< The scan's stamp; T_map_base is the pose at that time.
  SE2 T_map_base;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double quality = 0.0;  ///< In [0, 1]: how well the scan fits the map at this pose (paper, eq. 9).
  double probability = 0.0;               ///< In [0, 1]: stated probability that the pose is right.
  bool lost = false;                      ///< The alarm: do not act on this pose.
  std::vector<Alternative> alternatives;  ///< Other places, most probable first.
};

/// One population of particles as logs and pictures show it.
struct PopulationView {
  int id = 0;                  ///< Unique over the run.
  SE2 T_map_base;              ///< Mean.
  double quality = 0.0;        ///< In [0, 1].
  double share = 0.0;          ///< Posterior probability in [0, 1].
  bool selected = false;       ///< The output is this population's mean.
  std::vector<SE2> particles;  ///< Poses of base in map.
};

/// What a localizer tells about itself.
struct Diagnostics {
  std::vector<PopulationView> populations;
  std::int64_t dropped_scans = 0;     ///< Late, from before or long after all odometry, no numbers.
  std::int64_t dropped_odometry = 0;  ///< Late, no numbers, or beyond 1e7 m.
  std::map<std::string, std::chrono::nanoseconds>
      cpu_by_stage;  ///< Since construction; empty without a clock.
};

/// A clock for measuring stages, handed in by the program; results never depend on it. May be
/// empty.
using StageClock = std::function<std::chrono::nanoseconds()>;

/// A localizer. Calls come in order of delivery, from one thread.
class Localizer {
 public:
  virtual ~Localizer() = default;

  /// Starts anew, at any time: at a pose, or anywhere on the map (`nullopt`: global localization).
  /// Throws std::invalid_argument for a pose or covariance that is no number or beyond 1e7 m.
  virtual void initialize(const std::optional<PoseWithCovariance>& start) = 0;
  /// Takes a reading of odometry. Late ones are dropped; after one that is older by seconds (a
  /// clock set back) motion begins anew from where the robot is believed to be.
  virtual void on_odometry(const Odometry& odometry) = 0;
  /// Takes a scan, delivered when its last beam was taken. Late ones are dropped.
  virtual void on_scan(const LaserScan& scan) = 0;
  /// The newest estimate; nothing while there is none.
  [[nodiscard]] virtual std::optional<Estimate> estimate() const = 0;
  /// Populations, counters and costs after the newest call.
  [[nodiscard]] virtual Diagnostics diagnostics() const = 0;
};

}  // namespace castaway::localization
