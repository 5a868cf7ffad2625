/// errors.csv: a row per scan and localizer.
#pragma once

#include <filesystem>

#include "tools/base/formats/csv.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// Columns: stamp_s; localizer; true_x_m, true_y_m, true_yaw_rad; x_m, y_m, yaw_rad (estimate);
/// position_error_m; yaw_error_rad; quality; sigma_m (sqrt((var_x + var_y) / 2)); sigma_yaw_rad;
/// probability; lost (0, 1); populations; particles (of all populations); selected (id of the
/// population that is the output). Unknown values are empty. In a run on several floors,
/// position_error_m has three dimensions, and true_z_m, z_m and level (of the estimate) follow.
class ErrorsSink final : public RunSink {
 public:
  explicit ErrorsSink(const std::filesystem::path& run_folder, const RunInfo& info = {});

  void on_event(const RunEvent&) override {}
  void on_odometry(const OdometryFrame&) override {}
  void on_scan(const ScanRecord& record) override;
  void finish(Stamp, const RunTiming&) override { csv_.commit(); }

 private:
  CsvWriter csv_;
  bool heights_;
};

}  // namespace castaway::testbed
