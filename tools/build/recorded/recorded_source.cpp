#include "tools/build/recorded/recorded_source.hpp"

#include <stdexcept>
#include <string>

namespace castaway::testbed {
namespace {

std::size_t position_of(const std::vector<std::size_t>& positions, std::size_t scan) {
  if (scan < positions.size()) return positions[scan];
  throw std::out_of_range("there is no scan " + std::to_string(scan) + ": the log has " +
                          std::to_string(positions.size()) + ", counted from 0");
}

}  // namespace

std::vector<std::size_t> scan_positions(const Frames& frames) {
  std::vector<std::size_t> positions;
  std::optional<std::size_t> odometry;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (std::holds_alternative<OdometryFrame>(frames[i].data)) odometry = i;
    if (odometry && std::holds_alternative<ScanFrame>(frames[i].data)) {
      positions.push_back(*odometry);
    }
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

std::optional<double> height_of(const OdometryFrame& frame) {
  if (!T_footprint_base_of(frame.true_pose)) return std::nullopt;
  return frame.true_pose->z();
}

std::optional<Frame> RecordedSource::next() {
  if (next_ == frames_.size()) return std::nullopt;
  return frames_[next_++];
}

const OdometryFrame* RecordedSource::first_truth() const {
  for (const Frame& frame : frames_) {
    const auto* odometry = std::get_if<OdometryFrame>(&frame.data);
    if (odometry != nullptr && odometry->true_pose) return odometry;
  }
  return nullptr;
}

std::optional<SE2> RecordedSource::start_pose() const {
  const OdometryFrame* first = first_truth();
  return first != nullptr ? T_map_base_of(first->true_pose) : std::nullopt;
}

std::optional<double> RecordedSource::start_height() const {
  const OdometryFrame* first = first_truth();
  return first != nullptr ? height_of(*first) : std::nullopt;
}

Stamp RecordedSource::duration() const {
  return frames_.empty() ? Stamp{} : frames_.back().stamp - frames_.front().stamp;
}

}  // namespace castaway::testbed
