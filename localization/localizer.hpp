/// The seam between a run and a localizer: what real hardware would send goes in, estimates come
/// out.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "localization/geometry/pose_statistics.hpp"
#include "localization/geometry/stamp.hpp"
#include "localization/sensor/readings.hpp"

namespace castaway::localization {

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
