/// A planar lidar in a scene: single beams, and sweeps of a moving robot.
#pragma once

#include <chrono>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/random.hpp"
#include "sim/sensor/lidar_config.hpp"
#include "sim/sensor/moving_scene.hpp"
#include "sim/sensor/ray_scene.hpp"
#include "sim/sensor/readings.hpp"

namespace castaway::sim {

/// All that a beam can meet, floor aside. Holds references: the scenes must outlive it.
struct Surroundings {
  Surroundings(const RayScene& standing) : fixed(standing) {}  // NOLINT: a scene is surroundings.
  Surroundings(const RayScene& standing, const MovingScene& movers)
      : fixed(standing), moving(&movers) {}

  const RayScene& fixed;
  const MovingScene* moving = nullptr;  ///< May be missing.
};

/// The nearest hit of a ray within `max_distance` [m] in all surroundings; its `primitive` is of
/// the fixed scene, also where something that moves is in front of it. `guess`: as in
/// `RayScene::cast`.
std::optional<RayHit> cast(const Surroundings& around, const Ray& ray, double max_distance,
                           std::uint32_t guess = kNoPrimitive);

/// What one beam reports.
struct Beam {
  float range = 0.0F;                      ///< [m] +inf: nothing within range, -inf: too close.
  int object = kHitNothing;                ///< What it hit.
  std::uint32_t primitive = kNoPrimitive;  ///< As in `cast`: the next guess.
};

/// Casts beams from a mount on the base.
class Lidar {
 public:
  /// @throws std::invalid_argument if the settings cannot be.
  explicit Lidar(const LidarConfig& config);

  /// Casts beam `index` from the base's pose, then adds the noise. `guess`: as in `RayScene::cast`.
  [[nodiscard]] Beam cast(const Surroundings& around, const Eigen::Isometry3d& T_map_base,
                          int index, Rng& rng, std::uint32_t guess = kNoPrimitive) const;
  /// Beam `index` from the base's pose.
  [[nodiscard]] Ray ray(const Eigen::Isometry3d& T_map_base, int index) const;
  [[nodiscard]] const LidarConfig& config() const { return config_; }

 private:
  LidarConfig config_;
  std::vector<Eigen::Vector3d> directions_;  ///< Of the beams, in base.
};

/// A stretch of the robot's motion.
struct Motion {
  std::chrono::nanoseconds begin{};
  std::chrono::nanoseconds end{};
  Eigen::Isometry3d T_map_base_begin = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d T_map_base_end = Eigen::Isometry3d::Identity();

  /// The pose at a time of the stretch.
  [[nodiscard]] Eigen::Isometry3d at(std::chrono::nanoseconds stamp) const;
  /// How much of it is over then, in [0, 1].
  [[nodiscard]] double fraction(std::chrono::nanoseconds stamp) const;
};

/// A scan and the time of its last beam.
struct Sweep {
  std::chrono::nanoseconds last_beam{};
  LidarReading reading;
};

/// Gathers beams into scans while the robot moves. The first scan starts at time 0.
class LidarSweeper {
 public:
  explicit LidarSweeper(const LidarConfig& config);

  /// Casts all beams due in [begin, end) of a motion; motions must follow each other without gaps
  /// in time. Returns the scans that were completed.
  std::vector<Sweep> advance(const Surroundings& around, const Motion& motion, Rng& rng);
  /// While covered, every beam is +inf and nothing is drawn.
  void set_covered(bool covered) { covered_ = covered; }

 private:
  void begin_scan(const Motion& motion);
  Beam next_beam(const Surroundings& around, const Eigen::Isometry3d& T_map_base, Rng& rng);

  Lidar lidar_;
  std::chrono::nanoseconds period_{};
  std::chrono::nanoseconds time_increment_{};
  std::chrono::nanoseconds scan_stamp_{};
  int next_beam_ = 0;
  bool covered_ = false;
  std::uint32_t last_primitive_ = kNoPrimitive;
  LidarReading reading_;
};

}  // namespace castaway::sim
