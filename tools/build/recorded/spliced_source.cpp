#include "tools/build/recorded/spliced_source.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace castaway::testbed {
namespace {

bool is_odometry(const Frame& frame) { return std::holds_alternative<OdometryFrame>(frame.data); }

std::vector<std::size_t> scan_indices(const Frames& frames) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (std::holds_alternative<ScanFrame>(frames[i].data)) indices.push_back(i);
  }
  return indices;
}

/// The first odometry with a true pose from `begin` on, within a second.
std::optional<OdometryFrame> first_truth(const Frames& frames, std::size_t begin) {
  for (std::size_t i = begin; i < frames.size(); ++i) {
    if (frames[i].stamp - frames[begin].stamp > std::chrono::seconds(1)) break;
    const auto* odometry = std::get_if<OdometryFrame>(&frames[i].data);
    if (odometry != nullptr && odometry->true_pose) return *odometry;
  }
  return std::nullopt;
}

/// Shifts a frame in time and transforms its odometry by `T_new_old`.
void move_frame(Frame& frame, Stamp shift, const SE2& T_new_old) {
  frame.stamp += shift;
  std::visit([shift](auto& data) { own_stamp(data) += shift; }, frame.data);
  if (auto* odometry = std::get_if<OdometryFrame>(&frame.data)) {
    odometry->odometry.T_odom_base = T_new_old * odometry->odometry.T_odom_base;
  }
}

}  // namespace

SplicedSource::SplicedSource(std::shared_ptr<const Frames> frames, SplicedPart part)
    : frames_(std::move(frames)), scans_(scan_indices(*frames_)), part_(std::move(part)) {
  check_part();
  next_ = part_.from_scan == 0 ? 0 : odometry_of(part_.from_scan);
  last_scan_ = part_.from_scan;
  if (const auto start = first_truth(*frames_, next_)) {
    start_ = start->true_pose->T_map_base;
    start_height_ = height_of(*start);
  }
}

void SplicedSource::check_part() const {
  std::size_t first = part_.from_scan;
  std::size_t played = 0;
  require_scan(first);
  for (const LogJump& jump : part_.jumps) {
    if (jump.after_scans <= played) {
      throw std::invalid_argument("jumps of a log come in order, each after one scan at least");
    }
    require_scan(first + (jump.after_scans - played) - 1);
    require_scan(jump.to_scan);
    first = jump.to_scan;
    played = jump.after_scans;
  }
}

void SplicedSource::require_scan(std::size_t scan) const {
  if (scan < scans_.size()) return;
  throw std::out_of_range("there is no scan " + std::to_string(scan) + ": the log has " +
                          std::to_string(scans_.size()) + ", counted from 0");
}

/// Index of the last odometry before a scan; without one, of the next.
std::size_t SplicedSource::odometry_of(std::size_t scan) const {
  const Frames& frames = *frames_;
  for (std::size_t i = scans_[scan]; i > 0; --i) {
    if (is_odometry(frames[i - 1])) return i - 1;
  }
  for (std::size_t i = scans_[scan]; i < frames.size(); ++i) {
    if (is_odometry(frames[i])) return i;
  }
  throw std::out_of_range("the log has no odometry to jump to");
}

/// Time from a scan to the next one; 0.1 s at the end of the log.
Stamp SplicedSource::gap_after(std::size_t scan) const {
  if (scan + 1 >= scans_.size()) return std::chrono::milliseconds(100);
  const Stamp gap = (*frames_)[scans_[scan + 1]].stamp - (*frames_)[scans_[scan]].stamp;
  return std::max<Stamp>(gap, std::chrono::milliseconds(1));
}

Frame SplicedSource::make_jump(std::size_t to_scan) {
  next_ = odometry_of(to_scan);
  const Frame& target = (*frames_)[next_];
  const auto& after = std::get<OdometryFrame>(target.data);
  const Stamp at = now_ + gap_after(last_scan_);
  shift_ = at - target.stamp;
  T_new_old_ = last_odometry_.odometry.T_odom_base * after.odometry.T_odom_base.inverse();
  last_scan_ = to_scan;
  last_known_.reset();
  after_scan_ = false;
  KidnapEvent splice{KidnapEvent::Splice{}};
  const std::optional<double> z_from = height_of(last_odometry_);
  const std::optional<double> z_to = height_of(after);
  if (z_from && z_to) splice.heights = {{*z_from, *z_to}};
  return {at, RunEvent{at, splice, T_map_base_of(last_odometry_.true_pose),
                       T_map_base_of(after.true_pose)}};
}

std::optional<Frame> SplicedSource::next() {
  if (part_.scans && played_ >= *part_.scans) return std::nullopt;
  const bool jumps = after_scan_ && next_jump_ < part_.jumps.size() &&
                     part_.jumps[next_jump_].after_scans == played_;
  if (jumps) return make_jump(part_.jumps[next_jump_++].to_scan);
  if (next_ == frames_->size()) return std::nullopt;
  Frame frame = (*frames_)[next_];
  move_frame(frame, shift_, T_new_old_);
  after_scan_ = std::holds_alternative<ScanFrame>(frame.data);
  if (after_scan_) {
    ++played_;
    last_scan_ = static_cast<std::size_t>(std::ranges::lower_bound(scans_, next_) - scans_.begin());
  }
  if (const auto* odometry = std::get_if<OdometryFrame>(&frame.data)) {
    last_odometry_ = *odometry;
    if (odometry->true_pose) last_known_ = *odometry;
  }
  now_ = frame.stamp;
  ++next_;
  return frame;
}

LogJump SplicedSource::jump(std::size_t to_scan) {
  require_scan(to_scan);
  part_.jumps.resize(next_jump_);  // One that has not taken place yet is replaced.
  part_.jumps.push_back({after_scan_ ? played_ : played_ + 1, to_scan});
  return part_.jumps.back();
}

std::optional<SE2> SplicedSource::true_pose() const {
  if (!last_known_) return std::nullopt;
  const SE2 T_known_now =
      last_known_->odometry.T_odom_base.inverse() * last_odometry_.odometry.T_odom_base;
  return last_known_->true_pose->T_map_base * T_known_now;
}

Stamp SplicedSource::duration() const { return frames_->back().stamp - frames_->front().stamp; }

Frames all_frames(SensorSource& source) {
  Frames frames;
  while (auto frame = source.next()) frames.push_back(std::move(*frame));
  return frames;
}

Frames splice(const Frames& frames, const Splice& at) {
  if (at.from_first > at.from) throw std::invalid_argument("a splice ends before it begins");
  // The frames outlive the source.
  SplicedSource source(std::shared_ptr<const Frames>(std::shared_ptr<void>(), &frames),
                       {at.from_first, {}, {{at.from - at.from_first + 1, at.to}}});
  Frames part;
  Stamp end = Stamp::max();
  while (auto frame = source.next()) {
    if (frame->stamp > end) break;
    const bool jumped = std::holds_alternative<RunEvent>(frame->data);
    if (jumped && at.window < Stamp::max() - frame->stamp) end = frame->stamp + at.window;
    part.push_back(std::move(*frame));
  }
  return part;
}

}  // namespace castaway::testbed
