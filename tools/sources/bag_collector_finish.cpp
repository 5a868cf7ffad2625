// What takes all messages of a bag: mounts, odometry from /tf, truth, times.
#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "tools/sources/bag_collector.hpp"

namespace castaway::testbed {
namespace {

constexpr Stamp kOneClock = std::chrono::seconds(60);  // Log and stamps further apart are of two.
constexpr Stamp kTruthGap = std::chrono::milliseconds(500);  // Truth is interpolated within it.
constexpr double kTruthJump = 0.5;                           // [m] And not over a kidnap.

/// The stamp that a frame was recorded with; nothing of an event.
std::optional<Stamp> recorded_stamp(const Frame& frame) {
  if (const auto* scan = std::get_if<ScanFrame>(&frame.data)) return scan->scan.stamp;
  if (const auto* odometry = std::get_if<OdometryFrame>(&frame.data)) {
    return odometry->odometry.stamp;
  }
  return std::nullopt;
}

void move_back(Frame& frame, Stamp logged_by, Stamp stamp_by) {
  frame.stamp -= logged_by;
  if (auto* scan = std::get_if<ScanFrame>(&frame.data)) scan->scan.stamp -= stamp_by;
  if (auto* odometry = std::get_if<OdometryFrame>(&frame.data)) {
    odometry->odometry.stamp -= stamp_by;
  }
}

}  // namespace

void BagCollector::mount_the_rest() {
  std::set<std::string> unknown;
  for (const auto& [frame, lidar_frame] : std::exchange(unmounted_, {})) {
    mount(frame, lidar_frame);
    if (!unmounted_.empty() && unmounted_.back().first == frame) unknown.insert(lidar_frame);
  }
  for (const std::string& frame : unknown) {
    recording_.warnings.push_back(fmt::format(
        "{}: no transform from '{}' to '{}'; the lidar is taken to sit in the middle and to look "
        "ahead. Record /tf_static to say where it sits",
        bag_.name, base_frame_, frame));
  }
}

void BagCollector::choose_odometry_edge() {
  if (!topics_.odometry.empty()) return;
  if (odom_edges_.size() == 1) {
    base_frame_ = odom_edges_.begin()->first.second;
    return;
  }
  if (odom_edges_.empty()) {
    throw std::runtime_error(fmt::format(
        "{}: /tf holds no edge from a frame 'odom'; name an Odometry topic by --odom-topic",
        bag_.name));
  }
  std::string edges;
  for (const auto& [edge, readings] : odom_edges_) {
    edges += fmt::format("{}{} -> {}", edges.empty() ? "" : ", ", edge.first, edge.second);
  }
  throw std::runtime_error(
      fmt::format("{}: /tf holds {} edges that could be odometry ({}); record an Odometry topic "
                  "and name it by --odom-topic",
                  bag_.name, odom_edges_.size(), edges));
}

/// Puts odometry of /tf where it came among the other frames: at one log time, too.
void BagCollector::insert_odometry() {
  if (odom_edges_.empty()) return;
  Frames merged;
  std::size_t next = 0;
  const auto move_up_to = [&](std::size_t end) {
    for (; next < end; ++next) merged.push_back(std::move(recording_.frames[next]));
  };
  for (const TfReading& reading : odom_edges_.begin()->second) {
    move_up_to(reading.before);
    Frame& frame = merged.emplace_back();
    frame.stamp = reading.logged;
    frame.data = OdometryFrame{{reading.stamp, reading.T_odom_base}, std::nullopt};
  }
  move_up_to(recording_.frames.size());
  recording_.frames = std::move(merged);
}

std::optional<SE2> BagCollector::truth_at(Stamp stamp) const {
  const auto after = truth_.lower_bound(stamp);
  if (after == truth_.end()) return std::nullopt;
  if (after->first == stamp) return after->second;
  if (after == truth_.begin()) return std::nullopt;
  const auto before = std::prev(after);
  const Stamp gap = after->first - before->first;
  if (gap > kTruthGap || localization::distance(before->second, after->second) > kTruthJump) {
    return std::nullopt;
  }
  const double fraction = seconds(stamp - before->first) / seconds(gap);
  return localization::interpolate(before->second, after->second, fraction);
}

void BagCollector::add_truth() {
  for (Frame& frame : recording_.frames) {
    if (auto* odometry = std::get_if<OdometryFrame>(&frame.data)) {
      odometry->T_map_base_true = truth_at(odometry->odometry.stamp);
    } else if (auto* scan = std::get_if<ScanFrame>(&frame.data)) {
      const auto exact = scan_truth_.find(scan->scan.stamp);
      scan->T_map_base_true =
          exact != scan_truth_.end() ? std::optional(exact->second) : truth_at(scan->scan.stamp);
    }
  }
}

void BagCollector::set_times() {
  Stamp first = Stamp::max();
  Stamp least_delay = Stamp::max();
  for (const Frame& frame : recording_.frames) {
    const std::optional<Stamp> stamp = recorded_stamp(frame);
    if (!stamp) continue;
    first = std::min(first, *stamp);
    least_delay = std::min(least_delay, frame.stamp - *stamp);
  }
  const Stamp time_0 = named_time_0().value_or(first);
  const bool one_clock = least_delay < kOneClock && least_delay > -kOneClock;
  const Stamp logged_by = one_clock ? time_0 : time_0 + least_delay;
  for (Frame& frame : recording_.frames) move_back(frame, logged_by, time_0);
  std::stable_sort(recording_.frames.begin(), recording_.frames.end(),
                   [](const Frame& a, const Frame& b) { return a.stamp < b.stamp; });
}

BagRecording BagCollector::finish() {
  choose_odometry_edge();
  mount_the_rest();
  insert_odometry();
  const auto holds = [&](auto kind) {
    return std::any_of(recording_.frames.begin(), recording_.frames.end(), [](const Frame& frame) {
      return std::holds_alternative<decltype(kind)>(frame.data);
    });
  };
  if (!holds(ScanFrame{}) || !holds(OdometryFrame{})) {
    throw std::runtime_error(fmt::format("{}: holds no {} before it ends", bag_.name,
                                         holds(ScanFrame{}) ? "odometry" : "scan"));
  }
  add_truth();
  set_times();
  return std::move(recording_);
}

}  // namespace castaway::testbed
