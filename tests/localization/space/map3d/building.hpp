/// A small building of two floors with a ramp between them, for tests; and scans taken in it.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include "castaway/readings.hpp"
#include "localization/geometry/random.hpp"
#include "localization/sensor/scan_points.hpp"
#include "localization/space/map3d/survey_ground.hpp"
#include "localization/space/map3d/voxel_builder.hpp"
#include "localization/space/volume/volume.hpp"
#include "tests/localization/matching/search_case.hpp"

namespace castaway::test {

/// The lower floor: x from -12 to 10 m, y from 0 to 8 m, at 0; the upper one: x from 5 to 10 m, at
/// 3 m. A ramp of 20 % leads up in the lane y > 6 from x = -10 m. Walls around both floors, and
/// pillars at random.
class Building {
 public:
  explicit Building(Rng& rng, int pillars = 10)
      : volume_(std::make_shared<Volume>(survey(rng, pillars))) {}

  [[nodiscard]] const Volume& volume() const { return *volume_; }
  [[nodiscard]] std::shared_ptr<const Volume> shared() const { return volume_; }

  /// A pose in the atlas, on drivable ground, with all wheels on it.
  [[nodiscard]] SE2 sample(Rng& rng) const {
    const GridFrame& frame = volume_->atlas().frame();
    while (true) {
      const Eigen::Vector2i cell(static_cast<int>(uniform(0.0, frame.width, rng)),
                                 static_cast<int>(uniform(0.0, frame.height, rng)));
      const Eigen::Vector2d p = frame.T_map_grid * frame.centre_of(cell);
      const SE2 pose{p.x(), p.y(), uniform(-std::numbers::pi, std::numbers::pi, rng)};
      if (volume_->atlas().is_own(cell) && volume_->lift(pose)) return pose;
    }
  }

  /// Points of a lidar 0.3 m above base: beams in rings at these elevations [rad], without noise.
  [[nodiscard]] ScanPoints scan(const SE2& T_atlas_base, int beams,
                                const std::vector<double>& elevations = {0.0}) const {
    const Eigen::Isometry3d T_map_base = volume_->lift(T_atlas_base)->T_map_base;
    ScanPoints points;
    for (const double elevation : elevations) {
      for (int i = 0; i < beams; ++i) {
        const Eigen::Vector3d direction = direction_of(i, beams, elevation);
        if (const auto r = range(T_map_base, direction)) add_point(direction, *r, points);
      }
    }
    return points;
  }
  /// A scan of the planar lidar. Ranges have 1 cm of noise.
  [[nodiscard]] LaserScan laser_scan(const SE2& T_atlas_base, int beams, Rng& rng) const {
    LaserScan scan;
    scan.angle_increment = 2.0 * std::numbers::pi / beams;
    scan.range_min = 0.2;
    scan.range_max = kFarthest;
    scan.T_base_laser.translation().z() = kLidar;
    const auto there = volume_->lift(T_atlas_base);
    for (int i = 0; there && i < beams; ++i) {
      const auto r = range(there->T_map_base, direction_of(i, beams, 0.0));
      const double noise = uniform(-0.017, 0.017, rng);
      scan.ranges.push_back(static_cast<float>(r ? *r + noise : 1e9));
    }
    return scan;
  }

 private:
  static constexpr double kFine = 0.04;      // [m] Between samples.
  static constexpr double kLidar = 0.3;      // [m]
  static constexpr double kFarthest = 25.0;  // [m]
  static inline const Eigen::Vector3d kLidarAt{0.0, 0.0, kLidar};

  using Height = std::function<double(double, double)>;

  static void add_floor(VoxelBuilder& builder, const Eigen::Vector4d& area, const Height& z) {
    for (double x = area[0] + kFine / 2; x < area[1]; x += kFine) {
      for (double y = area[2] + kFine / 2; y < area[3]; y += kFine) builder.add({x, y, z(x, y)});
    }
  }
  /// Vertical walls around an area.
  static void add_walls(VoxelBuilder& builder, const Eigen::Vector4d& area, double low,
                        double high) {
    for (double z = low + kFine; z < high; z += kFine) {
      for (double x = area[0]; x < area[1]; x += kFine) {
        builder.add({x, area[2], z}, false);
        builder.add({x, area[3], z}, false);
      }
      for (double y = area[2]; y < area[3]; y += kFine) {
        builder.add({area[0], y, z}, false);
        builder.add({area[1], y, z}, false);
      }
    }
  }
  static Volume survey(Rng& rng, int pillars) {
    VoxelBuilder builder(0.1);
    const auto level = [](double z) { return [z](double, double) { return z; }; };
    add_floor(builder, {-12, 10, 0, 6}, level(0.0));
    add_floor(builder, {-12, -10, 6, 8}, level(0.0));
    add_floor(builder, {5, 10, 0, 8}, level(2.8));
    add_floor(builder, {5, 10, 0, 8}, level(3.0));
    add_floor(builder, {-10, 5, 6, 8}, [](double x, double) { return 0.2 * (x + 10); });
    add_walls(builder, {-12, 10, 0, 8}, 0.0, 5.0);
    for (int i = 0; i < pillars; ++i) {
      const bool above = i % 3 == 0;
      const double x = above ? uniform(5.5, 9.0, rng) : uniform(-11.0, 9.0, rng);
      const double y = uniform(0.5, 5.0, rng);
      const double w = uniform(0.2, 0.8, rng);
      add_walls(builder, {x, x + w, y, y + w}, above ? 3.0 : 0.0, above ? 4.5 : 1.5);
    }
    VoxelMap voxels = builder.build();
    ElevationMap ground = survey_ground(voxels, GroundConfig{});
    return {std::move(voxels), std::move(ground), VolumeConfig{}};
  }
  static Eigen::Vector3d direction_of(int beam, int beams, double elevation) {
    const double angle = 2.0 * std::numbers::pi * beam / beams;
    return {std::cos(angle) * std::cos(elevation), std::sin(angle) * std::cos(elevation),
            std::sin(elevation)};
  }
  /// Where a beam in base meets a surface; nothing if it does not. [m]
  [[nodiscard]] std::optional<double> range(const Eigen::Isometry3d& T_map_base,
                                            const Eigen::Vector3d& direction) const {
    for (double r = 0.3; r < kFarthest;) {
      const Eigen::Vector3d p_map = T_map_base * (kLidarAt + r * direction);
      const double clear = volume_->surfaces().at(p_map.cast<float>());
      if (clear <= 0.02) return r;
      r += std::max(0.01, 0.5 * clear);
    }
    return std::nullopt;
  }
  static void add_point(const Eigen::Vector3d& direction, double r, ScanPoints& points) {
    const Eigen::Vector3f p = (kLidarAt + r * direction).cast<float>();
    points.x.push_back(p.x());
    points.y.push_back(p.y());
    points.z.push_back(p.z());
    points.origin_x.push_back(0.0F);
    points.origin_y.push_back(0.0F);
    points.origin_z.push_back(static_cast<float>(kLidar));
    points.range.push_back(static_cast<float>(r * direction.head<2>().norm()));
  }

  std::shared_ptr<const Volume> volume_;
};

}  // namespace castaway::test
