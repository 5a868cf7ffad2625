/// A recorded CARMEN log as a source of sensor data.
///
/// ODOM becomes odometry; a scan becomes odometry at its odometry pose and, at the same stamp, the
/// scan; a TRUEPOS right behind a scan is the truth of both.
///
/// Mount of the lidar: laser pose against robot pose of the line where they differ, otherwise
/// forward by PARAM robot_frontlaser_offset. Angles of FLASER: from -90 deg (half the PARAM
/// laser_front_laser_fov where that is above 180) in steps of PARAM laser_front_laser_resolution
/// where the number of beams fits it, in steps of 180 / (n - 1) deg otherwise: 180 beams of 1 deg
/// end at +89 deg. Ranges from PARAM robot_front_laser_max (ROBOTLASER1: its own maximum) on are no
/// returns; ranges of 0 are invalid.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "tools/run/sensor_source.hpp"

namespace castaway::testbed {

/// Which part of a log is played.
struct CarmenSourceConfig {
  enum class Scans { kAll, kEven, kOdd };

  std::int64_t from_scan = 0;           ///< Index in the log of the first scan played.
  std::optional<std::int64_t> scans{};  ///< How many scans are played; nothing: all.
  Scans selection = Scans::kAll;        ///< By index in the log; of the others, odometry only.
  double fallback_range_max = 80.0;     ///< [m] Where the log has no PARAM robot_front_laser_max.
};

/// Plays a log that it holds in memory. Nothing before the first scan played is delivered, so that
/// `start_pose` is the pose at the first frame.
class CarmenSource final : public SensorSource {
 public:
  /// Throws std::runtime_error "file:line: ..." on a broken line, or if there is no scan to play.
  explicit CarmenSource(const std::filesystem::path& path, const CarmenSourceConfig& config = {});

  std::optional<Frame> next() override;
  void set_drive_pose(const std::optional<SE2>&) override {}
  void set_watched_pose(const std::optional<SE2>&) override {}
  [[nodiscard]] std::optional<SE2> start_pose() const override;
  [[nodiscard]] Stamp duration() const override;
  [[nodiscard]] std::map<std::string, std::chrono::nanoseconds> cpu_by_stage() const override {
    return {};
  }
  [[nodiscard]] std::vector<std::string> warnings() const override { return {}; }

  /// Stamps that ran backwards and were set to the one before.
  [[nodiscard]] std::int64_t repaired_stamps() const { return repaired_stamps_; }
  /// Scans that are played, and how many of them have a truth.

 private:
  std::vector<Frame> frames_;
  std::size_t next_ = 0;
  std::int64_t repaired_stamps_ = 0;
};

}  // namespace castaway::testbed
