#include "tools/build/bag/bag_times.hpp"

#include <algorithm>
#include <charconv>

namespace castaway::testbed {
namespace {

constexpr Stamp kOneClock = std::chrono::seconds(60);  // Log times and stamps further apart are
                                                       // from different clocks.

/// The recorded stamp of a frame; nothing for an event.
std::optional<Stamp> recorded_stamp(const Frame& frame) {
  if (const auto* scan = std::get_if<ScanFrame>(&frame.data)) return scan->scan.stamp;
  if (const auto* odometry = std::get_if<OdometryFrame>(&frame.data)) {
    return odometry->odometry.stamp;
  }
  if (const auto* imu = std::get_if<ImuFrame>(&frame.data)) return imu->imu.stamp;
  return std::nullopt;
}

void move_back(Frame& frame, Stamp logged_by, Stamp stamp_by) {
  frame.stamp -= logged_by;
  if (auto* scan = std::get_if<ScanFrame>(&frame.data)) scan->scan.stamp -= stamp_by;
  if (auto* odometry = std::get_if<OdometryFrame>(&frame.data)) {
    odometry->odometry.stamp -= stamp_by;
  }
  if (auto* imu = std::get_if<ImuFrame>(&frame.data)) imu->imu.stamp -= stamp_by;
}

}  // namespace

std::optional<Stamp> time_0_of(const BagInventory& bag) {
  const auto run = bag.metadata.find("run");
  if (run == bag.metadata.end()) return std::nullopt;
  const auto found = run->second.find("time_0_ns");
  if (found == run->second.end()) return std::nullopt;
  std::int64_t ns = 0;
  const std::string& text = found->second;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), ns);
  const bool good = result.ec == std::errc{} && ns >= 0 && ns <= kLatestBagTime;
  return good ? std::optional(Stamp(ns)) : std::nullopt;
}

void set_times(const std::optional<Stamp>& time_0, Frames& frames) {
  Stamp first = Stamp::max();
  Stamp least_delay = Stamp::max();
  for (const Frame& frame : frames) {
    const std::optional<Stamp> stamp = recorded_stamp(frame);
    if (!stamp) continue;
    first = std::min(first, *stamp);
    least_delay = std::min(least_delay, frame.stamp - *stamp);
  }
  const Stamp begin = time_0.value_or(first);
  const bool one_clock = least_delay < kOneClock && least_delay > -kOneClock;
  const Stamp logged_by = one_clock ? begin : begin + least_delay;
  for (Frame& frame : frames) move_back(frame, logged_by, begin);
  std::stable_sort(frames.begin(), frames.end(),
                   [](const Frame& a, const Frame& b) { return a.stamp < b.stamp; });
}

}  // namespace castaway::testbed
