#include "tools/sources/recorded_source.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace castaway::testbed {
namespace {

std::size_t position_of(const std::vector<std::size_t>& positions, std::size_t scan) {
  if (scan < positions.size()) return positions[scan];
  throw std::out_of_range("there is no scan " + std::to_string(scan) + ": the log has " +
                          std::to_string(positions.size()) + ", counted from 0");
}

const OdometryFrame& odometry_at(const Frames& frames, std::size_t position) {
  return std::get<OdometryFrame>(frames[position].data);
}

/// Shifts a frame in time and transforms its odometry by `T_new_old`.
void move_frame(Frame& frame, Stamp shift, const SE2& T_new_old) {
  frame.stamp += shift;
  if (auto* odometry = std::get_if<OdometryFrame>(&frame.data)) {
    odometry->odometry.stamp += shift;
    odometry->odometry.T_odom_base = T_new_old * odometry->odometry.T_odom_base;
  } else if (auto* scan = std::get_if<ScanFrame>(&frame.data)) {
    scan->scan.stamp += shift;
  } else {
    std::get<RunEvent>(frame.data).stamp += shift;
  }
}

/// Time from a scan to the next one; 0.1 s at the end of the log.
Stamp gap_after(const Frames& frames, const std::vector<std::size_t>& positions, std::size_t scan) {
  if (scan + 1 >= positions.size()) return std::chrono::milliseconds(100);
  const Stamp gap = frames[positions[scan + 1]].stamp - frames[positions[scan]].stamp;
  return std::max<Stamp>(gap, std::chrono::milliseconds(1));
}

}  // namespace

std::vector<std::size_t> scan_positions(const Frames& frames) {
  std::vector<std::size_t> positions;
  for (std::size_t i = 1; i < frames.size(); ++i) {
    if (std::holds_alternative<ScanFrame>(frames[i].data)) positions.push_back(i - 1);
  }
  return positions;
}

Frames stretch(const Frames& frames, std::size_t first, Stamp window) {
  const std::size_t begin = position_of(scan_positions(frames), first);
  Frames part;
  for (std::size_t i = begin; i < frames.size(); ++i) {
    if (frames[i].stamp - frames[begin].stamp > window) break;
    part.push_back(frames[i]);
  }
  return part;
}

Frames first_scans(const Frames& frames, std::size_t count) {
  Frames part;
  for (const Frame& frame : frames) {
    if (count == 0) break;
    part.push_back(frame);
    if (std::holds_alternative<ScanFrame>(frame.data)) --count;
  }
  return part;
}

Frames splice(const Frames& frames, const Splice& at) {
  if (at.from_first > at.from) throw std::invalid_argument("a splice ends before it begins");
  const std::vector<std::size_t> positions = scan_positions(frames);
  const std::size_t begin = position_of(positions, at.from_first);
  const std::size_t last = position_of(positions, at.from) + 1;
  const std::size_t next = position_of(positions, at.to);
  Frames part(frames.begin() + static_cast<std::ptrdiff_t>(begin),
              frames.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  const OdometryFrame& before = odometry_at(frames, last - 1);
  const OdometryFrame& after = odometry_at(frames, next);
  const Stamp jump = frames[last].stamp + gap_after(frames, positions, at.from);
  const Stamp shift = jump - frames[next].stamp;
  const SE2 T_new_old = before.odometry.T_odom_base * after.odometry.T_odom_base.inverse();
  part.emplace_back();
  part.back().stamp = jump;
  part.back().data =
      RunEvent{jump, EventKind::kKidnap, "splice", before.T_map_base_true, after.T_map_base_true};
  for (std::size_t i = next; i < frames.size(); ++i) {
    if (frames[i].stamp - frames[next].stamp > at.window) break;
    part.push_back(frames[i]);
    move_frame(part.back(), shift, T_new_old);
  }
  return part;
}

std::optional<Frame> RecordedSource::next() {
  if (next_ == frames_.size()) return std::nullopt;
  return frames_[next_++];
}

std::optional<SE2> RecordedSource::start_pose() const {
  for (const Frame& frame : frames_) {
    const auto* odometry = std::get_if<OdometryFrame>(&frame.data);
    if (odometry != nullptr && odometry->T_map_base_true) return odometry->T_map_base_true;
  }
  return std::nullopt;
}

Stamp RecordedSource::duration() const {
  return frames_.empty() ? Stamp{} : frames_.back().stamp - frames_.front().stamp;
}

}  // namespace castaway::testbed
