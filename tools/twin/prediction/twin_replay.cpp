#include "tools/twin/prediction/twin_replay.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/twin/alignment/aligned_path.hpp"
#include "tools/twin/twin_text.hpp"

namespace castaway::testbed {
namespace {

using localization::TransformBuffer;

/// Odometry a little before the first scan and after the last one is kept: it may be theirs.
constexpr Stamp kAround = std::chrono::milliseconds(200);

/// Time span of the scans that a twin plays, on odometry's clock.
struct PlayedTime {
  Stamp first{};
  Stamp last{};

  [[nodiscard]] bool has_scan(Stamp stamp) const { return first <= stamp && stamp <= last; }
  [[nodiscard]] bool has(Stamp stamp) const {
    return first - kAround <= stamp && stamp <= last + kAround;
  }
  [[nodiscard]] Stamp clamp(Stamp stamp) const { return std::clamp(stamp, first, last); }
};

PlayedTime played_time(const AlignedLog& log) {
  return {log.scans.front().scan.stamp, log.scans.back().scan.stamp};
}

TransformBuffer unlimited() { return TransformBuffer({.length = Stamp::max() / 4}); }

TransformBuffer aligned_poses(const AlignedLog& log) {
  TransformBuffer T_map_base = unlimited();
  for (const PathPose& pose : path_of(log)) T_map_base.add(pose.stamp, pose.T_map_base);
  return T_map_base;
}

/// What a twin measured, by time of the twin.
struct TwinData {
  TransformBuffer T_odom_axle = unlimited();
  std::vector<const LaserScan*> scans;
};

TwinData data_of(const Frames& twin) {
  TwinData data;
  for (const Frame& frame : twin) {
    if (const auto* odometry = std::get_if<OdometryFrame>(&frame.data)) {
      data.T_odom_axle.add(odometry->odometry.stamp, odometry->odometry.T_odom_base);
    } else if (const auto* scan = std::get_if<ScanFrame>(&frame.data)) {
      data.scans.push_back(&scan->scan);
    }
  }
  return data;
}

/// Shifts the twin's odometry by the errors of the twin's scan stamps. The replay keeps the log's
/// stamps and poses at the scans, so the errors can only be shown by odometry.
class ScanClock {
 public:
  /// `times`: when the scans of the twin began.
  ScanClock(std::vector<Stamp> times, const std::vector<const LaserScan*>& scans)
      : times_(std::move(times)) {
    const std::size_t count = std::min(times_.size(), scans.size());
    times_.resize(count);
    Stamp sum{};
    for (std::size_t i = 0; i < count; ++i) {
      errors_.push_back(scans[i]->stamp - times_[i]);
      sum += errors_.back();
    }
    const Stamp mean = count > 0 ? sum / static_cast<std::int64_t>(count) : Stamp{};
    for (Stamp& error : errors_) error -= mean;  // A constant one is in the log's own stamps.
  }

  /// Time of the twin's odometry that the log's odometry of a time shows.
  [[nodiscard]] Stamp at(Stamp time) const {
    const auto next = std::upper_bound(times_.begin(), times_.end(), time);
    if (next == times_.begin() || next == times_.end()) return time;
    const auto i = static_cast<std::size_t>(next - times_.begin());
    const double part = seconds(time - times_[i - 1]) / seconds(times_[i] - times_[i - 1]);
    const double error = seconds(errors_[i - 1]) + part * seconds(errors_[i] - errors_[i - 1]);
    return time + localization::from_seconds(error);
  }

 private:
  std::vector<Stamp> times_;
  std::vector<Stamp> errors_;
};

/// Ranges of the twin by beam of the log: the twin's beams all turn counter-clockwise.
std::vector<float> ranges_for(const LaserScan& scan, const std::vector<float>& twin) {
  if (scan.angle_increment >= 0.0) return twin;
  return {twin.rbegin(), twin.rend()};
}

/// Stamp of the last odometry up to a time; that time if there is none.
Stamp last_odometry_before(const Frames& frames, Stamp time) {
  std::optional<Stamp> last;
  for (const Frame& frame : frames) {
    const auto* odometry = std::get_if<OdometryFrame>(&frame.data);
    if (odometry == nullptr || odometry->odometry.stamp > time) continue;
    last = std::max(last.value_or(odometry->odometry.stamp), odometry->odometry.stamp);
  }
  return last.value_or(time);
}

}  // namespace

RecordedPlace played_part(const RecordedPlace& place, const AlignedLog& log) {
  const PlayedTime time = played_time(log);
  const Stamp last_before = last_odometry_before(place.frames, time.first);
  const std::string& lidar = log.scans.front().scan.lidar;
  const TransformBuffer T_map_base = log.by_truth ? unlimited() : aligned_poses(log);
  RecordedPlace played{place.name, {}, place.map};
  for (const Frame& frame : place.frames) {
    Frame copy = frame;
    if (auto* odometry = std::get_if<OdometryFrame>(&copy.data)) {
      const Stamp stamp = odometry->odometry.stamp;
      if (!time.has(stamp) && stamp != last_before) continue;
      if (!log.by_truth) odometry->true_pose = T_map_base.at(time.clamp(stamp));
    } else if (auto* scan = std::get_if<ScanFrame>(&copy.data)) {
      const Stamp stamp = scan->scan.stamp + log.stamp_correction;
      if (scan->scan.lidar != lidar || !time.has_scan(stamp)) continue;
      if (!log.by_truth) scan->true_pose = T_map_base.at(stamp);
    } else if (!time.has(frame.stamp)) {
      continue;
    }
    played.frames.push_back(std::move(copy));
  }
  return played;
}

Frames replay_in_twin(const RecordedPlace& played, const AlignedLog& log, const Frames& twin) {
  const PlayedTime time = played_time(log);
  const TwinData data = data_of(twin);
  const ScanClock clock(played_times(log), data.scans);
  const SE2 T_axle_drive{motion_of(log).axle_m, 0.0, 0.0};
  Frames replay = played.frames;
  std::size_t scans = 0;
  for (Frame& frame : replay) {
    if (auto* odometry = std::get_if<OdometryFrame>(&frame.data)) {
      const Stamp at = time.clamp(odometry->odometry.stamp) - time.first;
      const Stamp shown = std::clamp(clock.at(at), Stamp{}, time.last - time.first);
      odometry->odometry.T_odom_base = data.T_odom_axle.at(shown).value() * T_axle_drive;
    } else if (auto* scan = std::get_if<ScanFrame>(&frame.data)) {
      if (scans < data.scans.size()) {
        scan->scan.ranges = ranges_for(scan->scan, data.scans[scans]->ranges);
      }
      ++scans;
    }
  }
  if (scans != data.scans.size()) {
    throw std::runtime_error(
        fmt::format("{}: {} scans, and {} in its twin", played.name, scans, data.scans.size()));
  }
  return replay;
}

}  // namespace castaway::testbed
