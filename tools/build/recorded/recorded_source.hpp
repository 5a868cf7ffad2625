/// Plays recorded frames: a log, or a part of it.
#pragma once

#include <memory>
#include <vector>

#include "tools/run/sensor_source.hpp"

namespace castaway::testbed {

/// The frames of a log, shared by the runs over it.
using Frames = std::vector<Frame>;

/// Index in `frames` of the last odometry before each scan, in the order of the scans. Scans before
/// all odometry are left out.
std::vector<std::size_t> scan_positions(const Frames& frames);

/// Frames from scan `first` (with its odometry) on for `window`, or to the end of the log. Throws
/// std::out_of_range if there is no such scan.
Frames stretch(const Frames& frames, std::size_t first, Stamp window);

/// [m] Height of base; nothing if it is unknown.
std::optional<double> height_of(const OdometryFrame& frame);

/// Plays frames that it owns.
class RecordedSource final : public SensorSource {
 public:
  explicit RecordedSource(Frames frames) : frames_(std::move(frames)) {}

  std::optional<Frame> next() override;
  void set_drive_pose(const std::optional<SE2>&) override {}
  void set_watched_pose(const std::optional<SE2>&, double) override {}
  /// True pose at the first frame for which it is known.
  [[nodiscard]] std::optional<SE2> start_pose() const override;
  /// [m] Height of that pose; nothing if it is unknown.
  [[nodiscard]] std::optional<double> start_height() const;
  /// Time from the first frame to the last.
  [[nodiscard]] Stamp duration() const override;
  [[nodiscard]] std::map<std::string, std::chrono::nanoseconds> cpu_by_stage() const override {
    return {};
  }
  [[nodiscard]] std::vector<std::string> warnings() const override { return {}; }

 private:
  [[nodiscard]] const OdometryFrame* first_truth() const;

  Frames frames_;
  std::size_t next_ = 0;
};

}  // namespace castaway::testbed
