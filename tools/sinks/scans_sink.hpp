/// scans.csv and labels.csv: every beam of a run.
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>

#include "tools/formats/csv.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// scans.csv: a row for every scan in order of delivery: stamp_s (of the first beam, as told);
/// lidar; frame; angle_min_rad; angle_increment_rad; time_increment_s; x_m, y_m, yaw_rad (true pose
/// of base when it was taken); ranges_m, intensities, labels: as many numbers as there are beams,
/// with spaces between. Ranges: inf no return, -inf too close.
///
/// labels.csv: label, name of all labels that occur.
class ScansSink final : public RunSink {
 public:
  /// `name`: what a label means.
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
