/// scans.csv and labels.csv: every beam of a run.
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>

#include "tools/base/formats/csv.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// scans.csv: a row for every scan in order of delivery: stamp_s (of the first beam, as the robot
/// sees it); lidar; frame; angle_min_rad; angle_increment_rad; time_increment_s; x_m, y_m, yaw_rad
/// (true pose of base at the time of the scan); ranges_m, intensities, labels: one number per beam,
/// separated by spaces. Ranges: inf is no return, -inf too close.
///
/// labels.csv: columns label and name, for all labels that occur.
class ScansSink final : public RunSink {
 public:
  /// `name` returns the meaning of a label.
  ScansSink(const std::filesystem::path& run_folder, std::function<std::string(int)> name);

  void on_event(const RunEvent&) override {}
  void on_odometry(const OdometryFrame&) override {}
  void on_scan(const ScanRecord& record) override;
  void finish(Stamp, const RunTiming&) override;

 private:
  CsvWriter scans_;
  CsvWriter names_;
  std::function<std::string(int)> name_;
  std::set<int> labels_;
};

}  // namespace castaway::testbed
