/// Plays a recorded log with jumps: kidnaps made from recorded data.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "tools/build/recorded/recorded_source.hpp"

namespace castaway::testbed {

/// A jump to another scan of a log.
struct LogJump {
  std::size_t after_scans = 0;  ///< It takes place once so many scans have been played.
  std::size_t to_scan = 0;      ///< Index in the log of the first scan after it.
};

/// The part of a log that is played.
struct SplicedPart {
  std::size_t from_scan = 0;           ///< Index of the first scan.
  std::optional<std::size_t> scans{};  ///< How many scans; nothing: to the end of the log.
  std::vector<LogJump> jumps{};        ///< In order of `after_scans`, each of which is above 0.
};

/// Plays frames in which every scan comes after an odometry reading. At a jump, a kidnap event
/// comes between the scans; odometry continues without a jump, and the time of the gap is the one
/// recorded after the last scan.
class SplicedSource final : public SensorSource {
 public:
  /// Throws std::out_of_range if the log has no scan that `part` plays or jumps to,
  /// std::invalid_argument if its jumps are not in order.
  SplicedSource(std::shared_ptr<const Frames> frames, SplicedPart part);

  std::optional<Frame> next() override;
  /// Jumps to a scan after the last delivery if that was a scan, otherwise after the next scan.
  /// Returns the jump. Throws std::out_of_range if the log has no such scan.
  LogJump jump(std::size_t to_scan);

  /// Number of scans in the log.
  [[nodiscard]] std::size_t scans() const { return scans_.size(); }
  /// Index in the log of the last scan that was delivered, or of the first one to be.
  [[nodiscard]] std::size_t last_scan() const { return last_scan_; }
  /// True pose of base at the last odometry: the last one that is known, carried on by odometry.
  /// Nothing if none is since the last jump.
  [[nodiscard]] std::optional<SE2> true_pose() const;
  /// Height, roll and pitch of base in that pose, not carried on; nothing if they are unknown.
  [[nodiscard]] std::optional<Eigen::Isometry3d> T_footprint_base() const {
    return last_known_ ? last_known_->true_pose->T_footprint_base : std::nullopt;
  }
  /// Those that took place, and the one that is to come.
  [[nodiscard]] const std::vector<LogJump>& jumps() const { return part_.jumps; }
  /// Scans delivered so far.
  [[nodiscard]] std::size_t played() const { return played_; }

  void set_drive_pose(const std::optional<SE2>&) override {}
  void set_watched_pose(const std::optional<SE2>&, double) override {}
  /// True pose at the beginning of the part; nothing if it is unknown within the first second.
  [[nodiscard]] std::optional<SE2> start_pose() const override { return start_; }
  /// [m] Height of that pose; nothing if it is unknown.
  [[nodiscard]] std::optional<double> start_height() const { return start_height_; }
  /// That of the whole log.
  [[nodiscard]] Stamp duration() const override;
  [[nodiscard]] std::map<std::string, std::chrono::nanoseconds> cpu_by_stage() const override {
    return {};
  }
  [[nodiscard]] std::vector<std::string> warnings() const override { return {}; }

 private:
  void check_part() const;
  void require_scan(std::size_t scan) const;
  [[nodiscard]] std::size_t odometry_of(std::size_t scan) const;
  [[nodiscard]] Stamp gap_after(std::size_t scan) const;
  Frame make_jump(std::size_t to_scan);

  std::shared_ptr<const Frames> frames_;
  std::vector<std::size_t> scans_;  ///< Their indices in `frames_`.
  SplicedPart part_;
  std::optional<SE2> start_;
  std::optional<double> start_height_;
  std::size_t next_ = 0;       ///< Index in `frames_`.
  std::size_t next_jump_ = 0;  ///< Index in `part_.jumps`.
  std::size_t played_ = 0;
  std::size_t last_scan_ = 0;
  bool after_scan_ = false;  ///< The last delivery was a scan.
  Stamp now_{};
  OdometryFrame last_odometry_;              ///< As it was delivered.
  std::optional<OdometryFrame> last_known_;  ///< The same with a true pose, since the last jump.
  Stamp shift_{};                            ///< Of stamps, by the jumps so far.
  SE2 T_new_old_;                            ///< Of odometry, by the jumps so far.
};

/// Makes a kidnap from recorded data. The frames from scan `from_first` to scan `from` are followed
/// by those from scan `to` on for `window`.
struct Splice {
  std::size_t from_first = 0;   ///< Index of the first scan played.
  std::size_t from = 0;         ///< Index of the last scan before the jump.
  std::size_t to = 0;           ///< Index of the first scan after the jump.
  Stamp window = Stamp::max();  ///< Duration after the jump.
};

/// Returns its frames, with a jump as of `SplicedSource`. Throws std::out_of_range if there are no
/// such scans, std::invalid_argument if from_first > from.
Frames splice(const Frames& frames, const Splice& at);

/// All frames of a source.
Frames all_frames(SensorSource& source);

}  // namespace castaway::testbed
