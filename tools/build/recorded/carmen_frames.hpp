/// Converts messages of a CARMEN log to frames.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tools/base/formats/carmen_log.hpp"
#include "tools/build/recorded/carmen_source.hpp"

namespace castaway::testbed {

/// Takes the messages of a log in order and keeps the frames to play.
class CarmenFrames {
 public:
  explicit CarmenFrames(const CarmenSourceConfig& config) : config_(config) {}

  void add(const CarmenMessage& message);
  /// True once all requested scans have been read, with their truth.
  [[nodiscard]] bool complete() const;
  [[nodiscard]] std::vector<Frame> take() { return std::move(frames_); }
  [[nodiscard]] std::int64_t repaired_stamps() const { return repaired_stamps_; }

 private:
  void add_odometry(double time_s, const SE2& T_odom_base);
  void add_laser(const CarmenLaser& laser);
  void add_truth(const CarmenTruth& truth);
  [[nodiscard]] bool all_played() const;
  [[nodiscard]] bool is_selected(std::int64_t scan) const;
  [[nodiscard]] LaserScan make_scan(const CarmenLaser& laser, Stamp stamp) const;
  [[nodiscard]] double param(const std::string& name, double fallback) const;
  Stamp monotonic(double time_s);

  CarmenSourceConfig config_;
  std::map<std::string, std::string> params_;
  std::vector<Frame> frames_;
  std::optional<double> first_time_s_;
  Stamp last_stamp_{};
  std::int64_t scans_seen_ = 0;
  std::int64_t scans_played_ = 0;
  std::size_t frames_of_last_scan_ = 0;  // At the end of `frames_`; 0 if the newest message was not
                                         // a scan.
  std::int64_t repaired_stamps_ = 0;
};

}  // namespace castaway::testbed
