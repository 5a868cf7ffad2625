/// A lidar in a scene: single beams, and sweeps while the robot moves.
#pragma once

#include <chrono>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/sensor/beam_light.hpp"
#include "sim/sensor/lidar_config.hpp"
#include "sim/sensor/readings.hpp"

namespace castaway::sim {

/// What one beam reports.
struct Beam {
  float range = 0.0F;                      ///< [m] +inf: nothing within range, -inf: too close.
  int object = kHitNothing;                ///< What it hit.
  std::uint32_t primitive = kNoPrimitive;  ///< As in `cast`: guess for the next beam.
  float intensity = 0.0F;                  ///< As set by `LidarConfig::intensity`.
};

/// Casts beams from a mount on the base. Beams are numbered layer by layer.
class Lidar {
 public:
  /// `pattern`: the constant offsets of the beams are drawn from it. @throws std::invalid_argument
  /// if the settings are impossible.
  explicit Lidar(const LidarConfig& config, Surfaces surfaces = {}, Rng pattern = {});

  /// Casts beam `index` from the base's pose and adds the noise. `guess`: as in `RayScene::cast`.
  [[nodiscard]] Beam cast(const Surroundings& around, const Eigen::Isometry3d& T_map_base,
                          int index, LidarDraws& draws, std::uint32_t guess = kNoPrimitive) const;
  /// Beam `index` from the base's pose.
  [[nodiscard]] Ray ray(const Eigen::Isometry3d& T_map_base, int index) const;
  [[nodiscard]] const LidarConfig& config() const { return config_; }
  /// From now on, hits are on these.
  void set_surfaces(const Surfaces& surfaces) {
    if (light_) light_->set_surfaces(surfaces);
  }

 private:
  [[nodiscard]] Eigen::Vector3d across(const Eigen::Isometry3d& T_map_base, const Ray& beam) const;
  [[nodiscard]] Beam report(const Echo& echo, int index, Rng& rng) const;
  [[nodiscard]] float intensity(const Echo& echo) const;

  LidarConfig config_;
  std::optional<BeamLight> light_;           ///< Nothing if all light effects are off.
  std::vector<Eigen::Vector3d> directions_;  ///< Directions of the beams, in base.
  std::vector<double> offsets_;              ///< [m] Offsets of the beams; empty: all 0.
};

/// The robot's motion between two times.
struct Motion {
  std::chrono::nanoseconds begin{};
  std::chrono::nanoseconds end{};
  Eigen::Isometry3d T_map_base_begin = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d T_map_base_end = Eigen::Isometry3d::Identity();

  /// The pose at a time of the motion.
  [[nodiscard]] Eigen::Isometry3d at(std::chrono::nanoseconds stamp) const;
  /// Elapsed fraction of the motion at a time, in [0, 1].
  [[nodiscard]] double fraction(std::chrono::nanoseconds stamp) const;
};

/// A scan and the time of its last beam.
struct Sweep {
  std::chrono::nanoseconds last_beam{};
  LidarReading reading;
};

/// Collects beams into scans while the robot moves. The first scan starts at time 0, or
/// at the first scan time.
class LidarSweeper {
 public:
  /// @throws as `Lidar`.
  explicit LidarSweeper(const LidarConfig& config, const Surfaces& surfaces = {},
                        const LidarDraws& draws = {});

  /// Casts all beams due in [begin, end) of a motion; motions must follow each other without gaps
  /// in time. Returns the scans that were completed.
  std::vector<Sweep> advance(const Surroundings& around, const Motion& motion);
  /// From now on, hits are on these.
  void set_surfaces(const Surfaces& surfaces) { lidar_.set_surfaces(surfaces); }
  /// While covered, every beam is +inf and nothing is drawn.
  void set_covered(bool covered) { covered_ = covered; }

 private:
  void begin_scan(const Motion& motion);
  void end_scan(std::chrono::nanoseconds end);
  void misstate_stamp();
  void cast_column(const Surroundings& around, const Eigen::Isometry3d& T_map_base);

  Lidar lidar_;
  LidarDraws draws_;
  std::chrono::nanoseconds period_{};
  std::chrono::nanoseconds time_increment_{};
  std::chrono::nanoseconds scan_stamp_{};
  std::chrono::nanoseconds stated_stamp_{-1};  ///< Of the last scan.
  std::size_t scans_ = 0;                      ///< Number of complete scans.
  int next_beam_ = 0;                          ///< Common to all layers.
  bool covered_ = false;
  std::vector<std::uint32_t> last_primitives_;  ///< By layer.
  LidarReading reading_;
};

}  // namespace castaway::sim
