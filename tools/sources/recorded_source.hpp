/// Recorded frames as a source: a stretch of a log, or two stretches spliced into a kidnap.
#pragma once

#include <memory>
#include <vector>

#include "tools/run/sensor_source.hpp"

namespace castaway::testbed {

/// The frames of a log, shared by the runs over it.
using Frames = std::vector<Frame>;

/// Index in `frames` of the odometry that comes with each scan, in order of the scans.
std::vector<std::size_t> scan_positions(const Frames& frames);

/// A stretch from scan `first` (its odometry included) for `window`, at most to the end of the log.
/// Throws std::out_of_range unless there is such a scan.
Frames stretch(const Frames& frames, std::size_t first, Stamp window);

/// The frames up to the `count`-th scan.
Frames first_scans(const Frames& frames, std::size_t count);

/// A kidnap in recorded data: the stretch from scan `from_first` up to scan `from`, then the log
/// goes on at scan `to` for `window`, while odometry runs on smoothly and time goes on by as much
/// as it did after scan `from`. A kidnap event stands between. Throws std::out_of_range unless
/// there are such scans, std::invalid_argument if from_first > from.
struct Splice {
  std::size_t from_first = 0;   ///< Index of the first scan played.
  std::size_t from = 0;         ///< Index of the last scan before the jump.
  std::size_t to = 0;           ///< Index of the first scan after it.
  Stamp window = Stamp::max();  ///< How long the log goes on after the jump.
};
Frames splice(const Frames& frames, const Splice& at);

/// Plays frames that it holds.
class RecordedSource final : public SensorSource {
 public:
  explicit RecordedSource(Frames frames) : frames_(std::move(frames)) {}

  std::optional<Frame> next() override;
  void set_drive_pose(const std::optional<SE2>&) override {}
  void set_watched_pose(const std::optional<SE2>&) override {}
  /// True pose at the first frame that knows it.
  [[nodiscard]] std::optional<SE2> start_pose() const override;
  /// Time from the first frame to the last.
  [[nodiscard]] Stamp duration() const override;
  [[nodiscard]] std::map<std::string, std::chrono::nanoseconds> cpu_by_stage() const override {
    return {};
  }
  [[nodiscard]] std::vector<std::string> warnings() const override { return {}; }

 private:
  Frames frames_;
  std::size_t next_ = 0;
};

}  // namespace castaway::testbed
