/// The interface between a run and a localizer: sensor readings go in, estimates come out. Derive
/// from `Localizer` to take part in runs (castaway/run.hpp).
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "castaway/pose.hpp"
#include "castaway/readings.hpp"
#include "castaway/stamp.hpp"

namespace castaway::localization {

/// The ground under a pose, on a 3-D map.
struct Footing {
  double z = 0.0;  ///< [m] Height of base in map.
  int level = 0;   ///< Of the building, the lowest is 0.
};

/// Another possible pose of the robot.
struct Alternative {
  SE2 T_map_base;
  double share = 0.0;                ///< Posterior probability in [0, 1].
  std::optional<Footing> footing{};  ///< On a 3-D map with ground there.
};

/// A localizer's estimate at the stamp of a scan.
struct Estimate {
  Stamp stamp{};  ///< The scan's stamp; T_map_base is the pose at that time.
  SE2 T_map_base;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< Of (x, y, yaw): m^2, m rad, rad^2.
  /// In [0, 1]: how well the scan fits the map at this pose (paper, eq. 9). NaN: not stated.
  double quality = 0.0;
  /// In [0, 1]: stated probability that the pose is right. NaN: not stated.
  double probability = 0.0;
  bool lost = false;                      ///< Alarm: the pose must not be used.
  std::vector<Alternative> alternatives;  ///< Other possible poses, most probable first.
  std::optional<Footing> footing{};       ///< On a 3-D map with ground there.
};

/// One population of particles, for logs and pictures.
struct PopulationView {
  int id = 0;                        ///< Unique over the run.
  SE2 T_map_base;                    ///< Mean.
  double quality = 0.0;              ///< In [0, 1].
  double share = 0.0;                ///< Posterior probability in [0, 1].
  bool selected = false;             ///< The output is the mean of this population.
  std::vector<SE2> particles;        ///< Poses of base in map; of a mixture of normal
                                     ///< distributions: points one sigma from its means.
  std::optional<Footing> footing{};  ///< Of the mean, on a 3-D map with ground there.
};

/// Internal state of a localizer, for logs and pictures.
struct Diagnostics {
  std::vector<PopulationView> populations;
  std::int64_t dropped_scans = 0;     ///< Late, outside of the known motion, or not finite.
  std::int64_t dropped_odometry = 0;  ///< Late, not finite, or beyond 1e7 m.
  std::map<std::string, std::chrono::nanoseconds>
      cpu_by_stage;  ///< Since construction; empty without a clock.
};

/// A localizer. Calls come in order of delivery, from one thread.
class Localizer {
 public:
  virtual ~Localizer() = default;

  /// Restarts, at any time: at a pose, or anywhere on the map (`nullopt`: global localization).
  /// @throws std::invalid_argument for a pose or covariance that is not finite, or beyond 1e7 m.
  virtual void initialize(const std::optional<PoseWithCovariance>& start) = 0;
  /// Takes an odometry reading. Late ones are dropped. If one is older by seconds (a clock was set
  /// back), motion restarts from the estimated pose.
  virtual void on_odometry(const Odometry& odometry) = 0;
  /// Takes a reading of an inertial measurement unit. Ignored by localizers that do not use it.
  virtual void on_imu(const Imu&) {}
  /// Takes a scan, delivered at the time of its last beam. Late ones are dropped.
  virtual void on_scan(const LaserScan& scan) = 0;
  /// The newest estimate; nothing if there is none.
  [[nodiscard]] virtual std::optional<Estimate> estimate() const = 0;
  /// Populations, counters and CPU times after the latest call.
  [[nodiscard]] virtual Diagnostics diagnostics() const { return {}; }
};

}  // namespace castaway::localization

namespace castaway {

using localization::Alternative;
using localization::Diagnostics;
using localization::Estimate;
using localization::Footing;
using localization::Localizer;
using localization::PopulationView;

}  // namespace castaway
