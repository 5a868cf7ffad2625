/// people.csv: poses of people over time.
#pragma once

#include <filesystem>
#include <optional>

#include "tools/base/formats/csv.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// Writes a row for every person at the first scan of every period of `every_s` seconds: stamp_s;
/// id; x_m, y_m, yaw_rad (heading); vx_mps, vy_mps; gap_m (from the robot's outline to the body).
class PeopleSink final : public RunSink {
 public:
  /// `every_s` [s]: above 0.
  PeopleSink(const std::filesystem::path& run_folder, double every_s);

  void on_event(const RunEvent&) override {}
  void on_odometry(const OdometryFrame&) override {}
  void on_scan(const ScanRecord& record) override;
  void finish(Stamp, const RunTiming&) override { csv_.commit(); }

 private:
  CsvWriter csv_;
  Stamp period_;
  std::optional<Stamp> next_;
};

}  // namespace castaway::testbed
