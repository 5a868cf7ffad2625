#include "tools/build/bag/bag_clocks.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "castaway/stamp.hpp"

namespace castaway::testbed {
namespace {

constexpr double kSameClock = 0.15;  // [s] Drivers and networks delay messages by less.

const LaserScan* scan_in(const Frame& frame) {
  const auto* scan = std::get_if<ScanFrame>(&frame.data);
  return scan != nullptr ? &scan->scan : nullptr;
}

/// [s] From the measurement of the last beam to the log time.
double delay_of(const Frame& frame, const LaserScan& scan) {
  const std::size_t last = scan.ranges.empty() ? 0 : scan.ranges.size() - 1;
  return localization::seconds(frame.stamp - scan.beam_stamp(last));
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Finds times that a stream of stamps tells again.
class Repeats {
 public:
  /// True if `stamp` is earlier than one before.
  bool take(Stamp stamp) {
    if (!newest_ || stamp >= *newest_) {
      newest_ = stamp;
      return false;
    }
    ++count_;
    farthest_ = std::max(farthest_, *newest_ - stamp);
    return true;
  }
  [[nodiscard]] std::string warning(const std::string& bag, const std::string& what) const {
    return fmt::format(
        "{}: {} of {} stamped earlier than one before, by up to {:.3f} s; a time that is told "
        "twice "
        "is played once",
        bag, count_ == 1 ? "1 message" : fmt::format("{} messages", count_),
        what + (count_ == 1 ? " is" : " are"), localization::seconds(farthest_));
  }
  [[nodiscard]] bool any() const { return count_ > 0; }

 private:
  std::optional<Stamp> newest_;
  Stamp farthest_{};
  int count_ = 0;
};

std::string lidar_text(const std::string& lidar) {
  return lidar.empty() ? "the lidar" : "lidar '" + lidar + "'";
}

std::string offset_warning(const std::string& bag, const std::string& lidar, double ahead) {
  return fmt::format(
      "{}: scans of {} are stamped {:.2f} s {} odometry, by their log times; --clock-offset {:.2f} "
      "corrects it{}",
      bag, lidar_text(lidar), std::abs(ahead), ahead > 0.0 ? "ahead of" : "behind", ahead,
      ahead > 0.0 ? "" : ", unless the scans were only recorded late");
}

}  // namespace

std::vector<std::string> remove_repeated_times(const std::string& bag, Frames& frames) {
  std::map<std::string, Repeats> lidars;
  Repeats odometry;
  std::erase_if(frames, [&](const Frame& frame) {
    if (const LaserScan* scan = scan_in(frame)) return lidars[scan->lidar].take(scan->stamp);
    const auto* reading = std::get_if<OdometryFrame>(&frame.data);
    return reading != nullptr && odometry.take(reading->odometry.stamp);
  });
  std::vector<std::string> warnings;
  if (odometry.any()) warnings.push_back(odometry.warning(bag, "odometry"));
  for (const auto& [lidar, repeats] : lidars) {
    if (repeats.any()) warnings.push_back(repeats.warning(bag, lidar_text(lidar)));
  }
  return warnings;
}

std::vector<std::string> warn_of_clocks(const std::string& bag, const Frames& frames) {
  std::map<std::string, std::vector<double>> lidars;
  std::vector<double> odometry;
  for (const Frame& frame : frames) {
    if (const LaserScan* scan = scan_in(frame)) {
      lidars[scan->lidar].push_back(delay_of(frame, *scan));
    } else if (const auto* reading = std::get_if<OdometryFrame>(&frame.data)) {
      odometry.push_back(localization::seconds(frame.stamp - reading->odometry.stamp));
    }
  }
  std::vector<std::string> warnings;
  if (odometry.empty()) return warnings;
  const double odometry_delay = median(std::move(odometry));
  for (auto& [lidar, delays] : lidars) {
    const double ahead = odometry_delay - median(std::move(delays));
    if (std::abs(ahead) >= kSameClock) warnings.push_back(offset_warning(bag, lidar, ahead));
  }
  return warnings;
}

void shift_scans(double offset, Frames& frames) {
  for (Frame& frame : frames) {
    if (auto* scan = std::get_if<ScanFrame>(&frame.data)) {
      scan->scan.stamp -= localization::from_seconds(offset);
    }
  }
}

void await_odometry(Frames& frames) {
  const Stamp slack = localization::from_seconds(kSameClock);
  std::optional<Stamp> newest;
  std::vector<Frame*> waiting;
  for (Frame& frame : frames) {
    if (const auto* reading = std::get_if<OdometryFrame>(&frame.data)) {
      newest = std::max(newest.value_or(reading->odometry.stamp), reading->odometry.stamp);
      std::erase_if(waiting, [&](Frame* early) {
        if (scan_in(*early)->stamp > *newest) return false;
        early->stamp = frame.stamp + Stamp(1);
        return true;
      });
    } else if (const LaserScan* scan = scan_in(frame)) {
      if (newest && scan->stamp > *newest + slack) waiting.push_back(&frame);
    }
  }
  std::stable_sort(frames.begin(), frames.end(),
                   [](const Frame& a, const Frame& b) { return a.stamp < b.stamp; });
}

}  // namespace castaway::testbed
