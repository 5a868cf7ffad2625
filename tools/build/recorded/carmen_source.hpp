/// A recorded CARMEN log as a source of sensor data.
///
/// ODOM becomes odometry. A scan becomes odometry at its odometry pose followed by the scan at the
/// same stamp. A TRUEPOS directly after a scan is the truth of both.
///
/// Mount of the lidar: laser pose relative to the robot pose of the same line if they differ,
/// otherwise forward by PARAM robot_frontlaser_offset. Angles of FLASER: from -90 deg (half the
/// PARAM laser_front_laser_fov if that is above 180), in steps of PARAM
/// laser_front_laser_resolution if the number of beams matches it, otherwise in steps of 180 / (n -
/// 1) deg: 180 beams of 1 deg end at +89 deg. Ranges of at least PARAM robot_front_laser_max
/// (ROBOTLASER1: its own maximum) are no returns; ranges of 0 are invalid.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "tools/run/sensor_source.hpp"

namespace castaway::testbed {

/// The part of a log to play.
struct CarmenSourceConfig {
  enum class Scans { kAll, kEven, kOdd };

  std::int64_t from_scan = 0;           ///< Index in the log of the first scan to play.
  std::optional<std::int64_t> scans{};  ///< Number of scans to play; nothing for all.
  Scans selection = Scans::kAll;        ///< By index in the log; only the odometry of the others is
                                        ///< played.
  double fallback_range_max = 80.0;     ///< [m] Used if the log has no PARAM robot_front_laser_max.
  double lidar_height = 0.0;            ///< [m] Above the ground, which no log states.
};

/// The height of a log's lidar on a 3-D map [m], which must be stated. Throws
/// std::invalid_argument.
double stated_lidar_height(const std::optional<double>& base_height);

/// Plays a log that it holds in memory. Nothing before the first scan is delivered, so `start_pose`
/// is the pose at the first frame.
class CarmenSource final : public SensorSource {
 public:
  /// Throws std::runtime_error "file:line: ..." on a malformed line, or if there is no scan to
  /// play.
  explicit CarmenSource(const std::filesystem::path& path, const CarmenSourceConfig& config = {});

  std::optional<Frame> next() override;
  void set_drive_pose(const std::optional<SE2>&) override {}
  void set_watched_pose(const std::optional<SE2>&, double) override {}
  [[nodiscard]] std::optional<SE2> start_pose() const override;
  [[nodiscard]] Stamp duration() const override;
  [[nodiscard]] std::map<std::string, std::chrono::nanoseconds> cpu_by_stage() const override {
    return {};
  }
  [[nodiscard]] std::vector<std::string> warnings() const override { return {}; }

  /// Number of stamps that ran backwards and were set to the previous one.
  [[nodiscard]] std::int64_t repaired_stamps() const { return repaired_stamps_; }

 private:
  std::vector<Frame> frames_;
  std::size_t next_ = 0;
  std::int64_t repaired_stamps_ = 0;
};

}  // namespace castaway::testbed
